// All kernels as C++, for one instruction set: LINEATLAS_INSTRUCTION_SET names the namespace, and
// CMake sets the compiler's options. With LINEATLAS_COUNTED floats count operations.
#include <cstdint>
#include <utility>

// Kernels are OpenCL C. Some do not use all functions of a header or all of their arguments.
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "host_kernels.hpp"

#ifdef LINEATLAS_COUNTED
#include "counted_float.hpp"
#define PLAIN_FLOAT(v) (v).value
#define float lineatlas::compute::CountedFloat
#endif

#include "flags.h"
#include "segment_table.h"
#include "shared/constants.h"
#include "shared/meshlet_table.h"
#include "style_numbers.h"

namespace lineatlas::compute::LINEATLAS_INSTRUCTION_SET {

#include "opencl_c.hpp"

#include "kernels.h"

#include "shared/atlas_samples.h"
#include "shared/batches.h"
#include "shared/clipping.h"
#include "shared/exact.h"
#include "shared/float_pair.h"
#include "shared/own_face.h"
#include "shared/run.h"
#include "shared/screen_box.h"
#include "shared/silhouette.h"
#include "visible_parts.h"

// The form of a CPU: several probes, or lines, at once.
#define HALO_LANES 16
#define PROBE_VECTORS 1
// As many as the instruction set holds: g++ 12 takes wider vectors apart into single numbers.
#if defined(__AVX512F__)
#define FACE_LANES 16
#elif defined(__AVX2__)
#define FACE_LANES 8
#else
#define FACE_LANES 4
#endif

// A vector of texels is as long as small triangles are wide.
#if defined(__AVX2__)
#define DEPTH_LANES 8
#else
#define DEPTH_LANES 4
#endif
#define DEPTH_TILE 240 // as Tuning::depth_tile
#define LONG_ATOMICS 1

// Each file of kernels is in a namespace of its own. CMake lists the files with one form.
#include "kernel_files.hpp"

#define NUMBERED
namespace in_numbered_depth {
#undef LANES
#undef LANES_IN_USE
#include "depth.cl"
} // namespace in_numbered_depth
#undef NUMBERED

#define SCAN_SATURATE 0
namespace in_scan_0 {
#include "scan.cl"
}
#undef SCAN_SATURATE
#undef SCAN_ADD
#define SCAN_SATURATE 1
namespace in_scan_1 {
#include "scan.cl"
}

#define PROBES_PER_AXIS 1
#include "atlas_variants.hpp"
#define PROBES_PER_AXIS 2
#include "atlas_variants.hpp"
#define PROBES_PER_AXIS 3
#include "atlas_variants.hpp"
#define PROBES_PER_AXIS 4
#include "atlas_variants.hpp"

namespace {

template <auto kernel>
struct Form;

template <class Parameters, class... Tables,
          void (*kernel)(WorkItem, const Parameters&, Tables*...)>
struct Form<kernel> {
    static void run(const void* parameters, void* const* tables, size_t first, size_t last,
                    size_t count) {
        run(parameters, tables, first, last, count, std::index_sequence_for<Tables...>{});
    }
    template <size_t... i>
    static void run(const void* parameters, void* const* tables, size_t first, size_t last,
                    size_t count, std::index_sequence<i...>) {
        const Parameters args = *static_cast<const Parameters*>(parameters);
        for (size_t id = first; id < last; ++id) {
            kernel({id, count}, args, static_cast<Tables*>(tables[i])...);
        }
    }
};

#ifdef LINEATLAS_LEAN
/// Whether LineVisibility launches kernels of a stage. A lean build has only those.
constexpr bool is_built(const char* stage) {
    constexpr const char* others[] = {"atlas",  "carry",   "compact", "cull",    "density",
                                      "depth",  "fill",    "filter",  "halo",    "pens",
                                      "planes", "pyramid", "strokes", "temporal"};
    for (const char* other : others)
        if (__builtin_strcmp(other, stage) == 0) return false;
    return true;
}
#else
constexpr bool is_built(const char*) {
    return true;
}
#endif
#define RUN(stage, kernel)                                                                         \
    (is_built(#stage) ? static_cast<HostFunction>(Form<kernel>::run) : nullptr)
#define FORM(stage, name, Parameters) {#name, "", RUN(stage, in_##stage::name)},
#define SUM_FORMS(stage, name, Parameters)                                                         \
    {#name, "-DSCAN_SATURATE=0", Form<in_scan_0::name>::run},                                      \
        {#name, "-DSCAN_SATURATE=1", Form<in_scan_1::name>::run},
#define PROBE_FORMS(stage, name, Parameters)                                                       \
    {#name, "-DPROBES_PER_AXIS=1", RUN(stage, in_atlas_1::name)},                                  \
        {#name, "-DPROBES_PER_AXIS=2", RUN(stage, in_atlas_2::name)},                              \
        {#name, "-DPROBES_PER_AXIS=3", RUN(stage, in_atlas_3::name)},                              \
        {#name, "-DPROBES_PER_AXIS=4", RUN(stage, in_atlas_4::name)},                              \
        {#name, "-DPROBES_PER_AXIS=1 -DTILED", RUN(stage, in_tiled_atlas_1::name)},                \
        {#name, "-DPROBES_PER_AXIS=2 -DTILED", RUN(stage, in_tiled_atlas_2::name)},                \
        {#name, "-DPROBES_PER_AXIS=3 -DTILED", RUN(stage, in_tiled_atlas_3::name)},                \
        {#name, "-DPROBES_PER_AXIS=4 -DTILED", RUN(stage, in_tiled_atlas_4::name)},
#define NUMBER_FORMS(stage, name, Parameters)                                                      \
    {#name, "", RUN(stage, in_##stage::name)},                                                     \
        {#name, "-DNUMBERED", RUN(stage, in_numbered_##stage::name)},
#define NO_FORM(stage, name, Parameters) // needs barriers

constexpr HostKernel forms[] = {LA_KERNELS(FORM, SUM_FORMS, NO_FORM, NUMBER_FORMS, PROBE_FORMS)};

} // namespace

std::span<const HostKernel> kernels() {
    return forms;
}

extern const std::uint32_t depth_lanes = DEPTH_LANES;

#ifndef LINEATLAS_COUNTED
std::uint64_t multiply_and_add(std::uint64_t rounds, float& result) {
    // Enough chains to hide that each waits for its last sum.
    constexpr int chains = 8, lanes = 16;
    using Lanes = LanesOf<float, lanes>;
    Lanes sums[chains];
    for (int i = 0; i < chains; ++i) sums[i] = Lanes{static_cast<float>(i)};
    const Lanes factor{0.999F}, addend{result};
    for (std::uint64_t round = 0; round < rounds; ++round)
        for (Lanes& sum : sums) sum = sum * factor + addend;
    for (const Lanes& sum : sums) result += largest_of_lanes(sum);
    return rounds * chains * lanes * 2;
}
#endif

} // namespace lineatlas::compute::LINEATLAS_INSTRUCTION_SET
