#include "run_pens.hpp"

#include <span>

namespace lineatlas {

void RunPens::prepare(const Frame& frame) {
    const Style& style = frame.options.style;
    if (style.pens.empty()) {
        pens_.pens.resize(1);
        pens_.pens[0] = style.pen; // assigned in place: a frame allocates nothing
        pens_.hidden.resize(1);
        pens_.hidden[0] = style.hidden_pen;
        pens_.of_class.clear();
        return;
    }
    pens_ = line_pens(frame.scene.classes(), style);
}

compute::Buffer& RunPens::of_segments(const Frame& frame, bool hidden) {
    const LineClasses& classes = frame.scene.classes();
    const std::uint32_t first = frame.scene.first_segment();
    const std::uint32_t count = frame.scene.candidate_table().segment_count;
    const Uploaded now{&classes, first, count, pens_.of_class};
    OfSegments& table = tables_[hidden ? 1 : 0];
    if (table.holds == now) return *table.values;
    std::vector<la_uint> values;
    values.reserve(count);
    const std::span<const std::uint32_t> own = std::span{classes.of_segment}.subspan(first, count);
    for (const std::uint32_t line : own) {
        const LinePens::OfClass pens = pens_.of_class[line];
        const std::uint32_t inner = hidden ? pens.hidden : pens.inner;
        values.push_back(inner | (hidden ? inner : pens.outline) << 16U);
    }
    table.values.upload(std::span<const la_uint>{values});
    table.holds = now;
    return *table.values;
}

} // namespace lineatlas
