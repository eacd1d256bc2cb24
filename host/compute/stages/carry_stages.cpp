// Texture coordinates of silhouettes, from frame to frame.
#include <cmath>

#include "stages.hpp"

namespace lineatlas::compute {

namespace {

struct Origins {
    Buffer& origins;
};

} // namespace

void Stages::carry(const CarryArgs& args) {
    const std::uint32_t n = args.count;
    const CarryParameters parameters{
        .count = n,
        .first = args.first,
        .viewport = args.viewport,
        .frame = args.frame,
        .limit = static_cast<la_uint>(std::floor(args.limit * LA_ARC_UNITS_PER_PIXEL))};
    const Origins origins{*args.table.origins};
    launch<kernels::carry_recall>(n, parameters, args.table, args.clipped, args, origins);
    scan(args.lengths, n, ScanKind::wrap);
    launch<kernels::carry_keep>(n, parameters, args.table, args);
    scan(args.kept, n, ScanKind::saturate);
    launch_each<kernels::scan_list>(n, {.values = args.kept, .list = args.list});
    launch<kernels::carry_breaks>(n, parameters, args.table, args);
    scan(args.breaks, n, ScanKind::saturate);
    scan(args.means, n, ScanKind::wrap);
    launch<kernels::carry_pieces>(n, parameters, args);
    launch<kernels::carry_settle>(n, parameters, args);
    launch<kernels::carry_place>(n, parameters, args.table, args.clipped, args, origins);
}

} // namespace lineatlas::compute
