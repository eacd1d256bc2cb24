#pragma once

#include <array>
#include <memory>
#include <optional>

#include "batches.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas::compute {

/// The exact method (kernels/exact.h): what is visible of every segment, with neither a depth
/// buffer nor samples. Keeps the tables of its stages, which grow when a frame needs more.
class ExactVisibility {
  public:
    /// `stages` must outlive it.
    explicit ExactVisibility(Stages& stages)
        : stages_(stages), device_(stages.device()), triangles_(stages) {}

    /// Gives up its tables: those of a large model may not fit beside another's.
    void release();
    /// The lines are others, in the same tables.
    void forget_lines() { triangles_.forget(); }
    /// Before the stages of a frame. `camera`: a standard one; `bounds`: around the model as it
    /// stands; `contact`: what is nearer to a plane than that touches it (contact_of()).
    void begin(const SegmentTable& table, const Camera& camera, const Bounds& bounds,
               float contact);
    /// To other segments of the same frame: visible() for these, by the lists of before.
    void go_on(const SegmentTable& table);
    // The stages of a frame, in this order; again where grow() says so.
    void surfaces(const ClippedTable& clipped);
    /// Between surfaces() and project_clip: which batches of segments can't be seen. Those that are
    /// hidden are left out only where `drops_hidden`.
    void find_batches(const ClippedTable& clipped, const BatchTable& segments, bool drops_hidden);
    void tile_lists(const ClippedTable& clipped);
    void visible(const ClippedTable& clipped);
    /// After the last visible(): which parts of what it found have the background on one side, and
    /// on the other one a body that is `depth` pixels deep. Waits.
    OutlineTable outline(const ClippedTable& clipped, float depth);
    /// Enlarges the tables that were too small, and waits for that; true if tile_lists() and
    /// visible() must be done again.
    bool grow();

    /// Of the last visible().
    SpanTable spans() const;
    /// A uint32 per segment and one more, not in use before visible(): for what project_clip
    /// counts.
    Buffer& counts() const { return *span_offsets_; }
    std::uint64_t bytes() const; ///< of all its tables

  private:
    template <class Self>
    static auto tables(Self& self) {
        return std::array{&self.screen_,      &self.faces_,          &self.planes_,
                          &self.kept_,        &self.span_offsets_,   &self.occluders_,
                          &self.ends_,        &self.groups_,         &self.entries_,
                          &self.blocks_,      &self.boxes_,          &self.spans_,
                          &self.pushed_,      &self.part_offsets_,   &self.parts_,
                          &self.beside_.kept, &self.beside_.offsets, &self.beside_.spans,
                          &self.within_.kept, &self.within_.offsets, &self.within_.spans};
    }
    ExactArgs args(const ClippedTable& clipped) const;
    ExactArgs args(const ClippedTable& clipped, const ExactParameters& parameters, Buffer& kept,
                   Buffer& span_offsets, Buffer& spans) const;
    void make_room(std::unique_ptr<Buffer>& buffer, std::uint64_t bytes);
    void make_lists();
    void make_room_for_segments();
    std::uint32_t read(Buffer& buffer, std::size_t index) const;
    std::uint32_t tiles() const {
        return static_cast<std::uint32_t>(parameters_.tiles.x * parameters_.tiles.y);
    }

    Stages& stages_;
    Device& device_;                    ///< of stages_
    std::optional<SegmentTable> table_; ///< of the current frame
    ExactParameters parameters_{};
    Batches triangles_;
    std::optional<BatchTable> batches_; ///< of the current frame's triangles
    std::unique_ptr<Buffer> screen_, faces_, planes_, kept_, span_offsets_; // per model
    std::unique_ptr<Buffer> occluders_, ends_, groups_;                     // per picture
    std::unique_ptr<Buffer> entries_, blocks_, boxes_, spans_;              // that grow
    /// What is seen of ways beside the segments, while outlines are asked for.
    struct Beside {
        std::unique_ptr<Buffer> kept, offsets, spans;
        std::uint32_t capacity = 0; ///< of spans
    };
    /// Of what stands in pushed_, so many ways per segment.
    void find_beside(const ClippedTable& clipped, std::uint32_t ways, Beside& beside);
    std::unique_ptr<Buffer> pushed_, part_offsets_, parts_;
    Beside beside_, within_;
    std::uint32_t part_capacity_ = 0; ///< of parts_
};

} // namespace lineatlas::compute
