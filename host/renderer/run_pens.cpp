#include "run_pens.hpp"

#include <cstddef>
#include <span>

namespace lineatlas {

void RunPens::prepare(const Frame& frame) {
    const Style& style = frame.options.style;
    if (style.pens.empty()) {
        pens_.pens.resize(1);
        pens_.pens[0] = style.pen; // assigned in place: a frame allocates nothing
        pens_.of_class.clear();
        return;
    }
    pens_ = line_pens(frame.scene.classes(), style);
}

compute::Buffer& RunPens::of_segments(const Frame& frame) {
    const LineClasses& classes = frame.scene.classes();
    const std::uint32_t first = frame.scene.first_segment();
    const std::uint32_t count = frame.scene.candidate_table().segment_count;
    const Uploaded now{&classes, first, count, pens_.of_class};
    if (uploaded_ == now) return *table_;
    std::vector<la_uint> values;
    values.reserve(count);
    const std::span<const std::uint32_t> own = std::span{classes.of_segment}.subspan(first, count);
    for (const std::uint32_t line : own) {
        const LinePens::OfClass pens = pens_.of_class[line];
        values.push_back(pens.inner | pens.outline << 16U);
    }
    const std::size_t bytes = values.size() * sizeof(la_uint);
    if (!table_ || table_->size() < bytes) {
        table_.reset(); // it may not fit beside another
        table_ = compute::allocate(device_, bytes, purpose::strokes);
    }
    device_.upload(*table_, std::as_bytes(std::span{values}));
    uploaded_ = now;
    return *table_;
}

} // namespace lineatlas
