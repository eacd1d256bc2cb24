#pragma once

// Tables that the stages of a frame pass on to each other.

#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>

#include "compute/kernels.hpp"
#include "segment_table.h"

namespace lineatlas::compute {

constexpr std::uint32_t divide_up(std::uint32_t n, std::uint32_t by) {
    return n / by + (n % by != 0 ? 1 : 0);
}

/// Where silhouettes of smooth surfaces may run: LineSet::contours on the device.
struct ContourTables {
    Buffer* corners = nullptr;      ///< `ContourCorner` each
    Buffer* edges = nullptr;        ///< `ContourEdge` each
    Buffer* face_corners = nullptr; ///< 3 uint32 each: corners
    Buffer* faces = nullptr;        ///< `ContourFace` each
    Buffer* patches = nullptr; ///< per triangle a uint32: of which surface it is, or LA_NO_SURFACE
    std::uint32_t edge_count = 0;
    std::uint32_t face_count = 0;   ///< the last candidates
    std::uint32_t replaced = 0;     ///< candidates before them that contours stand for
    std::uint32_t vertex_count = 0; ///< of the mesh
};

/// Segments that are drawn only if they are silhouettes, the last ones of a table.
struct SilhouetteCandidates {
    std::uint32_t first = 0; ///< in the segment table
    std::uint32_t count = 0;
    /// Per vertex a uint32: where its part of `ends` begins, and one more; null if there are none.
    Buffer* end_offsets = nullptr;
    Buffer* ends = nullptr; ///< 2 uint32 per candidate: 2 i + end, by the vertex there
    std::optional<ContourTables> contours{};

    /// The number of candidates that are edges of the mesh and that no contour stands for.
    std::uint32_t kept_edges() const { return edges() - (contours ? contours->replaced : 0); }
    /// The number of candidates that may be silhouettes; the others never are.
    std::uint32_t drawable() const { return count - (contours ? contours->replaced : 0); }
    std::uint32_t edges() const { return count - (contours ? contours->face_count : 0); }
};

/// The constant input of the pipeline, as `LineSet` holds it.
struct SegmentTable {
    Buffer& vertices;  ///< 3 floats each
    Buffer& triangles; ///< 3 uint32 each
    Buffer& segments;  ///< `Segment` each
    std::uint32_t triangle_count;
    std::uint32_t segment_count;
    SilhouetteCandidates candidates{};
    /// Where silhouettes of a frame's own table come from, see chain_write. Null: candidates stand
    /// as in the line set.
    Buffer* origins = nullptr;
    /// Counts changes of what the tables hold.
    std::uint64_t version = 0;
};

/// The first segments, or triangles, of a table in batches; see kernels/shared/batches.h.
struct BatchTable {
    Buffer* batches = nullptr; ///< `Batch` each
    Buffer* states = nullptr;  ///< a byte each: LA_BATCH_*, of the current frame
    std::uint32_t count = 0;   ///< segments, or triangles

    std::uint32_t batch_count() const { return divide_up(count, LA_BATCH); }
};

/// `project_clip`'s and `scan`'s results: the clipped segment table.
struct ClippedTable {
    Buffer& clipped; ///< `ClippedSegment` per segment, valid where its window length is not 0
    Buffer& offsets; ///< segment_count + 1 uint32: counts l, after `scan` offsets s and the total
    Buffer& arcs; ///< segment_count + 1 uint32: window lengths, after `scan` arc lengths; 1/256 px
};

/// The segments of a frame and the visibility of their samples.
struct SegmentAtlas {
    ClippedTable clipped;
    Buffer& alpha;          ///< a byte per sample, 0 hidden to 255 visible
    std::uint32_t capacity; ///< samples that `alpha` has room for
};

/// Runs, and how many there are.
struct RunTable {
    Buffer& runs;           ///< `Run` each
    Buffer& record;         ///< one `FrameRecord`: points[0] runs
    std::uint32_t capacity; ///< runs that there is room for
};

/// Where intervals are written.
struct IntervalRoom {
    Buffer& intervals;      ///< `Interval` each; none if there are more than it has room for
    std::uint32_t capacity; ///< of `intervals`
    Buffer& interval_total; ///< one uint32, how many there are
};

/// The surfaces in a depth buffer, for probes that know surfaces.
struct SurfaceTables {
    Buffer& numbers; ///< a uint32 per texel: of a triangle in the order of its clusters, or
                     ///< LA_NO_FACE
    Buffer& planes;  ///< of `planes`
    Buffer& patches; ///< a uint32 per triangle, in the same order: its smooth patch
    bool parallel;   ///< the view
    float bend;      ///< of SurfaceView
};

/// A depth buffer, and how much of it may stand before a line.
struct DepthBuffer {
    /// Floats in [0, 1], rows from the lower left. Not read if surfaces are known.
    Buffer& texels;
    glm::ivec2 size;                         ///< that it holds: viewport times scale, or a tile's
    float scale;                             ///< texels per pixel
    float tolerance;                         ///< window depth that may stand before a line, times w
    std::optional<SurfaceTables> surfaces{}; ///< then own faces are numbers in ClippedTable

    /// The tables for kernels. If surfaces are not known, other tables, which are not read, stand
    /// for theirs.
    struct Tables {
        Buffer &depth, &numbers, &planes, &patches;
    };
    Tables tables() const {
        if (!surfaces) return {texels, texels, texels, texels};
        return {texels, surfaces->numbers, surfaces->planes, surfaces->patches};
    }
    SurfaceParameters surface_parameters() const {
        if (!surfaces) return {.known = 0, .parallel = 0, .bend = 0};
        return {.known = 1, .parallel = surfaces->parallel ? 1U : 0U, .bend = surfaces->bend};
    }
};

} // namespace lineatlas::compute
