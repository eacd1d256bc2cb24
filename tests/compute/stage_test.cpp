#include "stage_test.hpp"

#include <bit>

namespace lineatlas::test {
namespace {

void set_clip(float (&clip)[4], const WindowPlace& place) {
    const glm::vec2 size{hand_size};
    clip[0] = (place.x / size.x * 2 - 1) * place.w;
    clip[1] = (place.y / size.y * 2 - 1) * place.w;
    clip[2] = (place.z * 2 - 1) * place.w;
    clip[3] = place.w;
}

} // namespace

HandFrame::HandFrame(compute::Device& device, std::span<const HandLine> lines)
    : count_(static_cast<std::uint32_t>(lines.size())) {
    std::vector<Segment> segments;
    std::vector<ClippedSegment> clipped;
    std::vector<std::uint32_t> offsets{0}, arcs{0};
    for (const HandLine& line : lines) {
        const auto i = static_cast<std::uint32_t>(segments.size());
        segments.push_back({.p = line.vertex_p,
                            .q = line.vertex_q,
                            .face_a = LA_NO_FACE,
                            .face_b = LA_NO_FACE,
                            .from_start = line.from_start,
                            .to_end = line.to_end,
                            .path = i - line.from_start,
                            .tag = line.tag});
        ClippedSegment& segment = clipped.emplace_back();
        set_clip(segment.p, line.p);
        set_clip(segment.q, line.q);
        segment.t0 = line.t0;
        segment.t1 = line.t1;
        segment.own_a = line.own_a;
        segment.own_b = line.own_b;
        const double length = std::hypot(double{line.q.x} - line.p.x, double{line.q.y} - line.p.y);
        offsets.push_back(offsets.back() + line.samples);
        arcs.push_back(arcs.back() + static_cast<std::uint32_t>(length * 256));
    }
    samples_ = offsets.back();
    segments_ = to_device(device, segments);
    clipped_ = to_device(device, clipped);
    offsets_ = to_device(device, offsets);
    arcs_ = to_device(device, arcs);
    no_triangles_ = device.allocate(16);
}

std::uint32_t pack_own_face(float slope, float height) {
    return std::bit_cast<std::uint32_t>(slope) >> 16U |
           (std::bit_cast<std::uint32_t>(height) & 0xFFFF0000U);
}
float slope_of(std::uint32_t packed) {
    return std::bit_cast<float>(packed << 16U);
}
float height_of(std::uint32_t packed) {
    return std::bit_cast<float>(packed & 0xFFFF0000U);
}

} // namespace lineatlas::test
