#pragma once

#include <stdexcept>
#include <string>

#include "lineatlas/export.hpp"

/// @file
/// The exceptions of the library.
/// @code{.cpp}
/// try {
///     renderer.draw(camera, options, framebuffer);
/// } catch (const DeviceError& error) { // the machine cannot; a UsageError would be the program's
///     std::cerr << error.what() << '\n';
/// }
/// @endcode

namespace lineatlas {

/// Base of every exception the library throws on purpose. The message is one line that names the
/// thing, the cause and, where there is one, the way out. It is text that a terminal can show:
/// UTF-8 of at most 2,000 bytes, in which "?" replaces control characters of names from a file.
class LINEATLAS_API Error : public std::runtime_error {
  public:
    /// With that message, made safe for a terminal.
    explicit Error(const std::string& message);

  protected:
    /// `log`, if there is one, follows the message in lines of its own, whole.
    Error(const std::string& message, const std::string& log);
};

/// The caller asked for something that does not exist or makes no sense (an unknown pen, a size of
/// zero, a camera with NaN). The tool ends with exit code 2.
class LINEATLAS_API UsageError : public Error {
  public:
    using Error::Error;
};

/// A file could not be read or written, or its contents are not what its name or header says.
class LINEATLAS_API FileError : public Error {
  public:
    using Error::Error;
};

/// The machine cannot do what was asked: no device, no memory, a driver that refused. The message
/// says which package or option helps. If a kernel or shader does not build, the driver's log
/// follows.
class LINEATLAS_API DeviceError : public Error {
  public:
    using Error::Error;
    /// With that message, and the log behind it.
    DeviceError(const std::string& message, const std::string& log) : Error(message, log) {}
};

/// Two compute backends disagree where they must not (DeviceOptions::compare_with). The message
/// names the stage, the element and both values.
class LINEATLAS_API MismatchError : public Error {
  public:
    using Error::Error;
};

} // namespace lineatlas
