#include "watch.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "common.hpp"
#include "compute/kernels.hpp"
#include "core/median.hpp"
#include "lineatlas/error.hpp"
#include "sources/kernel_folder.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::chrono::milliseconds between_looks{50};

/// The row "<stage>/<way>" of a stage, or of the stage of a kernel.
const Row* find_row(const Rows& rows, const std::string& name, const std::string& way) {
    const auto of = [&](const std::string& stage) {
        const auto found = std::ranges::find(rows, stage + "/" + way, &Row::name);
        return found != rows.end() ? &*found : nullptr;
    };
    if (const Row* row = of(name)) return row;
    const auto kernel = std::ranges::find(compute::all_kernels(), name, &compute::Kernel::name);
    return kernel != compute::all_kernels().end() ? of(std::string{kernel->stage}) : nullptr;
}

const Row& row_of(const Rows& rows, const std::string& name, const std::string& way) {
    if (const Row* row = find_row(rows, name, way)) return *row;
    throw UsageError("--watch: no row measures \"" + name +
                     "\"; --list has the stages, `lineatlas kernels` their kernels");
}

struct Times {
    std::vector<double> ours, cpp; ///< seconds per run
};

/// Times both jobs by turns for half a second, but at least three times.
Times time_by_turns(const Job& ours, const Job& cpp) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::milliseconds{500};
    Times times;
    while (times.ours.size() < 3 || Clock::now() < end) {
        times.ours.push_back(seconds_of(ours));
        times.cpp.push_back(seconds_of(cpp));
    }
    return times;
}

std::string ratio(double now, const std::optional<double>& before) {
    return before ? fmt::format("{:.3f}", now / *before) : "-";
}

/// Prints the rows of a table, each compared with earlier rows.
class Report {
  public:
    void begin(const Watched& watched, const KernelFolder& folder, const Devices& devices) {
        std::cout << fmt::format("{} at {} elements on {}: edit {}, end with Ctrl-C\n",
                                 watched.name, watched.size, devices.opencl->description(),
                                 folder.path().string())
                  << fmt::format("{:>11}{:>9}{:>9}{:>9}{:>9}{:>11}{:>9}\n", "median us", "10 %",
                                 "90 %", "to last", "to first", "C++ us", "to C++")
                  << std::flush;
    }

    void add(const Times& times) {
        const double now = 1e6 * median(times.ours), cpp = 1e6 * median(times.cpp);
        std::cout << fmt::format("{:>11.1f}{:>9.1f}{:>9.1f}{:>9}{:>9}{:>11.1f}{:>9.3f}\n", now,
                                 1e6 * quantile(times.ours, 0.1), 1e6 * quantile(times.ours, 0.9),
                                 ratio(now, last_), ratio(now, first_), cpp, now / cpp)
                  << std::flush;
        last_ = now;
        if (!first_) first_ = now;
    }

    static void add_failure(const Error& error) { std::cout << error.what() << std::endl; }

  private:
    std::optional<double> first_, last_; ///< medians, microseconds
};

} // namespace

void watch(const Watched& watched) {
    KernelFolder folder;
    if (!folder.is_set()) {
        throw UsageError("--watch needs LINEATLAS_KERNEL_DIR, a folder of kernels to edit: a copy "
                         "of /usr/share/lineatlas/kernels or, in the sources, of kernels");
    }
    Report report;
    {
        const Devices devices = open_devices(watched.device, watched.form);
        row_of(all_rows(devices), watched.name, "ours");
        report.begin(watched, folder, devices);
    }
    for (;;) {
        try {
            const Devices devices = open_devices(watched.device, watched.form);
            const Rows rows = all_rows(devices);
            // prepare() also compares the results with those of `cpp`.
            const Job ours = row_of(rows, watched.name, "ours").prepare(watched.size);
            report.add(
                time_by_turns(ours, row_of(rows, watched.name, "cpp").prepare(watched.size)));
        } catch (const Error& error) {
            Report::add_failure(error);
        }
        while (!folder.has_changed()) std::this_thread::sleep_for(between_looks);
    }
}

} // namespace lineatlas::bench
