#pragma once

#include <string>

namespace lineatlas {

/// Which compute backend and device, and how it shares buffers with GL. Empty: the best there is.
struct DeviceOptions {
    /// "opencl", "cpp" or another (docs/backends.md); empty: for a Renderer OpenCL, else cpp where
    /// no driver works, which Renderer::note() says then; for a LineVisibility cpp.
    std::string compute{};
    std::string device{}; ///< "opencl:<platform>[:<device>]"; see `lineatlas devices`
    /// "gl-sharing", "external-memory", "host-pointer", "copy" or "": chosen. Not for
    /// LineVisibility, which shares nothing.
    std::string interop{};
    /// For finding errors, slow: every kernel runs with the same input on this backend or OpenCL
    /// device too ("cpp", "opencl:<platform>[:<device>]"), and the first that differs ends
    /// the frame with MismatchError. Not with gl-sharing or external-memory. Empty: nothing is
    /// compared.
    std::string compare_with{};
    std::string compare_until{}; ///< the last stage to compare, e.g. "scan"; empty: all
    /// For a Renderer that draws one picture. Where nothing is said above, the environment names no
    /// device and GL is a software one, it takes cpp: a driver of OpenCL would start for longer
    /// than its kernels are faster. A LineVisibility gives up its working tables when it has found
    /// something, and makes them anew if it is asked again.
    bool one_picture = false;
};

} // namespace lineatlas
