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
        : stages_(stages), device_(stages.device()), triangles_(stages) {}

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
    void surfaces();
    /// Finds batches of segments that cannot be seen. Call between surfaces() and project_clip.
    /// Hidden batches are left out only if `drops_hidden`.
    void find_batches(const BatchTable& segments, bool drops_hidden);
    void tile_lists();
    void visible(const ClippedTable& clipped); ///< waits if Tuning::face_lists
    /// Finds the visible parts with the background on one side and a body that is `depth` pixels
    /// deep on the other. Call after the last visible(). Waits for the device.
    OutlineTable outline(const ClippedTable& clipped, float depth);
    void read_sizes(); ///< reads what grow() decides by; waits
    /// Enlarges tables that were too small. Returns true if tile_lists() and visible() must be done
    /// again. If only spans had no room, it writes them itself.
    bool grow(const ClippedTable& clipped);

    /// The result of the last visible().
    SpanTable spans() const { return own_.table(); }
    /// A table of a uint32 per segment and one more for the counts of project_clip. visible() uses
    /// it later.
    Buffer& counts() const { return *own_.offsets; }

  private:
    /// The tables of faces on the screen; kernels/exact_tables.h says what each holds.
    struct Lists {
        Device* device;
        // Per model:
        Table screen{*device, table::exact_screen}; ///< 4 floats per vertex
        Table faces{*device, table::exact_faces};   ///< `ScreenFace` per triangle
        Table planes{*device, table::exact_planes}; ///< 4 floats per triangle
        // Per picture:
        Table occluders{*device, table::exact_occluders}; ///< a uint32 per tile
        Table ends{*device, table::exact_ends}; ///< columns() uint32 per tile, and the number of
                                                ///< entries
        Table groups{*device, table::exact_groups}; ///< a uint32 per tile, and the number of groups
        // Tables that grow:
        Table entries{*device, table::exact_entries}; ///< `Entry` each, entry_capacity of them
        Table blocks{*device, table::exact_blocks};   ///< LA_GROUP_FLOATS floats per group,
                                                      ///< group_capacity of them
        Table boxes{*device, table::exact_boxes};     ///< LA_BOX_FLOATS floats for group_capacity +
                                                      ///< LA_GROUP groups
    };
    /// How much the stages had to hold.
    struct Sizes {
        std::uint32_t entries = 0, groups = 0, spans = 0;
    };
    /// The visible parts of lines.
    struct Found {
        Table kept;    ///< 4 floats per line
        Table offsets; ///< a uint32 per line, and the number of spans
        Table spans;   ///< 2 floats per span; none if there are more than `capacity`
        std::uint32_t capacity = 0;

        SpanTable table() const { return {*offsets, *spans, capacity}; }
        /// Makes room for `capacity` spans.
        void make_spans() { spans.fit(std::uint64_t{capacity} * 2 * sizeof(float)); }
    };
    /// Lines that are cut by the faces before them.
    struct Lines {
        ClippedTable clipped; ///< `offsets` is not read
        ExactParameters parameters;
        const Found& found;
        Buffer* seen = nullptr; ///< for ways beside segments: the segments
    };
    /// Tables that may be missing.
    struct Optional {
        Buffer *patches, *states;
    };
    Optional optional() const;
    ExactParameters in_chunks(const ExactParameters& parameters) const;
    Lines lines(const ClippedTable& clipped) const { return {clipped, parameters_, own_}; }
    /// With Tuning::face_lists: does the work of tile_lists_arrange.
    void arrange_by_entries(const ExactParameters& parameters);
    void find_spans(const Lines& lines);
    /// Does the work of visible_count piece by piece, for each segment in each tile. Waits.
    void count_pieces(const Lines& lines, const ExactParameters& parameters);
    /// The last step of find_spans() alone, for a table of spans that was too small for it.
    void write_spans(const Lines& lines);
    void make_lists();
    void make_room_for_segments();
    /// Capacity for `needed` elements. The first line set gets exactly that (a still picture needs
    /// no more); later ones get room to grow.
    std::uint32_t grown(std::uint32_t needed, std::size_t element) const;
    std::uint32_t tiles() const {
        return static_cast<std::uint32_t>(parameters_.tiles.x * parameters_.tiles.y);
    }
    /// The number of ends that a tile's list has while it is filled.
    std::uint32_t columns() const {
        const Tuning& tuning = device_.tuning();
        return tuning.face_lists ? 1 : tuning.face_chunks;
    }
    /// Finds the visible parts of the ways in `pushed_`. ways: per segment. seen: segments.
    void find_beside(const ClippedTable& clipped, std::uint32_t seen, std::uint32_t ways,
                     Found& found);

    Stages& stages_;
    Device& device_;                    ///< of stages_
    std::optional<SegmentTable> table_; ///< of the current frame
    bool has_found_ = false;            ///< visible parts of other lines were found since release()
    ExactParameters parameters_{};
    Batches triangles_;
    BatchTable batches_; ///< of the current frame's triangles
    Sizes sizes_;
    Lists lists_{&device_};
    Found own_{{device_, table::exact_kept},
               {device_, table::exact_span_offsets},
               {device_, table::exact_spans}};
    // While outlines are asked for, of what is seen:
    Table numbers_{device_, table::exact_numbers}, seen_{device_, table::exact_seen},
        pushed_{device_, table::exact_pushed};
    Found beside_{{device_, table::exact_beside_kept},
                  {device_, table::exact_beside_offsets},
                  {device_, table::exact_beside_spans}};
    Found within_{{device_, table::exact_within_kept},
                  {device_, table::exact_within_offsets},
                  {device_, table::exact_within_spans}};
    Table part_offsets_{device_, table::exact_part_offsets}, parts_{device_, table::exact_parts};
    std::uint32_t part_capacity_ = 0; ///< of parts_
};

} // namespace lineatlas::compute
