#include "opencl_command_log.hpp"

#include <algorithm>
#include <limits>

#include "core/host_clock.hpp"

namespace lineatlas::compute {
namespace {

struct DeviceTimes {
    std::int64_t queued, start, end;
};

template <cl_profiling_info what>
std::int64_t time_of(const cl::Event& event) {
    return static_cast<std::int64_t>(event.getProfilingInfo<what>());
}

/// The number to add to a device's time for the host's time, as far as it is known.
class Offset {
  public:
    /// Adds a reading: the device's clock was `device` at some time from `before` to `after` on the
    /// host's clock.
    void add(std::int64_t device, std::int64_t before, std::int64_t after) {
        low_ = std::max(low_, before - device);
        high_ = std::min(high_, after - device);
    }
    std::int64_t value() const { return low_ + (high_ - low_) / 2; }
    /// How wrong the offset may be. Clocks that run at different speeds have no single offset;
    /// their brackets miss each other by the drift.
    std::int64_t error() const { return (std::max(low_, high_) - std::min(low_, high_) + 1) / 2; }

  private:
    std::int64_t low_ = std::numeric_limits<std::int64_t>::min();
    std::int64_t high_ = std::numeric_limits<std::int64_t>::max();
};

/// Some drivers (rusticl of Mesa 22.3) return the same numbers for every command.
bool is_clock(const std::vector<DeviceTimes>& times) {
    return times.size() > 1 && times.front().queued != times.back().queued;
}

} // namespace

OpenClCommandLog::Pending::Pending(OpenClCommandLog* log, const Command& command) : log_(log) {
    if (log_ == nullptr) return;
    entry_.command = command;
    entry_.before = host_nanoseconds();
}

OpenClCommandLog::Pending::~Pending() {
    if (log_ == nullptr || entry_.event() == nullptr) return; // the call has failed
    entry_.after = host_nanoseconds();
    log_->entries_.push_back(std::move(entry_));
}

bool OpenClCommandLog::complete() const {
    if (entries_.empty()) return true;
    // The queue is in order. A negative status is an error, which read() reports.
    cl_int status = CL_COMPLETE;
    clGetEventInfo(entries_.back().event(), CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof(status),
                   &status, nullptr);
    return status <= CL_COMPLETE;
}

std::vector<CommandTime> OpenClCommandLog::read() {
    std::vector<DeviceTimes> times;
    try {
        if (!entries_.empty()) entries_.back().event.wait();
        for (const Pending::Entry& entry : entries_) {
            times.push_back({time_of<CL_PROFILING_COMMAND_QUEUED>(entry.event),
                             time_of<CL_PROFILING_COMMAND_START>(entry.event),
                             time_of<CL_PROFILING_COMMAND_END>(entry.event)});
        }
    } catch (const cl::Error&) {
        return {}; // CL_PROFILING_INFO_NOT_AVAILABLE: a device need not keep times
    }
    if (!is_clock(times)) return {};
    Offset offset;
    for (std::size_t i = 0; i < times.size(); ++i) {
        offset.add(times[i].queued, entries_[i].before, entries_[i].after);
    }
    error_ = offset.error();
    std::vector<CommandTime> commands;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Command& command = entries_[i].command;
        commands.push_back({command.name, entries_[i].before, times[i].start + offset.value(),
                            times[i].end + offset.value(), command.items, command.group,
                            command.bytes});
    }
    return commands;
}

} // namespace lineatlas::compute
