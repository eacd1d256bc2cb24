#pragma once

#include <span>
#include <vector>

#include "truth.hpp"

// The errors of intervals that are read back from the device: in lengths and ends, and crumbs.
namespace lineatlas::bench {

struct IntervalFigures {
    double length = 0;        ///< of all lines inside the picture, pixels
    double visible = 0;       ///< of `length`, in visible intervals
    double truly_visible = 0; ///< of `length`, visible by the truth
    /// The visible lengths with partly visible places counted in part, by Interval::alpha and by
    /// the truth.
    double shares = 0, true_shares = 0;
    double falsely_visible = 0, falsely_hidden = 0;
    std::size_t crumbs = 0;     ///< visible intervals below a pixel without any truly visible place
    std::size_t ends = 0;       ///< places where intervals of a path change visibility
    std::vector<double> errors; ///< distances in pixels of ends near a true change from that change
    double missing = 0;         ///< pixels of line that are in no interval

    /// The share of ends within `pixels` of a true change.
    double ends_within(double pixels) const;
    void add(const IntervalFigures& other);
};

/// Pixels between places of the truth, and the largest distance of an end from its true change.
inline constexpr float truth_step_pixels = 0.25F;
inline constexpr double end_reach_pixels = 2;

/// The intervals as drawings as paths have them: hidden ends meet the lines that hide them.
std::vector<Interval> met_intervals(const LineSet& lines, const ClippedLines& clipped,
                                    const Camera& camera, std::span<const Interval> intervals);

/// Compares intervals, visible and hidden ones, with the truth of `fine`, which has the step
/// `truth_step_pixels`.
IntervalFigures compare_intervals(const LineSet& lines, const ClippedLines& fine,
                                  glm::ivec2 viewport, std::span<const float> truth,
                                  std::span<const Interval> intervals);

} // namespace lineatlas::bench
