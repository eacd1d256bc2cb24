#pragma once

#include <optional>

#include "batches.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas::compute {

/// The exact method (kernels/shared/exact.h): finds the visible parts of every segment without a
/// depth buffer and without samples. Keeps the tables of its stages, which grow when a frame needs
/// more.
class ExactVisibility {
  public:
    /// `stages` must outlive it.
    explicit ExactVisibility(Stages& stages)
        : stages_(stages), device_(stages.device()), triangles_(stages),
          tables_(device_, table::exact_lists) {}

    /// Gives up its tables: those of a large model may not fit beside another's.
    void release();
    /// Call when the tables hold other lines.
    void forget_lines() { triangles_.forget(); }
    /// Call before the stages of a frame. `camera`: a standard camera. `bounds`: those of the model
    /// at its current places. `contact`: points nearer to a plane than this touch it
    /// (contact_of()).
    void begin(const SegmentTable& table, const Camera& camera, const Bounds& bounds,
               float contact);
    /// Goes on with other segments of the same frame. visible() uses the same lists for them.
    void go_on(const SegmentTable& table);
    // The stages of a frame, in this order. Repeat them if grow() says so.
    void surfaces(const ClippedTable& clipped);
    /// Finds batches of segments that cannot be seen. Call between surfaces() and project_clip.
    /// Hidden batches are left out only if `drops_hidden`.
    void find_batches(const ClippedTable& clipped, const BatchTable& segments, bool drops_hidden);
    void tile_lists(const ClippedTable& clipped);
    void visible(const ClippedTable& clipped);
    /// Finds the visible parts with the background on one side and a body that is `depth` pixels
    /// deep on the other. Call after the last visible(). Waits for the device.
    OutlineTable outline(const ClippedTable& clipped, float depth);
    /// Enlarges tables that were too small, for which it waits. Returns true if tile_lists() and
    /// visible() must be done again. If only spans had no room, it writes them itself.
    bool grow(const ClippedTable& clipped);

    /// The result of the last visible().
    SpanTable spans() const;
    /// A table of a uint32 per segment and one more for the counts of project_clip. visible() uses
    /// it later.
    Buffer& counts() const { return tables_[Table::span_offsets]; }

  private:
    enum class Table {
        // Per model:
        screen,
        faces,
        planes,
        kept,
        span_offsets,
        // Per picture:
        occluders,
        ends,
        groups,
        // That grow:
        entries,
        blocks,
        boxes,
        spans,
        // While outlines are asked for, of what is seen:
        numbers,
        seen,
        pushed,
        part_offsets,
        parts,
        beside_kept,
        beside_offsets,
        beside_spans,
        within_kept,
        within_offsets,
        within_spans,
        count
    };
    ExactArgs args(const ClippedTable& clipped) const;
    ExactArgs args(const ClippedTable& clipped, const ExactParameters& parameters, Buffer& kept,
                   Buffer& span_offsets, Buffer& spans) const;
    void make_lists();
    void make_room_for_segments();
    /// Capacity for `needed` elements. The first line set gets exactly that (a still picture needs
    /// no more); later ones get room to grow.
    std::uint32_t grown(std::uint32_t needed, std::size_t element) const;
    std::uint32_t tiles() const {
        return static_cast<std::uint32_t>(parameters_.tiles.x * parameters_.tiles.y);
    }

    Stages& stages_;
    Device& device_;                    ///< of stages_
    std::optional<SegmentTable> table_; ///< of the current frame
    bool has_found_ = false;            ///< visible parts of other lines were found since release()
    ExactParameters parameters_{};
    Batches triangles_;
    std::optional<BatchTable> batches_; ///< of the current frame's triangles
    GrowingTables<Table> tables_;
    /// Tables of the visible parts of ways beside segments.
    struct Beside {
        Table kept, offsets, spans;
        std::uint32_t capacity = 0; ///< of spans
    };
    /// Finds the visible parts of the ways in Table::pushed. ways: per segment. seen: segments.
    void find_beside(const ClippedTable& clipped, std::uint32_t seen, std::uint32_t ways,
                     Beside& beside);
    Beside beside_{Table::beside_kept, Table::beside_offsets, Table::beside_spans};
    Beside within_{Table::within_kept, Table::within_offsets, Table::within_spans};
    std::uint32_t part_capacity_ = 0; ///< of Table::parts
};

} // namespace lineatlas::compute
