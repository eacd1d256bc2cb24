#include "common.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>

#include "compute/cpp/cpp_device.hpp"
#include "core/median.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::bench {

Devices make_devices(std::unique_ptr<compute::OpenClBackend> opencl) {
    Devices devices{.opencl = std::move(opencl),
                    .cpp = compute::make_cpp_device(),
                    .opencl_stages = {},
                    .cpp_stages = {}};
    devices.opencl_stages = std::make_unique<compute::Stages>(*devices.opencl);
    devices.cpp_stages = std::make_unique<compute::Stages>(*devices.cpp);
    return devices;
}

Devices open_devices(std::string name, const std::string& form) {
    if (name.empty()) {
        if (const char* variable = std::getenv("LINEATLAS_DEVICE")) name = variable;
    }
    if (name.empty()) name = "opencl";
    const compute::OpenClDevice device = compute::find_opencl_devices(name).front();
    compute::OpenClDevice launched_as = device;
    if (!form.empty()) {
        launched_as.is_cpu = form == "cpu";
        launched_as.is_gpu = form == "gpu";
    }
    return make_devices(compute::make_opencl_backend(device, {}, compute::tuning_for(launched_as)));
}

Rows all_rows(const Devices& devices) {
    Rows result;
    for (const auto rows_of :
         {copy_rows,         transform_rows, depth_rows,   planes_rows,     pyramid_rows,
          cull_rows,         facing_rows,    contour_rows, silhouette_rows, chain_rows,
          project_clip_rows, scan_rows,      carry_rows,   atlas_rows,      temporal_rows,
          intervals_rows,    compact_rows,   halo_rows,    filter_rows,     density_rows,
          exact_rows,        outline_rows,   pens_rows,    fill_rows,       strokes_rows,
          vector_path_rows}) {
        std::ranges::move(rows_of(devices), std::back_inserter(result));
    }
    return result;
}

double seconds_of(const Job& job) {
    if (job.reset) job.reset();
    const auto start = std::chrono::steady_clock::now();
    job.run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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

double copy_limit(const Devices& devices, std::uint32_t n) {
    static std::map<std::uint32_t, double> known;
    const auto found = known.find(n);
    if (found != known.end()) return found->second;
    std::vector<Job> jobs;
    for (const Row& row : copy_rows(devices)) {
        if (row.name.starts_with("copy/device")) jobs.push_back(row.prepare(n));
    }
    // Small sizes get more rounds, so that every size takes about the same time.
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

namespace {

/// True if integers are equal, or floats agree within 1e-5. One float in ten thousand may differ:
/// where a line just reaches another line, rounding decides.
bool is_equal(const Result& a, const Result& b) {
    if (!std::holds_alternative<std::vector<float>>(a)) return a == b;
    const auto &first = std::get<std::vector<float>>(a), &second = std::get<std::vector<float>>(b);
    if (first.size() != second.size()) return false;
    std::size_t other = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (std::fabs(first[i] - second[i]) > 1e-5F * std::max(1.0F, std::fabs(first[i]))) ++other;
    }
    return other <= first.size() / 10000;
}

} // namespace

Rows own_rows(const Devices& devices, const std::string& stage, Prepare prepare) {
    const auto ours = [&devices, stage, prepare](std::uint32_t n) {
        Job job = prepare(*devices.opencl_stages, n);
        require(is_equal(job.result(), prepare(*devices.cpp_stages, n).result()), stage);
        return job;
    };
    const auto cpp = [&devices, prepare](std::uint32_t n) {
        return prepare(*devices.cpp_stages, n);
    };
    return {{stage + "/ours", ours}, {stage + "/cpp", cpp}};
}

} // namespace lineatlas::bench
