#include "compare.hpp"

#include <algorithm>
#include <bit>

namespace lineatlas::test {

bool close(float a, float b, float relative, float absolute) {
    if (a == b) return true;
    if (!std::isfinite(a) || !std::isfinite(b)) return false;
    const float largest = std::max(std::fabs(a), std::fabs(b));
    return std::fabs(a - b) <= std::max(absolute, relative * largest);
}

bool close(const ClippedSegment& a, const ClippedSegment& b) {
    for (int i = 0; i < 4; ++i) {
        if (!close(a.p[i], b.p[i]) || !close(a.q[i], b.q[i])) return false;
    }
    const auto packed = [](std::uint32_t x, std::uint32_t y) {
        const auto half = [](std::uint32_t bits) { return std::bit_cast<float>(bits << 16U); };
        // One unit of the seven mantissa bits that are kept.
        return close(half(x & 0xFFFFU), half(y & 0xFFFFU), 0.008F) &&
               close(half(x >> 16U), half(y >> 16U), 0.008F);
    };
    return close(a.t0, b.t0) && close(a.t1, b.t1) && packed(a.own_a, b.own_a) &&
           packed(a.own_b, b.own_b);
}

bool close(const Run& a, const Run& b) {
    constexpr float pixel = 1e-3F;
    for (int i = 0; i < 2; ++i) {
        if (!close(a.start[i], b.start[i], 1e-5F, pixel) ||
            !close(a.end[i], b.end[i], 1e-5F, pixel) ||
            !close(a.start_corner[i], b.start_corner[i], 1e-4F, pixel) ||
            !close(a.end_corner[i], b.end_corner[i], 1e-4F, pixel)) {
            return false;
        }
    }
    return close(a.start_arc, b.start_arc, 1e-5F, pixel) &&
           close(a.end_arc, b.end_arc, 1e-5F, pixel) &&
           close(a.stroke_start, b.stroke_start, 1e-5F, pixel) &&
           close(a.stroke_end, b.stroke_end, 1e-5F, pixel) && close(a.start_depth, b.start_depth) &&
           close(a.end_depth, b.end_depth) && close(a.start_sample, b.start_sample, 1e-5F, pixel) &&
           close(a.end_sample, b.end_sample, 1e-5F, pixel) && a.address == b.address &&
           a.samples == b.samples && a.flags == b.flags && a.segment == b.segment;
}

bool close(const RunCuts& a, const RunCuts& b) {
    constexpr float pixel = 1e-3F;
    for (std::size_t k = 0; k < LA_MOST_CUTS; ++k) {
        if (!close(a.from[k], b.from[k], 1e-5F, pixel) || !close(a.to[k], b.to[k], 1e-5F, pixel)) {
            return false;
        }
    }
    return true;
}

bool close(const Interval& a, const Interval& b) {
    constexpr float pixel = 1e-3F;
    for (int i = 0; i < 2; ++i) {
        if (!close(a.start[i], b.start[i], 1e-5F, pixel) ||
            !close(a.end[i], b.end[i], 1e-5F, pixel)) {
            return false;
        }
    }
    for (int i = 0; i < 3; ++i) {
        if (!close(a.start_world[i], b.start_world[i], 1e-5F, 1e-4F) ||
            !close(a.end_world[i], b.end_world[i], 1e-5F, 1e-4F)) {
            return false;
        }
    }
    return close(a.start_arc, b.start_arc, 1e-5F, pixel) &&
           close(a.end_arc, b.end_arc, 1e-5F, pixel) && close(a.start_depth, b.start_depth) &&
           close(a.end_depth, b.end_depth) && close(a.start_sample, b.start_sample, 1e-5F, pixel) &&
           close(a.end_sample, b.end_sample, 1e-5F, pixel) && close(a.alpha, b.alpha) &&
           a.segment == b.segment && a.flags == b.flags;
}

ByteDifference compare_bytes(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                             int allowed) {
    if (a.size() != b.size()) {
        const std::size_t count = std::max(a.size(), b.size());
        return {.count = count, .beyond = count, .largest = 255};
    }
    ByteDifference result{.count = a.size()};
    for (std::size_t i = 0; i < a.size(); ++i) {
        const int difference = std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i]));
        result.largest = std::max(result.largest, difference);
        if (difference > allowed) ++result.beyond;
    }
    return result;
}

} // namespace lineatlas::test
