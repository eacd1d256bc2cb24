#include "perf_events.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <system_error>

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace lineatlas::compute {
namespace {

constexpr PerfEvent of_cpu[] = {{PERF_TYPE_HARDWARE, PERF_COUNT_HW_CPU_CYCLES},
                                {PERF_TYPE_HARDWARE, PERF_COUNT_HW_INSTRUCTIONS},
                                {PERF_TYPE_HARDWARE, PERF_COUNT_HW_CACHE_MISSES}};

/// The numbers of this process's threads, listed in `folder`; none if the system does not show
/// them.
std::vector<std::uint32_t> threads_in(const std::filesystem::path& folder) {
    std::vector<std::uint32_t> all;
    std::error_code error;
    std::filesystem::directory_iterator entry{folder, error};
    for (; !error && entry != std::filesystem::directory_iterator{}; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        std::uint32_t number = 0;
        std::from_chars(name.data(), name.data() + name.size(), number);
        all.push_back(number);
    }
    return all;
}

/// What the system's answer means for the user.
std::string meaning_of(int error) {
    if (error == ENOENT || error == EOPNOTSUPP)
        return "the system offers no counters of the processor, as in most virtual machines";
    if (error == EACCES || error == EPERM)
        return "the system forbids it; /proc/sys/kernel/perf_event_paranoid must be 2 or less";
    if (error == EMFILE || error == ENFILE)
        return "the process has too many threads for its limit of open files (ulimit -n)";
    return std::string{"perf_event_open says \""} + std::strerror(error) + '"';
}

} // namespace

std::span<const PerfEvent> cpu_events() {
    return of_cpu;
}

std::vector<std::uint64_t> events_between(std::span<const PerfReading> before,
                                          std::span<const PerfReading> after, std::size_t kinds) {
    std::vector<std::uint64_t> sums(kinds);
    for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
        // The counts themselves never fall. A count that was scaled up may, since its scale does.
        if (after[i].count < before[i].count) continue; // the second reading failed
        const std::uint64_t count = after[i].count - before[i].count;
        const std::uint64_t enabled = after[i].enabled - before[i].enabled;
        const std::uint64_t running = after[i].running - before[i].running;
        const bool is_whole = running == enabled || running == 0;
        sums[i % kinds] += is_whole ? count
                                    : static_cast<std::uint64_t>(static_cast<double>(count) *
                                                                 static_cast<double>(enabled) /
                                                                 static_cast<double>(running));
    }
    return sums;
}

PerfEvents::PerfEvents(std::span<const PerfEvent> events, const std::filesystem::path& threads)
    : kinds_(events.size()) {
    const std::vector<std::uint32_t> all = threads_in(threads);
    if (all.empty())
        refusal_ = "the system does not list the threads of the process in " + threads.string();
    for (const std::uint32_t thread : all)
        for (const PerfEvent& event : events)
            if (refusal_.empty()) open(thread, event);
    if (!refusal_.empty()) close();
}

PerfEvents::~PerfEvents() {
    close();
}

void PerfEvents::open(std::uint32_t thread, const PerfEvent& event) {
    perf_event_attr attributes{};
    attributes.size = sizeof attributes;
    attributes.type = event.type;
    attributes.config = event.config;
    attributes.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
    attributes.inherit = 1;
    attributes.exclude_kernel = 1;
    attributes.exclude_hv = 1;
    const long file =
        ::syscall(SYS_perf_event_open, &attributes, thread, -1, -1, PERF_FLAG_FD_CLOEXEC);
    if (file >= 0) {
        files_.push_back(static_cast<int>(file));
    } else if (errno == ESRCH) {
        files_.push_back(-1); // the thread has ended
    } else {
        refusal_ = meaning_of(errno);
    }
}

void PerfEvents::close() {
    for (const int file : files_)
        if (file >= 0) ::close(file);
    files_.clear();
}

std::vector<PerfReading> PerfEvents::read() const {
    std::vector<PerfReading> all(files_.size());
    for (std::size_t i = 0; i < files_.size(); ++i) {
        PerfReading own;
        if (files_[i] >= 0 && ::read(files_[i], &own, sizeof own) == sizeof own) all[i] = own;
    }
    return all;
}

std::vector<std::uint64_t> PerfEvents::since(std::span<const PerfReading> before) const {
    return events_between(before, read(), kinds_);
}

} // namespace lineatlas::compute
