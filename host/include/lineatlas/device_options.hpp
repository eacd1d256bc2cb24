#pragma once

#include <string>

/// @file
/// The choice of the compute device, and of its way to share buffers with GL.
/// @code{.cpp}
/// Renderer here{{.compute = "opencl", .device = "opencl:portable", .interop = "copy"}};
/// LineVisibility there{lines, {.compute = "cpp"}};
/// @endcode

namespace lineatlas {

/// The compute backend, its device, and how it shares buffers with GL. Empty members mean the best
/// choice.
struct DeviceOptions {
    /// "opencl", "cpp" or another (docs/backends.md). Empty: a Renderer takes OpenCL, or cpp if no
    /// driver works (then Renderer::note() says so); a LineVisibility takes cpp.
    std::string compute{};
    std::string device{}; ///< "opencl:<platform>[:<device>]"; see `lineatlas devices`
    /// "gl-sharing", "external-memory", "host-pointer" or "copy"; empty: the best that works. Not
    /// for LineVisibility, which shares no buffers.
    std::string interop{};
    /// For finding errors; slow. Every kernel also runs on this backend or OpenCL device ("cpp",
    /// "opencl:<platform>[:<device>]") with the same input, and the first difference ends the frame
    /// with MismatchError. Not with gl-sharing or external-memory. Empty: no comparison.
    std::string compare_with{};
    std::string compare_until{}; ///< the last stage to compare, e.g. "scan"; empty: all
    /// For a Renderer that draws one picture. It takes cpp if the members above are empty, the
    /// environment names no device, and GL is a software one: an OpenCL driver would take longer to
    /// start than its kernels save. A LineVisibility frees its working tables after each call of
    /// find(), and makes them anew for the next.
    bool one_picture = false;
};

} // namespace lineatlas
