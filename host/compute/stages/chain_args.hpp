#pragma once

// Arguments of stages that find silhouettes and put them in chains.

#include <cstdint>

#include <glm/vec4.hpp>

#include "tables.hpp"

namespace lineatlas::compute {

struct FacingArgs {
    SegmentTable table;
    glm::vec4 eye; ///< Camera::eye()
    Buffer& front; ///< out: a byte per triangle
};

/// Arguments for finding the faces that contours cross.
struct ContourArgs {
    ContourTables contours;
    Buffer& vertices;           ///< of the mesh
    glm::vec4 eye;              ///< Camera::eye()
    std::uint32_t first_number; ///< SilhouetteCandidates::kept_edges()
    Buffer& numbers;            ///< out, from there on: for SilhouetteArgs::numbers
};

/// Arguments for finding where contours cross faces.
struct ContourPlacesArgs {
    SegmentTable table; ///< with contours; `vertices` out, behind those of the mesh: four places of
                        ///< three floats per silhouette
    glm::vec4 eye;      ///< that of ContourArgs, of the last such call
    Buffer& front;      ///< of `facing`
    Buffer& numbers;    ///< of `silhouette`
    Buffer& chosen;     ///< of `silhouette_list`
    std::uint32_t count; ///< silhouettes
    bool on_surface;     ///< see SilhouetteChains::Contours
    Buffer& crossings;   ///< out: `ContourCrossing` per silhouette
};

/// Where silhouettes are seen from.
struct SilhouetteView {
    glm::vec4 eye;     ///< Camera::eye()
    bool from_outside; ///< see sees_from_outside()
};

/// Which candidates are silhouettes.
struct SilhouetteArgs {
    SegmentTable table;
    Buffer& front; ///< of `facing`
    /// In: for contours the numbers of `contour`. Out: for each candidate that may be a silhouette
    /// the number of silhouettes before it, then the number of all.
    Buffer& numbers;
};

/// Arguments for listing silhouettes.
struct SilhouetteListArgs {
    SilhouetteCandidates candidates;
    Buffer& numbers;   ///< of `silhouette`
    Buffer& chosen;    ///< out: a uint32 per silhouette
    Buffer& positions; ///< out: a uint32 per candidate
};

/// The silhouettes of a frame as paths: see kernels/chain.cl for what each table holds.
struct ChainArgs {
    SegmentTable table;
    Buffer* crossings; ///< of `contour_places`; null without contours
    /// Contours are drawn at the lifted places, where their visibility is tested.
    bool lifted;
    SilhouetteView view;
    Buffer& numbers;     ///< of `silhouette`
    std::uint32_t count; ///< silhouettes, above 0
    Buffer& chosen;      ///< of `silhouette_list`
    Buffer& ways;        ///< scratch: two `ChainWay` per silhouette
    Buffer& longer;      ///< scratch: the same
    Buffer& going;       ///< scratch: a uint32 for each of most_chain_steps
    Buffer& places;      ///< scratch: `ChainPlace` per silhouette
    Buffer& starts;      ///< scratch: a uint32 per silhouette and one more
    Buffer& ordered;     ///< out: `Segment` each, from candidates.first on
    Buffer& origins;     ///< out: a uint32 per silhouette, in their new order
    Buffer& positions;   ///< in: as `silhouette_list` has them; out: a uint32 per candidate
    /// `positions` of the frame before, from which chains keep names and directions; null: there is
    /// none.
    Buffer* positions_before = nullptr;
};
/// Steps in which the ways of any number of silhouettes get to their ends.
inline constexpr std::uint32_t most_chain_steps = 34;

} // namespace lineatlas::compute
