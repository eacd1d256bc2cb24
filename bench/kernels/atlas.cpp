// atlas: n samples with 9 probes each, of segments of 20 samples strewn over the picture, half
// hidden. Bytes: per sample 9 depth texels (36) and the result (1), per segment the clipped segment
// (48) and an offset (4). Neighbouring probes share texels in the cache, so the share of the copy
// may be above 1.

#include <cmath>

#include "common.hpp"

namespace lineatlas::bench {
namespace {

constexpr glm::ivec2 viewport{1024, 768};
constexpr int depth_scale = 2;
constexpr float step = 2;
constexpr std::uint32_t samples_each = 20;

/// Segments of 20 samples anywhere in the picture, before or behind depth 0.5.
std::vector<ClippedSegment> strewn_segments(std::uint32_t count) {
    Random random{5};
    std::vector<ClippedSegment> result(count);
    const glm::vec2 size{viewport};
    constexpr float length = step * samples_each * 0.99F;
    for (ClippedSegment& segment : result) {
        const float angle = random.between(0, 6.2831853F);
        const glm::vec2 half =
            0.5F * length * glm::vec2{std::cos(angle), std::sin(angle)} / size * 2.0F;
        const glm::vec2 middle{random.between(-0.9F, 0.9F), random.between(-0.9F, 0.9F)};
        const float z = random.between(-0.5F, 0.5F);
        segment = {.p = {middle.x - half.x, middle.y - half.y, z, 1},
                   .q = {middle.x + half.x, middle.y + half.y, z, 1},
                   .t0 = 0,
                   .t1 = 1,
                   .own_a = 0,
                   .own_b = 0};
    }
    return result;
}

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const std::uint32_t count = (n + samples_each - 1) / samples_each;
    std::vector<std::uint32_t> offset_values(count + 1);
    for (std::uint32_t i = 0; i <= count; ++i) offset_values[i] = std::min(i * samples_each, n);
    const glm::ivec2 depth_size = viewport * depth_scale;
    const std::vector<float> depth_values(
        static_cast<std::size_t>(depth_size.x) * static_cast<std::size_t>(depth_size.y), 0.5F);

    const SharedBuffer clipped = to_device(device, strewn_segments(count));
    const SharedBuffer offsets = to_device(device, offset_values);
    const SharedBuffer arcs =
        device.allocate(sizeof(std::uint32_t)); // the stage does not read arcs
    const SharedBuffer depth = to_device(device, depth_values);
    const SharedBuffer alpha = device.allocate(n);
    const auto run = [=, &stages] {
        stages.atlas({.segment_count = count,
                      .atlas = {{*clipped, *offsets, *arcs}, *alpha, n},
                      .depth = {*depth, depth_size, depth_scale, 1e-4F},
                      .viewport = glm::vec2{viewport},
                      .probes = 3});
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = 37.0 * n + 52.0 * count, .result = [&device, alpha, n] {
                return read_back<std::uint8_t>(device, *alpha, n);
            }};
}

} // namespace

Rows atlas_rows(const Devices& devices) {
    return own_rows(devices, "atlas", prepare);
}

} // namespace lineatlas::bench
