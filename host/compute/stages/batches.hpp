#pragma once

#include "stages.hpp"

namespace lineatlas::compute {

/// Segments or triangles of a line set in batches, with the boxes around them. Batches that are
/// outside of a picture, or hidden in it, are left out together.
class Batches {
  public:
    /// `stages` must outlive it.
    explicit Batches(Stages& stages) : stages_(stages), device_(stages.device()) {}

    /// Gives up its tables.
    void release();
    /// Call when the tables hold something else.
    void forget() { of_ = {}; }
    /// Whether there are boxes for the fixed lines, or the triangles, of `table`. Boxes are made
    /// when these stand at the same places for the second time. For a model that moves in every
    /// frame they would not pay.
    bool has_segments(const SegmentTable& table);
    bool has_triangles(const SegmentTable& table);
    /// The last batches that were made.
    BatchTable table() const { return {boxes_.get(), states_.get(), count_}; }

  private:
    /// The input that boxes were made from.
    struct Of {
        const Buffer *elements = nullptr, *vertices = nullptr;
        std::uint64_t version = 0;
        std::uint32_t count = 0;

        bool operator==(const Of&) const = default;
    };
    /// What to do about boxes if `of` stands still.
    enum class Step { wait, make, keep };
    Step next(const Of& of);
    template <class Boxes>
    bool has(const SegmentTable& table, const Buffer& elements, std::uint32_t count);

    Stages& stages_;
    Device& device_; ///< of stages_
    Of of_;
    bool made_ = false; ///< for of_
    std::uint32_t count_ = 0;
    Table boxes_{device_, table::batch_boxes}, states_{device_, table::batch_states};
};

} // namespace lineatlas::compute
