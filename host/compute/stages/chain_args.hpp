#pragma once

// Arguments of stages that find silhouettes and put them in chains.

#include <cstdint>

#include <glm/vec4.hpp>

#include "table_room.hpp"
#include "tables.hpp"

namespace lineatlas::compute {

/// The tables of the stages that find silhouettes, see kernels/chain.cl for what each holds.
struct ChainTables {
    Device* device;
    Table front{*device, table::chain_front}; ///< a byte per triangle: whether it faces the eye
    /// For contours whether faces are crossed. Then for each candidate that may be a silhouette the
    /// number of silhouettes before it, and the number of all.
    Table numbers{*device, table::chain_numbers};
    Table positions{*device, table::chain_positions}; ///< a uint32 per candidate
    Table ordered{*device, table::chain_ordered}; ///< `Segment` each, from the first fixed one on
    Table chosen{*device, table::chain_chosen};   ///< a uint32 per silhouette
    Table ways{*device, table::chain_ways};       ///< scratch: two `ChainWay` per silhouette
    Table longer{*device, table::chain_longer};   ///< scratch: the same
    Table going{*device, table::chain_going};   ///< scratch: a uint32 for each of most_chain_steps
    Table places{*device, table::chain_places}; ///< scratch: `ChainPlace` per silhouette
    Table starts{*device, table::chain_starts}; ///< scratch: a uint32 per silhouette and one more
    Table origins{*device, table::chain_origins}; ///< a uint32 per silhouette, in their new order
    /// Vertices of the mesh, then four places of three floats per silhouette; without contours no
    /// room.
    Table vertices{*device, table::contour_vertices};
};

/// Where silhouettes are seen from.
struct SilhouetteView {
    glm::vec4 eye;     ///< Camera::eye()
    bool from_outside; ///< see sees_from_outside()
};

/// The silhouettes of a frame as paths.
struct ChainArgs {
    SegmentTable table; ///< if it has contours, with ChainTables::vertices
    SilhouetteView view;
    /// Contours are drawn at the lifted places, where their visibility is tested.
    bool lifted;
    std::uint32_t count; ///< silhouettes, above 0
    const ChainTables& tables;
    Buffer* crossings = nullptr; ///< `ContourCrossing` per silhouette; null: no contours
    /// `positions` of the frame before, from which chains keep names and directions; null: there is
    /// none.
    Buffer* positions_before = nullptr;
};

/// Steps in which the ways of any number of silhouettes get to their ends.
inline constexpr std::uint32_t most_chain_steps = 34;

} // namespace lineatlas::compute
