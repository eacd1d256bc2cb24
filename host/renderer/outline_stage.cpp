#include "outline_stage.hpp"

#include <algorithm>
#include <array>

#include "compute/transfer.hpp"
#include "core/line_pens.hpp"

namespace lineatlas {
namespace {

using Part = std::array<float, 2>;

// A first guess; a frame that needs more makes the table grow.
constexpr std::uint32_t first_capacity = 1U << 13U;

} // namespace

compute::OutlineTable OutlineStage::find(Frame& frame, const compute::SegmentAtlas& atlas,
                                         DepthStage& depth) {
    compute::Device& device = stages_.device();
    const compute::SegmentTable segments = frame.scene.table();
    offsets_.fit((segments.segment_count + std::uint64_t{1}) * sizeof(la_uint));
    capacity_ = std::max(capacity_, compute::first_capacity<Part>(device, first_capacity));
    frame.clock("outline", [&] {
        for (bool again = true; again;) {
            parts_.fit(std::uint64_t{capacity_} * sizeof(Part));
            stages_.outline_samples({.table = segments,
                                     .clipped = atlas.clipped,
                                     .sample_capacity = atlas.capacity,
                                     .depth = depth.probed(frame),
                                     .viewport = frame.viewport(),
                                     .body = outline_depth(frame.options.style, frame.camera.size),
                                     .part_offsets = *offsets_,
                                     .parts = *parts_,
                                     .part_capacity = capacity_});
            const auto parts =
                compute::read_one<la_uint>(device, *offsets_, segments.segment_count);
            again = parts > capacity_;
            if (again) capacity_ = compute::capacity_for<Part>(device, parts);
        }
    });
    return found();
}

} // namespace lineatlas
