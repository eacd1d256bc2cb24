#pragma once

// Arguments of stages that make runs and change them.

#include <algorithm>
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/tiles.hpp"
#include "tables.hpp"

namespace lineatlas::compute {

struct CompactArgs {
    SegmentTable table;
    SegmentAtlas atlas;
    glm::vec2 viewport;  ///< pixels
    float half_width;    ///< of the stroke, in pixels: decides where a join has room
    bool hidden = false; ///< runs of hidden samples instead of visible ones
    RunTable runs;       ///< out
};

/// Gaps beside nearer lines (§4.5).
struct HaloArgs {
    SegmentTable table;
    ClippedTable clipped;
    RunTable runs;      ///< of `compact`
    glm::vec2 viewport; ///< pixels
    float halo;         ///< gap beside the nearer stroke, pixels
    float half_width;   ///< of the nearer stroke, pixels
    float tolerance;    ///< as in DepthBuffer: a line is nearer if it is so by more than that
    Buffer& cuts;       ///< out: `RunCuts` per run
};

/// Changes to visible strokes (§4.5).
struct FilterArgs {
    SegmentTable table;
    SegmentAtlas atlas;  ///< alpha: in and out; samples that become visible get 255
    glm::vec2 viewport;  ///< pixels
    float half_width;    ///< as in CompactArgs
    StrokeFilter filter; ///< what to do
    RunTable runs;       ///< in: of `compact`
    Buffer* cuts;        ///< in: of `halo`; null: none
    RunTable filtered;   ///< out
};

/// Pixels per axis of a cell of the density grid: LA_DENSITY_CELL, or a multiple of it for pictures
/// that would have more than 1024 cells a side. So the grid of a poster takes no more than 64 MiB.
inline int density_cell(glm::vec2 viewport) {
    constexpr int most = 1024 * LA_DENSITY_CELL;
    const int longer = static_cast<int>(std::max(viewport.x, viewport.y));
    return LA_DENSITY_CELL * std::max((longer + most - 1) / most, 1);
}

/// Cells of the density grid per axis.
inline glm::ivec2 density_cells(glm::vec2 viewport) {
    const int cell = density_cell(viewport);
    return (glm::ivec2{viewport} + (cell - 1)) / cell;
}

/// Line density (§4.5): how much of each line is drawn where.
struct DensityArgs {
    SegmentTable table;
    SegmentAtlas atlas;
    RunTable runs;       ///< in and out: each gets the bin of its line's priority
    glm::vec2 viewport;  ///< pixels
    Density density;     ///< limit and priorities
    glm::vec4 focus;     ///< centre x and y, radius and falloff in pixels; falloff 0: no focus
    float far_limit;     ///< factor of the limit far from the focus
    bool hidden = false; ///< runs are of hidden lines
    /// `grid` of the chunks before, if segments come in chunks; empty for the first chunk.
    std::span<const std::uint32_t> drawn_before{};
    Buffer& grid; ///< out: drawn length, a uint32 each, LA_DENSITY_BINS planes of density_cells()
    Buffer& weights; ///< out: floats 0 to 1, as many
};

/// Parts of segments that have the background on one side. They may overlap.
struct OutlineTable {
    Buffer& part_offsets; ///< per segment and one more
    Buffer& parts;        ///< two floats each, from and to, in the units of runs
};

/// Arguments for finding outlines among samples, by the depth buffer.
struct OutlineSamplesArgs {
    SegmentTable table;
    ClippedTable clipped;
    std::uint32_t sample_capacity; ///< as in SegmentAtlas
    DepthBuffer depth;
    glm::vec2 viewport;   ///< pixels
    float body;           ///< pixels that a body must be deep on the other side
    Buffer& part_offsets; ///< out: segment_count + 1 uint32
    Buffer& parts;        ///< out: 2 floats each; none if `part_capacity` is too small
    std::uint32_t part_capacity;
};

/// Which pen draws which run.
struct PensArgs {
    SegmentTable table;
    /// A uint32 per segment of the line set: its pen, and from bit 16 the pen of its outline.
    Buffer& segment_pens;
    const OutlineTable* outline; ///< null: nothing is one
    RunTable runs;               ///< in
    RunTable drawn;              ///< out
};

/// Where runs lie on the screen, in their order.
struct StrokeLists {
    Buffer& ends;           ///< out: a uint32 per tile and chunk of runs, and the number of all
    Buffer& entries;        ///< out: uint32 each
    Buffer& total;          ///< out: the number of all, one uint32
    std::uint32_t capacity; ///< of `entries`; beyond it nothing is written
};

/// Tiles of the picture that runs are listed by, and chunks of the runs.
inline glm::ivec2 stroke_tiles(glm::vec2 viewport) {
    return (glm::ivec2{viewport} + (LA_STROKE_TILE - 1)) / LA_STROKE_TILE;
}
std::uint32_t stroke_chunks(const Tuning& tuning, glm::vec2 viewport);
/// Values of StrokeLists::ends.
std::size_t stroke_ends(const Tuning& tuning, glm::vec2 viewport);

struct StrokeListArgs {
    RunTable runs;
    glm::vec2 viewport; ///< pixels
    float half_width;   ///< of the widest pen, pixels
    StrokeLists lists;
};

/// One pen's strokes.
struct StrokeArgs {
    RunTable runs;
    StrokeLists lists; ///< of these runs
    Buffer& alpha;     ///< as in SegmentAtlas
    glm::vec2 viewport;
    PictureTile part; ///< of the picture, what is drawn
    float half_width; ///< pixels
    float opacity;
    std::uint32_t end_kinds;         ///< LA_STROKES_*
    bool hidden = false;             ///< runs of hidden samples
    std::uint32_t pen = LA_ALL_PENS; ///< the pen whose runs are drawn
    Buffer* mark = nullptr; ///< floats along the mark, the last before the first and the first
                            ///< behind the last; null: solid
    std::uint32_t mark_length = 0;      ///< values of the mark, without the two at its ends
    float repeat_length = 1;            ///< pixels
    Buffer* weights = nullptr;          ///< of `density`; null: all is drawn
    bool again = false;                 ///< draws over what is there
    Buffer& coverage;                   ///< out: a byte per pixel of `part`
    Buffer& shown;                      ///< out: a uint32 per tile of part_tiles()
    std::uint32_t layer = 0, pitch = 0; ///< of `coverage`; the layer's bytes
};

/// The tiles that a part of the picture touches: the first, and how many.
struct TileRange {
    glm::ivec2 first, count;
};
inline TileRange part_tiles(const PictureTile& part) {
    const glm::ivec2 first = part.low / LA_STROKE_TILE;
    return {first, (part.low + part.size - 1) / LA_STROKE_TILE - first + 1};
}

} // namespace lineatlas::compute
