#pragma once

#include <string>

namespace lineatlas::compute {

/// The OpenCL library of this machine, libOpenCL.so.1. It is opened at the first call of one of its
/// functions, so that programs start, and draw by C++, on machines without it.
struct OpenClLibrary {
    bool works = false;
    bool in_front = false; ///< it stands before the loader, as a debugger of kernels does
    std::string cause{};   ///< why it does not work

    /// A function of the library, which must exist.
    void* function(const char* name) const;

    void* handle = nullptr; ///< of dlopen()
};

/// The library; the same object in all calls.
const OpenClLibrary& opencl_library();

} // namespace lineatlas::compute
