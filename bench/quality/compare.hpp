#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lineatlas/io.hpp"
#include "truth.hpp"

// Measured visibility against the truth.
namespace lineatlas::bench {

/// A sample is wrong if its visibility differs from the truth by more than this.
inline constexpr float wrong_threshold = 0.5F;

/// The figures of docs/quality.md for a set of samples.
struct Figures {
    std::uint64_t samples = 0;
    double error_sum = 0;            ///< of |alpha - alpha*|
    std::uint64_t false_visible = 0; ///< wrong and shown: lines behind walls
    std::uint64_t false_hidden = 0;  ///< wrong and not shown: broken lines

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

/// The samples of a view: the alpha of a method and the truth. Spans are in sample order.
struct ViewSamples {
    const LineSet& lines;
    const ClippedLines& clipped;
    std::span<const std::uint8_t> alpha; ///< 0 to 255
    std::span<const float> truth;        ///< 0 to 1
};

/// Compares all samples. Throws UsageError if the numbers of samples differ.
KindFigures compare(const ViewSamples& view);

/// A segment with wrong samples.
struct WrongSegment {
    std::uint32_t segment;
    Figures figures;
    std::uint32_t worst_sample; ///< the sample with the largest error; of several the middle one
};

/// The segments with the most wrong samples, at most `count`.
std::vector<WrongSegment> worst_segments(const ViewSamples& view, std::size_t count);

/// A picture of all samples, `scale` times as large as the viewport. Visible samples are grey to
/// black, hidden ones very light, false visible ones red, false hidden ones blue. Wrong samples are
/// on top.
Image error_picture(const ViewSamples& view, glm::ivec2 viewport, int scale);

} // namespace lineatlas::bench
