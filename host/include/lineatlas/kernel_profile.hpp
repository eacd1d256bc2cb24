#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lineatlas/export.hpp"
#include "lineatlas/profile.hpp"

/// @file
/// Why kernels take their time: the counted bytes and operations of each kernel, compared with what
/// the machine reaches. The counts do not depend on the device, since every device runs the same
/// kernels.
/// @code{.cpp}
/// register_counting_device();
/// renderer.set_device({.compute = "counting"});
/// renderer.draw(camera, options, framebuffer); // tables grow
/// take_launch_counts();
/// renderer.draw(camera, options, framebuffer);
/// const Roofs roofs{profiles.back().copy_gigabytes_per_second, measure_arithmetic()};
/// std::cout << kernel_table(kernel_times(profiles, take_launch_counts(), roofs), roofs);
/// @endcode

namespace lineatlas {

/// The work of one launch of a kernel.
struct LaunchCounts {
    std::string kernel; ///< its name
    /// The bytes of the lines of 64 bytes that it reads, and of those that it writes, each counted
    /// once. Memory must move these even if a cache holds everything else.
    std::uint64_t bytes = 0;
    /// Sums, differences, products, quotients, roots and comparisons of floats, one by one.
    std::uint64_t operations = 0;
};

/// Registers the device kind "counting": kernels as C++ that count, many times slower than "cpp".
/// Must be called before any thread uses the library; a second call does nothing.
LINEATLAS_API void register_counting_device();

/// The launches of devices of the kind "counting" since the last call, in order. Must not be called
/// while such a device works.
LINEATLAS_API std::vector<LaunchCounts> take_launch_counts();

/// The highest rates that a device reaches.
struct Roofs {
    double copy = 0;       ///< 10^9 bytes a second: FrameProfile::copy_gigabytes_per_second
    double arithmetic = 0; ///< 10^9 operations of floats a second; 0 if it is not known
};

/// Roofs::arithmetic of this machine's CPU, all cores together: products and sums in registers, by
/// the instruction set of the kernels as C++, without contraction. Takes a tenth of a second.
LINEATLAS_API double measure_arithmetic();

/// What keeps a kernel from being faster.
enum class Bound {
    unknown,    ///< it was not counted
    launch,     ///< it takes less than three times as long as the shortest launch of all
    memory,     ///< it moves its bytes at half of Roofs::copy or faster
    arithmetic, ///< it computes at half of Roofs::arithmetic or faster
    latency,    ///< otherwise: it waits for memory or for results, branches, or leaves lanes and
                ///< cores idle
};

/// "unknown", "launch", "memory", "arithmetic" or "latency".
LINEATLAS_API const char* name_of(Bound bound);

/// A kernel within a stage. Times are nanoseconds of a launch.
struct KernelTime {
    std::string stage;          ///< the stage that it ran in
    std::string name;           ///< name of the kernel
    std::uint64_t launches = 0; ///< in all frames
    double median = 0;          ///< of a launch
    double p10 = 0;             ///< the 10th percentile
    double p90 = 0;             ///< the 90th percentile
    double sum = 0;             ///< of all launches
    double bytes = 0;           ///< of a launch, mean; 0 if it was not counted
    double operations = 0;      ///< of a launch, mean
    /// 10^9 bytes a second: the median over launches, which may be of unequal size.
    double gigabytes_per_second = 0;
    double gigaops_per_second = 0; ///< 10^9 operations a second, likewise
    Bound bound = Bound::unknown;  ///< what it waits for
};

/// Every kernel of the frames, the longest sum first. `counts`: the launches of one such frame. The
/// k-th launch of a kernel in a frame gets the k-th count of that kernel; if the numbers of
/// launches differ, every launch gets an equal part of all counts.
LINEATLAS_API std::vector<KernelTime> kernel_times(std::span<const FrameProfile> frames,
                                                   std::span<const LaunchCounts> counts,
                                                   const Roofs& roofs);

/// A table for people.
LINEATLAS_API std::string kernel_table(std::span<const KernelTime> kernels, const Roofs& roofs);
/// The same as CSV: a header, then a row per kernel.
LINEATLAS_API std::string kernel_csv(std::span<const KernelTime> kernels, const Roofs& roofs);
/// The same as JSON, with the members "roofs" and "kernels"; docs/profiling.md has the keys.
LINEATLAS_API std::string kernel_json(std::span<const KernelTime> kernels, const Roofs& roofs);
/// The roofline (Williams, Waterman and Patterson 2009) as SVG: operations a second over operations
/// per byte, with a dot for each kernel that was counted and computes with floats.
LINEATLAS_API std::string roofline_svg(std::span<const KernelTime> kernels, const Roofs& roofs);

} // namespace lineatlas
