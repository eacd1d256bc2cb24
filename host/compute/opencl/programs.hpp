#pragma once

#include <map>
#include <string>

#include "devices.hpp"

namespace lineatlas::compute {

/// A kernel of a program that is built when one of its kernels is first used: looking at a source
/// takes some drivers 20 ms even if they know it, and few frames need all of them.
struct LazyKernel {
    const char* file;
    const char* name;
    std::string defines{};
    cl::Kernel kernel{};
};

/// The programs of one context, each built once.
class Programs {
  public:
    Programs(const OpenClDevice& device, cl::Context context);

    /// The kernel, built if this is its first use. Throws DeviceError, with the whole build log if
    /// it doesn't build.
    cl::Kernel& ready(LazyKernel& lazy);

  private:
    cl::Program build(const std::string& file, const std::string& defines) const;

    OpenClDevice device_;
    cl::Context context_;
    std::string common_options_;
    std::map<std::string, cl::Program> programs_; ///< by file and defines
};

} // namespace lineatlas::compute
