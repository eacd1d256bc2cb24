#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/line_pens.hpp"
#include "frame.hpp"

namespace lineatlas {

/// The pens of a style with rules, on the device: which pen draws which segment.
class RunPens {
  public:
    explicit RunPens(compute::Device& device) : tables_{OfSegments{device}, OfSegments{device}} {}

    /// Finds the pens for the lines of the frame's scene. Call before each frame.
    void prepare(const Frame& frame);
    /// The pens of hidden lines, or of visible ones.
    const std::vector<Pen>& pens(bool hidden) const { return hidden ? pens_.hidden : pens_.pens; }
    /// Whether there are several pens. If not, the style's own pen draws all lines.
    bool several(bool hidden) const { return pens(hidden).size() > 1; }
    float widest(bool hidden) const { return lineatlas::widest(pens(hidden)); }
    /// Call when the scene has other lines.
    void forget() {
        for (OfSegments& table : tables_) table.holds.reset();
    }
    /// The pens of the scene's current chunk: a uint32 per segment of the line set, see
    /// compute::PensArgs.
    compute::Buffer& of_segments(const Frame& frame, bool hidden);

  private:
    /// What the table was made from.
    struct Uploaded {
        const LineClasses* classes;
        std::uint32_t first, count;
        std::vector<LinePens::OfClass> of_class;
        bool operator==(const Uploaded&) const = default;
    };

    struct OfSegments {
        explicit OfSegments(compute::Device& device)
            : values(device, compute::table::segment_pens) {}

        std::optional<Uploaded> holds;
        compute::Table values;
    };

    LinePens pens_;
    std::array<OfSegments, 2> tables_; ///< of visible lines, and of hidden ones
};

} // namespace lineatlas
