#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace lineatlas::compute {

/// A kernel or a transfer that a device has run. Times are nanoseconds of
/// std::chrono::steady_clock.
struct CommandTime {
    const char* name;
    std::int64_t submitted; ///< when the host did it
    std::int64_t start, end;
};

/// The commands that a backend gets while it keeps this log, in order.
class CommandLog {
  public:
    virtual ~CommandLog() = default;

    /// Whether all of them have run; doesn't wait.
    virtual bool complete() const = 0;
    /// Their times, with a wait if not complete(); none if the device keeps no times.
    virtual std::vector<CommandTime> read() = 0;
    /// How far the times read may be off those of the host, in nanoseconds.
    virtual std::optional<std::int64_t> error() const = 0;
};

} // namespace lineatlas::compute
