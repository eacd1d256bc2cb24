#pragma once

// Arguments of the stage that carries texture coordinates over from frame to frame.

#include <cstdint>

#include <glm/vec2.hpp>

#include "tables.hpp"

namespace lineatlas::compute {

/// The silhouettes of a frame, see kernels/carry.cl for what each table holds.
struct CarryArgs {
    SegmentTable table;  ///< with origins
    std::uint32_t first; ///< first segment that is a silhouette
    std::uint32_t count; ///< of them, above 0
    ClippedTable clipped;
    glm::vec2 viewport;  ///< pixels
    std::uint32_t frame; ///< number of this frame, above 1
    float limit;         ///< pixels by which a coordinate may shift; 0: none may
    Buffer& memory;      ///< in: of the frame before; out: of this one; LA_MEMORY_WORDS uint32 per
                         ///< candidate, 0 at first
    Buffer& lengths;     ///< scratch: a uint32 per silhouette and one more, as the next four
    Buffer& found;
    Buffer& kept;
    Buffer& breaks;
    Buffer& means;
    Buffer& recalled; ///< scratch: two uint32 per silhouette
    Buffer& list;     ///< scratch: a uint32 per silhouette
    Buffer& pieces;   ///< scratch: a uint32 per silhouette and one more
    Buffer& shifts;   ///< scratch: a uint32 per silhouette
    Buffer& carried;  ///< out: two int32 per silhouette, 1/256 pixels
};

} // namespace lineatlas::compute
