#pragma once

#include <array>
#include <cstdint>
#include <numeric>

/// A layer between the OpenCL loader and the drivers (OPENCL_LAYERS). It lets chosen calls fail and
/// makes devices smaller than they are. It counts builds, forms of kernels that are launched for
/// the first time, and references: objects that were created or retained and are not released yet.
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
    /// The status that a failed command returns.
    int status = -5; // CL_OUT_OF_RESOURCES
    /// The failed command seems to succeed, and the next wait for it returns the error.
    bool late = false;
    /// All commands after the failed one, and all creations, fail too.
    bool lost = false;

    /// Bytes of the device's memory, and of its largest buffer; 0: the driver's own. The layer
    /// starts with the values of LINEATLAS_TEST_MEMORY and LINEATLAS_TEST_BUFFER.
    std::uint64_t memory = 0, largest_buffer = 0;
    /// Work-items of the device's largest work-group; 0: the driver's own. The layer starts with
    /// the value of LINEATLAS_TEST_GROUP.
    std::size_t largest_group = 0;
    bool says_limits = true;     ///< the device tells these limits when it is asked; kernels always
                                 ///< tell theirs
    std::uint64_t allocated = 0; ///< bytes of the memory that buffers take

    int builds = 0; ///< of programs, since it was set to 0
    /// period: the number of a period of launches; 0: launches are not watched. A form is a kernel
    /// of a program with its options, and a size of work-groups. new_forms: the forms launched for
    /// the first time in this period, counted since it was set to 0. new_form: the last of them.
    int period = 0, new_forms = 0;
    const char* new_form = "";

    /// All contexts made from now on together build each program only once (quick_builds.hpp).
    bool builds_once = false;

    /// Sets the initial values, except for the counts of objects that still exist.
    void reset() {
        *this = {.references = references, .allocated = allocated, .builds_once = builds_once};
    }

    long live() const { return std::accumulate(references.begin(), references.end(), 0L); }
};

/// The type of the function that the layer exports.
using GetOpenClFaults = OpenClFaults*();
inline constexpr const char* opencl_faults_symbol = "lineatlas_test_opencl_faults";

} // namespace lineatlas::test
