#include "stages.hpp"

#include <algorithm>
#include <cmath>

namespace lineatlas::compute::reference {
namespace {

std::uint32_t packed(float t0, float t1) {
    const auto bits = [](float t) { return static_cast<std::uint32_t>(t * 65535.0F + 0.5F); };
    return bits(t0) | bits(t1) << 16U;
}

/// Visibility of 0 to 255 at a position counted in samples, linear between their centres.
float at(std::span<const std::uint8_t> alpha, float position) {
    const float x = std::clamp(position - 0.5F, 0.0F, static_cast<float>(alpha.size() - 1));
    const auto low = static_cast<std::size_t>(x);
    const float a = alpha[low];
    const float b = alpha[std::min(low + 1, alpha.size() - 1)];
    return a + (b - a) * (x - static_cast<float>(low));
}

std::uint8_t average(std::uint8_t now, float past) {
    const float change = static_cast<float>(now) - past;
    const float size = std::fabs(change);
    const bool extreme = now == 0 || now == 255;
    if (size > LA_TEMPORAL_LARGEST_CHANGE) return now;
    if (extreme && size < LA_TEMPORAL_SMALLEST_CHANGE) return now;
    return static_cast<std::uint8_t>(past + change * LA_TEMPORAL_SHARE + 0.5F);
}

} // namespace

void temporal(const TemporalInput& in, std::span<std::uint32_t> ranges,
              std::span<std::uint8_t> alpha) {
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const std::uint32_t s = in.offsets[i];
        const std::uint32_t l = in.offsets[i + 1] - s;
        if (l == 0 || l > in.capacity || s > in.capacity - l) continue;
        const ClippedSegment& segment = in.clipped[i];
        const std::uint32_t range = ranges[i];
        ranges[i] = packed(segment.t0, segment.t1);
        const bool same_range = ranges[i] == range;
        if (in.offsets_before.empty()) continue;
        const std::uint32_t s_before = in.offsets_before[i];
        const std::uint32_t l_before = in.offsets_before[i + 1] - s_before;
        if (l_before == 0) continue;
        const auto before = in.before.subspan(in.layout.address(s_before), l_before);
        const auto own = alpha.subspan(in.layout.address(s), l);
        if (l == l_before && same_range) {
            for (std::uint32_t j = 0; j < l; ++j) own[j] = average(own[j], before[j]);
            continue;
        }
        const float t0_before = static_cast<float>(range & 0xFFFFU) / 65535.0F;
        const float length_before = static_cast<float>(range >> 16U) / 65535.0F - t0_before;
        if (length_before <= 0) continue;
        const float wp = segment.p[3], wq = segment.q[3];
        for (std::uint32_t j = 0; j < l; ++j) {
            const float u = (static_cast<float>(j) + 0.5F) / static_cast<float>(l);
            const float in_space = u * wp / (u * wp + (1 - u) * wq);
            const float t =
                (segment.t0 + (segment.t1 - segment.t0) * in_space - t0_before) / length_before;
            if (!(t >= 0 && t <= 1)) continue;
            const float u_before = t * wq / (t * wq + (1 - t) * wp);
            own[j] = average(own[j], at(before, u_before * static_cast<float>(l_before)));
        }
    }
}

} // namespace lineatlas::compute::reference
