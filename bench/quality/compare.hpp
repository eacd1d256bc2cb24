#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lineatlas/io.hpp"
#include "truth.hpp"

// Measured visibility against the truth.
namespace lineatlas::bench {

/// A sample is wrong when its visibility is off by more than this.
inline constexpr float wrong_threshold = 0.5F;

/// The figures of docs/quality.md over any set of samples.
struct Figures {
    std::uint64_t samples = 0;
    double error_sum = 0;            ///< of |alpha - alpha*|
    std::uint64_t false_visible = 0; ///< wrong, and shown: leaks behind walls
    std::uint64_t false_hidden = 0;  ///< wrong, and not shown: broken lines

    void add(float alpha, float truth);
    void add(const Figures& other);
    std::uint64_t wrong() const { return false_visible + false_hidden; }
    double share(std::uint64_t count) const {
        return samples == 0 ? 0 : static_cast<double>(count) / static_cast<double>(samples);
    }
    double mean_error() const {
        return samples == 0 ? 0 : error_sum / static_cast<double>(samples);
    }
};

/// Figures in total and per line kind.
struct KindFigures {
    Figures all;
    std::array<Figures, LA_KIND_COUNT> kinds;

    void add(const KindFigures& other);
};

/// The samples of a view: what a method says and what is true. All spans are in sample order.
struct ViewSamples {
    const LineSet& lines;
    const ClippedLines& clipped;
    std::span<const std::uint8_t> alpha; ///< 0 to 255
    std::span<const float> truth;        ///< 0 to 1
};

/// Throws UsageError when the numbers of samples differ.
KindFigures compare(const ViewSamples& view);

/// A segment with wrong samples.
struct WrongSegment {
    std::uint32_t segment;
    Figures figures;
    std::uint32_t worst_sample; ///< the one that is off the most; of equals the middle one
};

/// The segments with the most wrong samples, at most `count`.
std::vector<WrongSegment> worst_segments(const ViewSamples& view, std::size_t count);

/// A picture of every sample: visible grey to black, hidden very light, false visible red, false
/// hidden blue; wrong ones on top. `scale` times as large as the viewport.
Image error_picture(const ViewSamples& view, glm::ivec2 viewport, int scale);

} // namespace lineatlas::bench
