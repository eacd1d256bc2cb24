#pragma once

#include <span>
#include <vector>

#include "truth.hpp"

// How right the intervals are that come out of the device: lengths, ends and crumbs.
namespace lineatlas::bench {

struct IntervalFigures {
    double length = 0;        ///< of all lines inside the picture, pixels
    double visible = 0;       ///< of it said to be visible
    double truly_visible = 0; ///< of it visible
    /// The same with what is partly visible counted in part, by Interval::alpha and the truth.
    double shares = 0, true_shares = 0;
    double falsely_visible = 0, falsely_hidden = 0;
    std::size_t crumbs = 0;     ///< visible pieces below a pixel of which nothing is visible
    std::size_t ends = 0;       ///< places where visibility is said to change
    std::vector<double> errors; ///< of those near a true change: pixels between the two
    double missing = 0;         ///< pixels of line that are in no interval, or in two

    /// Share of the ends within `pixels` of a true change.
    double ends_within(double pixels) const;
    void add(const IntervalFigures& other);
};

/// Pixels between the places at which the truth is taken, and between two ends that belong
/// together at most.
inline constexpr float truth_step_pixels = 0.25F;
inline constexpr double end_reach_pixels = 2;

/// The intervals as a drawing as paths has them, their ends at the lines that hide them.
std::vector<Interval> met_intervals(const LineSet& lines, const ClippedLines& clipped,
                                    const Camera& camera, std::span<const Interval> intervals);

/// `truth` is of `fine`, whose step is `truth_step_pixels`; `intervals` are visible and hidden
/// ones.
IntervalFigures compare_intervals(const LineSet& lines, const ClippedLines& fine,
                                  glm::ivec2 viewport, std::span<const float> truth,
                                  std::span<const Interval> intervals);

} // namespace lineatlas::bench
