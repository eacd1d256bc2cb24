#pragma once

#include <array>
#include <cstdint>
#include <numeric>

/// A layer between the OpenCL loader and the drivers (OPENCL_LAYERS) that lets chosen calls fail,
/// makes devices smaller than they are, and counts references, which are what was created or
/// retained and not released yet, builds, and what is launched for the first time.
namespace lineatlas::test {

enum ClKind { cl_contexts, cl_queues, cl_memory, cl_programs, cl_kernels, cl_events, cl_kinds };

using ClCounts = std::array<long, cl_kinds>;

struct OpenClFaults {
    int fail_creation = 0;  ///< the n-th creation from now on fails, 0: none
    int fail_command = 0;   ///< the n-th command from now on fails, 0: none
    int fail_argument = -1; ///< arguments of this index are refused, -1: none
    int creations = 0;      ///< since it was set to 0, failed ones too
    int commands = 0;       ///< since it was set to 0, failed ones too
    ClCounts references{};
    /// What a failed command returns.
    int status = -5; // CL_OUT_OF_RESOURCES
    /// The failed command seems to succeed: the next wait for it says that something went wrong.
    bool late = false;
    /// All commands after the failed one, and all creations, fail too.
    bool lost = false;

    /// The device's memory, and what one buffer of it holds, in bytes; 0: the driver's own. The
    /// layer's first values are those of LINEATLAS_TEST_MEMORY and LINEATLAS_TEST_BUFFER.
    std::uint64_t memory = 0, largest_buffer = 0;
    /// Work-items of its work-groups, the same way, by LINEATLAS_TEST_GROUP.
    std::size_t largest_group = 0;
    bool says_limits = true;     ///< programs can ask the device for these; kernels say theirs
    std::uint64_t allocated = 0; ///< of the memory, by buffers

    int builds = 0; ///< of programs, since it was set to 0
    /// Above 0: a period, in which launches are looked at. `new_forms`: of how many kernels the
    /// first in that period, of a program with its options and work-groups of a size, was made
    /// since it was set to 0, and the last of them.
    int period = 0, new_forms = 0;
    const char* new_form = "";

    /// Contexts made from now on build a program once in all their lives (quick_builds.hpp).
    bool builds_once = false;

    /// As it began, but for what is still there.
    void reset() {
        *this = {.references = references, .allocated = allocated, .builds_once = builds_once};
    }

    long live() const { return std::accumulate(references.begin(), references.end(), 0L); }
};

/// The layer exports this.
using GetOpenClFaults = OpenClFaults*();
inline constexpr const char* opencl_faults_symbol = "lineatlas_test_opencl_faults";

} // namespace lineatlas::test
