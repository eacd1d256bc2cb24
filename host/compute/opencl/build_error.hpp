#pragma once

#include <string>
#include <string_view>

#include "lineatlas/error.hpp"

namespace lineatlas::compute {

/// A driver does not build a kernel, or builds one that computes wrong results (device_trial.hpp).
/// The message is one line with the kernel and the first error.
class BuildError : public DeviceError {
  public:
    using DeviceError::DeviceError;
};

/// The first error that a compiler's log names, or else its first line, cut if it is long. Empty if
/// the log is empty. A place in the whole `source` becomes a place in the file that #line
/// directives name, because rusticl of Mesa 26.1 ignores these.
std::string first_error(std::string_view log, std::string_view source);

/// Adds `log` under `title` to the file that the environment variable LINEATLAS_BUILD_LOG names.
/// Returns text for a message: where the whole log is, or how to get it.
std::string keep_build_log(std::string_view title, std::string_view log);

} // namespace lineatlas::compute
