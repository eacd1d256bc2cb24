#pragma once

#include "assembly_state.hpp"
#include "clusters.hpp"
#include "meshlets.hpp"

namespace lineatlas {

/// The clusters of a part in its rooms of the tables, filled up to the triangles and clusters of
/// the rooms. part: the part by itself; without triangles if it was removed.
TriangleClusters part_clusters(std::uint32_t object, const PartRooms& rooms, const LineSet& part);

/// The clusters of all parts, with the room between them.
TriangleClusters all_part_clusters(const AssemblyState& parts);

/// The meshlets of part_clusters(), spread out.
Meshlets part_meshlets(const PartRooms& rooms, const TriangleClusters& clusters);

/// The same meshlets, numbered from `first` on. Each list gets the room of the largest possible
/// one, so that other meshlets can take its place.
Meshlets spread_out(const Meshlets& meshlets, std::uint32_t first);

} // namespace lineatlas
