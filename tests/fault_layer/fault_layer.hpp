#pragma once

/// A layer between the OpenCL loader and a driver (OPENCL_LAYERS) that lets chosen calls fail and
/// counts what is made and not released.
namespace lineatlas::test {

struct OpenClFaults {
    int fail_creation = 0; ///< the n-th creation from now on fails, 0: none
    int fail_command = 0;  ///< the n-th command from now on fails, 0: none
    int creations = 0;     ///< since it was set to 0, failed ones too
    int commands = 0;      ///< since it was set to 0, failed ones too
    long live = 0;         ///< references to contexts, queues, buffers, programs and kernels
};

/// The layer exports this.
using GetOpenClFaults = OpenClFaults*();
inline constexpr const char* opencl_faults_symbol = "lineatlas_test_opencl_faults";

} // namespace lineatlas::test
