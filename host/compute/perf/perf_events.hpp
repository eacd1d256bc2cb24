#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace lineatlas::compute {

/// A kind of event that the system counts: perf_event_attr::type and ::config.
struct PerfEvent {
    std::uint32_t type;
    std::uint64_t config;
};

/// Cycles, instructions and misses of the last cache, in this order.
std::span<const PerfEvent> cpu_events();

/// What one counter of the system holds. It counts while the processor has room for it; times are
/// nanoseconds.
struct PerfReading {
    std::uint64_t count = 0;
    std::uint64_t enabled = 0; ///< how long it was to count
    std::uint64_t running = 0; ///< how long it has counted
};

/// How often each of `kinds` events happened between two readings of all counters, which stand as
/// PerfEvents::read() returns them. If a counter counted only part of that time, that part is
/// scaled up.
std::vector<std::uint64_t> events_between(std::span<const PerfReading> before,
                                          std::span<const PerfReading> after, std::size_t kinds);

/// Counts events of all threads of this process, outside of the system (perf_event_open). Threads
/// that begin later count too.
class PerfEvents {
  public:
    /// Counts from this call on, or nothing if the system refuses one of the events. `threads`: the
    /// folder in which the system lists the threads of this process.
    explicit PerfEvents(std::span<const PerfEvent> events,
                        const std::filesystem::path& threads = "/proc/self/task");
    ~PerfEvents();
    PerfEvents(const PerfEvents&) = delete;
    PerfEvents& operator=(const PerfEvents&) = delete;

    /// Why nothing is counted; empty if events are.
    const std::string& refusal() const { return refusal_; }
    /// The counters of all events, one thread after the other; empty if nothing is counted.
    std::vector<PerfReading> read() const;
    /// How often each event has happened since `before` was read, in the order of the constructor.
    /// `before` must not be empty.
    std::vector<std::uint64_t> since(std::span<const PerfReading> before) const;

  private:
    void open(std::uint32_t thread, const PerfEvent& event);
    void close();

    std::size_t kinds_;
    std::vector<int> files_; ///< the events of each thread, one thread after the other
    std::string refusal_;
};

} // namespace lineatlas::compute
