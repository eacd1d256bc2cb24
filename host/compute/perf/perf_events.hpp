#pragma once

#include <cstdint>
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

/// Counts events of all threads of this process, outside of the system (perf_event_open). Threads
/// that begin later count too.
class PerfEvents {
  public:
    /// Counts from this call on, or nothing if the system refuses one of the events.
    explicit PerfEvents(std::span<const PerfEvent> events);
    ~PerfEvents();
    PerfEvents(const PerfEvents&) = delete;
    PerfEvents& operator=(const PerfEvents&) = delete;

    /// Why nothing is counted; empty if events are.
    const std::string& refusal() const { return refusal_; }
    /// How often each event has happened so far, in the order of the constructor; empty if nothing
    /// is counted. If the processor counted only part of the time, that part is scaled up.
    std::vector<std::uint64_t> read() const;

  private:
    void open(std::uint32_t thread, const PerfEvent& event);
    void close();

    std::size_t kinds_;
    std::vector<int> files_; ///< the events of each thread, one thread after the other
    std::string refusal_;
};

} // namespace lineatlas::compute
