#pragma once

#include "assembly_state.hpp"
#include "clusters.hpp"
#include "meshlets.hpp"

namespace lineatlas {

/// The clusters of a part in its room of the tables, filled up to as many triangles and clusters as
/// there is room for. `part`: the part by itself; without triangles if it was removed.
TriangleClusters part_clusters(std::uint32_t object, const PartRooms& rooms, const LineSet& part);

/// Those of all parts, with the room between them.
TriangleClusters all_part_clusters(const AssemblyState& parts);

/// The meshlets of part_clusters(), spread out.
Meshlets part_meshlets(const PartRooms& rooms, const TriangleClusters& clusters);

/// The same meshlets, which stand from number `first` on, with lists that each have the room of the
/// largest there may be: so that others can come in their place.
Meshlets spread_out(const Meshlets& meshlets, std::uint32_t first);

} // namespace lineatlas
