#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/line_pens.hpp"
#include "frame.hpp"

namespace lineatlas {

/// The pens of a style whose rules tell lines apart, on the device: which pen draws which segment.
class RunPens {
  public:
    explicit RunPens(compute::Device& device) : device_(device) {}

    /// Before a frame: the pens for the lines of its scene.
    void prepare(const Frame& frame);
    /// Whether there are several; else the style's own draws all.
    bool several() const { return pens_.pens.size() > 1; }
    /// Whether the frame needs to know what is outline.
    bool tell_outlines() const { return several() && pens_.tell_outlines(); }
    const std::vector<Pen>& pens() const { return pens_.pens; }
    float widest() const { return pens_.widest(); }
    /// Other lines have come.
    void forget() { uploaded_.reset(); }
    /// Of the scene's current chunk: a uint32 per segment of the line set, see compute::PensArgs.
    compute::Buffer& of_segments(const Frame& frame);

  private:
    compute::Device& device_;
    /// What `table_` holds: the pens of whose segments.
    struct Uploaded {
        const LineClasses* classes;
        std::uint32_t first, count;
        std::vector<LinePens::OfClass> of_class;
        bool operator==(const Uploaded&) const = default;
    };

    LinePens pens_;
    std::optional<Uploaded> uploaded_;
    std::unique_ptr<compute::Buffer> table_;
};

} // namespace lineatlas
