// kernels/atlas.cl for PROBES_PER_AXIS, whole and TILED; undefines its macros at the end.
#define VARIANT_OF(name, probes) name##probes
#define VARIANT(name, probes) VARIANT_OF(name, probes)
#define WHOLE VARIANT(in_atlas_, PROBES_PER_AXIS)
#define IN_TILES VARIANT(in_tiled_atlas_, PROBES_PER_AXIS)

namespace WHOLE {
#undef LANES
#undef LANES_IN_USE
#include "atlas.cl"
#undef PROBES
} // namespace WHOLE
#define TILED
namespace IN_TILES {
#undef LANES
#undef LANES_IN_USE
#include "atlas.cl"
#undef PROBES
} // namespace IN_TILES
#undef TILED
#undef IN_TILES
#undef WHOLE
#undef VARIANT
#undef VARIANT_OF
#undef PROBES_PER_AXIS
