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

// Frame times of several methods on the same views, taken in turn so that whatever else the machine
// does falls on all of them alike.
namespace lineatlas::bench {

/// A view to measure, and the one shortly before it on the camera path.
struct Viewpoint {
    Camera before, camera;
};

/// What takes part in a measurement. Draws one whole frame; need not wait for the device.
struct Contestant {
    std::string name;
    std::function<FrameStats(const Camera& camera, bool measure_stages)> draw;
    bool has_stages = true;
};

/// What came out for one contestant.
struct Measured {
    std::string name;
    std::vector<double> frame_ms;  ///< per viewpoint; NaN where a slow contestant sat out
    std::vector<double> cpu_ms;    ///< likewise, of all threads of the process
    std::vector<StageTime> stages; ///< medians, from frames of their own
    std::uint32_t samples = 0;     ///< of the last frame drawn
    std::uint32_t runs = 0;
    std::string failure; ///< why it was not measured; else empty

    bool valid() const { return failure.empty() && !frame_ms.empty(); }
    std::size_t frames() const; ///< measured ones
    double ms() const;          ///< median over the frames measured
    double fps() const { return 1000 / ms(); }
};

/// The median time of `a` over that of `b`, both over the viewpoints that both were measured at.
double time_ratio(const Measured& a, const Measured& b);

/// The median over the viewpoints of how many times as long `a` took as `b`: nearer to the truth
/// than time_ratio() where they differ by little, since both were drawn shortly after one another.
double paired_ratio(const Measured& a, const Measured& b);
/// The same of the CPU time, which other work on the machine disturbs less.
double paired_cpu_ratio(const Measured& a, const Measured& b);

/// Called before each round of frames: rounds done and in all, and who draws first.
using ProgressCallback =
    std::function<void(std::size_t done, std::size_t total, std::string_view name)>;

/// Warms up, then draws a frame per viewpoint and contestant, viewpoint by viewpoint, each time
/// with another contestant first. Contestants that take more than a second a frame draw fewer, but
/// at least 3. One that throws Error while warming up is left out, with the message as its
/// `failure`.
std::vector<Measured> measure(std::span<const Contestant> contestants,
                              std::span<const Viewpoint> viewpoints,
                              const ProgressCallback& progress);

} // namespace lineatlas::bench
