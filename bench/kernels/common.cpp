#include "common.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>

#include "lineatlas/error.hpp"

namespace lineatlas::bench {

Backends open_backends(std::string name) {
    if (name.empty()) {
        if (const char* variable = std::getenv("LINEATLAS_DEVICE")) name = variable;
    }
    if (name.empty()) name = "opencl";
    return {.device = compute::make_opencl_backend(compute::find_opencl_devices(name).front()),
            .reference = compute::make_reference_backend()};
}

double seconds_of(const Job& job) {
    if (job.reset) job.reset();
    const auto start = std::chrono::steady_clock::now();
    job.run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

std::vector<double> race(const std::vector<Job>& jobs, int rounds) {
    std::vector<std::vector<double>> seconds(jobs.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            jobs[i].run();
            seconds[i].push_back(seconds_of(jobs[i]));
        }
    }
    std::vector<double> result;
    for (std::vector<double>& of_job : seconds) result.push_back(median(std::move(of_job)));
    return result;
}

double copy_limit(const Backends& backends, std::uint32_t n) {
    static std::map<std::uint32_t, double> known;
    const auto found = known.find(n);
    if (found != known.end()) return found->second;
    std::vector<Job> jobs;
    for (const Row& row : copy_rows(backends)) {
        if (row.name.starts_with("copy/device")) jobs.push_back(row.prepare(n));
    }
    // As long for every size as one of the largest takes for a few rounds.
    const int rounds = static_cast<int>(std::clamp(0x1p27 / n, 15.0, 1000.0));
    double best = 0;
    const std::vector<double> seconds = race(jobs, rounds);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        best = std::max(best, jobs[i].bytes / seconds[i]);
    }
    return known[n] = best;
}

void require(bool right, const std::string& row) {
    if (!right) throw Error(row + " gave a wrong result");
}

} // namespace lineatlas::bench
