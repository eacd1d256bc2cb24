#pragma once

#include <cstdint>
#include <optional>
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
/// const Roofs roofs{profiles.back().copy_gigabytes_per_second, measure_arithmetic("cpp")};
/// std::cout << kernel_table(kernel_times(profiles, take_launch_counts(), roofs), roofs);
/// @endcode
/// What the CPU counts meanwhile, and what the driver tells, come from two frames on a device of
/// register_perf_device().

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
/// DeviceOptions::device names the device whose forms of kernels are counted: "cpp", also if empty,
/// or "opencl:<platform>[:<device>]". Only kernels with barriers (Kernel::has_barriers) do not
/// count: scans run in chunks. Must be called before any thread uses the library; a second call
/// does nothing.
LINEATLAS_API void register_counting_device();

/// The launches of devices of the kind "counting" since the last call, in order. Must not be called
/// while such a device works.
LINEATLAS_API std::vector<LaunchCounts> take_launch_counts();

/// What an OpenCL driver tells of a kernel on its device.
struct KernelResources {
    std::uint32_t largest_group = 0; ///< work-items of a work-group; 0: nothing is told of kernels
    std::uint32_t multiple = 0;      ///< a work-group's work-items are best a multiple of this
    std::uint64_t local_bytes = 0;   ///< local memory of a work-group
    std::uint64_t private_bytes = 0; ///< memory of a work-item, beside registers
    std::uint32_t registers = 0;     ///< of a work-item; 0: the driver does not tell
    /// The work-items whose registers one processor of the device holds; 0: the driver does not
    /// tell.
    std::uint32_t resident = 0;

    bool operator==(const KernelResources&) const = default; ///< Whether all numbers are equal.
};

/// A launch on a device of the kind "perf". A CPU's events are those of all threads of this
/// process, outside of the system; other work of the process counts too.
struct PerfCounts {
    std::string kernel;     ///< its name
    std::uint64_t time = 0; ///< nanoseconds from the launch until it was done
    /// Nanoseconds that all threads together ran. Nothing if the device is no CPU; the next three
    /// neither.
    std::optional<std::uint64_t> cpu_time{};
    std::optional<std::uint64_t> cycles{};       ///< nothing if the system does not let it be read
    std::optional<std::uint64_t> instructions{}; ///< likewise
    std::optional<std::uint64_t> cache_misses{}; ///< likewise: those of the last cache
    KernelResources resources{};                 ///< what the driver tells
};

/// Registers the device kind "perf": kernels on another device, with a wait after each launch, what
/// the CPU counts meanwhile, and what the driver tells. DeviceOptions::device names that device:
/// "cpp", also if empty, or "opencl:<platform>[:<device>]". Must be called before any thread uses
/// the library; a second call does nothing.
LINEATLAS_API void register_perf_device();

/// The launches of devices of the kind "perf" since the last call, in order. Must not be called
/// while such a device works.
LINEATLAS_API std::vector<PerfCounts> take_perf_counts();

/// Why PerfCounts have no cycles, instructions and cache misses on this machine, as one line; empty
/// if they have.
LINEATLAS_API std::string why_no_perf_events();

/// The highest rates that a device reaches.
struct Roofs {
    double copy = 0;       ///< 10^9 bytes a second: FrameProfile::copy_gigabytes_per_second
    double arithmetic = 0; ///< 10^9 operations of floats a second; 0 if it is not known
};

/// Roofs::arithmetic of a device, named as for "perf": products and sums in registers, without
/// contraction, on all its processors. Takes a fifth of a second. 0 if the device's compiler
/// refuses the kernel that measures.
LINEATLAS_API double measure_arithmetic(const std::string& device = "cpp");

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
    KernelResources resources{};   ///< what the driver tells of it
    /// Cores that work during a launch: their CPU time over the time of the launch. Nothing without
    /// PerfCounts::cpu_time; the next three neither.
    std::optional<double> cores{};
    std::optional<double> cycles{};       ///< of a launch, mean
    std::optional<double> instructions{}; ///< of a launch, mean
    std::optional<double> cache_misses{}; ///< of a launch, mean
};

/// Every kernel of the frames, the longest sum first. `counts`: the launches of one such frame. The
/// k-th launch of a kernel in a frame gets the k-th count of that kernel; if the numbers of
/// launches differ, every launch gets an equal part of all counts. `perf`: likewise.
LINEATLAS_API std::vector<KernelTime> kernel_times(std::span<const FrameProfile> frames,
                                                   std::span<const LaunchCounts> counts,
                                                   const Roofs& roofs,
                                                   std::span<const PerfCounts> perf = {});

/// Two tables for people: times and bounds, then the CPU's events and what the driver tells.
LINEATLAS_API std::string kernel_table(std::span<const KernelTime> kernels, const Roofs& roofs);
/// The same as CSV: a header, then a row per kernel.
LINEATLAS_API std::string kernel_csv(std::span<const KernelTime> kernels, const Roofs& roofs);
/// The same as JSON, with the members "roofs" and "kernels"; docs/profiling.md has the keys.
LINEATLAS_API std::string kernel_json(std::span<const KernelTime> kernels, const Roofs& roofs);
/// profile_trace(), in which each launch also has the figures of its kernel, by the keys of
/// kernel_json().
LINEATLAS_API std::string kernel_trace(std::span<const FrameProfile> frames,
                                       std::span<const KernelTime> kernels,
                                       const std::string& description);
/// The roofline (Williams, Waterman and Patterson 2009) as SVG: operations a second over operations
/// per byte, with a dot for each kernel that was counted and computes with floats. The title of a
/// dot has the figures of the tables.
LINEATLAS_API std::string roofline_svg(std::span<const KernelTime> kernels, const Roofs& roofs);

} // namespace lineatlas
