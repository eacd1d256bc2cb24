#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/methods.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/renderer.hpp"

// Frame times of several methods on the same views. The methods take turns, so that other work on
// the machine affects all of them alike.
namespace lineatlas::bench {

/// A view to measure, and the view one frame before it on the camera path.
struct Viewpoint {
    Camera before, camera;
};

/// A participant of a measurement. `draw` draws one whole frame and need not wait for the device.
struct Contestant {
    std::string name;
    std::function<FrameStats(const Camera& camera, bool measure_stages)> draw;
    bool has_stages = true;
};

/// The result of one contestant.
struct Measured {
    std::string name;
    std::vector<double> frame_ms;  ///< per viewpoint; NaN where a slow contestant drew no frame
    std::vector<double> cpu_ms;    ///< CPU time likewise, of all threads of the process
    std::vector<StageTime> stages; ///< medians over separate frames
    std::uint32_t samples = 0;     ///< of the last frame drawn
    std::uint32_t runs = 0;
    std::string failure; ///< why the contestant was not measured; empty: it was

    bool valid() const { return failure.empty() && !frame_ms.empty(); }
    std::size_t frames() const; ///< number of measured frames
    double ms() const;          ///< median over the measured frames
    double fps() const { return 1000 / ms(); }
};

/// The median time of `a` over that of `b`, at the viewpoints where both were measured.
double time_ratio(const Measured& a, const Measured& b);

/// The median over the viewpoints of the time of `a` over the time of `b`. For small differences
/// this is more precise than time_ratio(), because both frames of a viewpoint are drawn shortly
/// after one another.
double paired_ratio(const Measured& a, const Measured& b);
/// As paired_ratio(), but of CPU time, which other work on the machine disturbs less.
double paired_cpu_ratio(const Measured& a, const Measured& b);

/// Called before each frame: viewpoints done, viewpoints in all, and the contestant that draws.
using ProgressCallback =
    std::function<void(std::size_t done, std::size_t total, std::string_view name)>;

/// Warms up, then draws a frame per viewpoint and contestant, viewpoint by viewpoint. Each
/// viewpoint begins with another contestant. Contestants that take more than a second a frame draw
/// fewer frames, but at least 3 if there are as many viewpoints. A contestant that throws Error
/// while warming up is left out; its `failure` is the message.
std::vector<Measured> measure(std::span<const Contestant> contestants,
                              std::span<const Viewpoint> viewpoints,
                              const ProgressCallback& progress);

} // namespace lineatlas::bench
