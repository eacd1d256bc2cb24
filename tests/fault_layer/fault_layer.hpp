#pragma once

#include <array>
#include <numeric>

/// A layer between the OpenCL loader and the drivers (OPENCL_LAYERS) that lets chosen calls fail
/// and counts references: what was created or retained and not released yet.
namespace lineatlas::test {

enum ClKind { cl_contexts, cl_queues, cl_memory, cl_programs, cl_kernels, cl_events, cl_kinds };

using ClCounts = std::array<long, cl_kinds>;

struct OpenClFaults {
    int fail_creation = 0; ///< the n-th creation from now on fails, 0: none
    int fail_command = 0;  ///< the n-th command from now on fails, 0: none
    int creations = 0;     ///< since it was set to 0, failed ones too
    int commands = 0;      ///< since it was set to 0, failed ones too
    ClCounts references{};

    long live() const { return std::accumulate(references.begin(), references.end(), 0L); }
};

/// The layer exports this.
using GetOpenClFaults = OpenClFaults*();
inline constexpr const char* opencl_faults_symbol = "lineatlas_test_opencl_faults";

} // namespace lineatlas::test
