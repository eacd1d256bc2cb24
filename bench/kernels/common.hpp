#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "compute/opencl/opencl_backend.hpp"

namespace lineatlas::bench {

/// What rows are measured on: one OpenCL device, and plain C++ beside it.
struct Backends {
    std::unique_ptr<compute::OpenClBackend> device;
    std::unique_ptr<compute::Backend> reference;
};

/// The device is `name`, else LINEATLAS_DEVICE, else the first. Throws as find_opencl_devices does.
Backends open_backends(std::string name);

/// One row at one size, ready to be timed.
struct Job {
    std::function<void()> run;     ///< all of the work; returns when it is done
    double bytes = 0;              ///< counted per run; every stage's file says what is counted
    std::function<void()> reset{}; ///< if set, restores what a run overwrites; not timed
    /// What a run leaves, where `prepare` doesn't know what is right.
    std::function<std::vector<std::uint8_t>()> result{};
};

/// A way of doing a stage.
struct Row {
    std::string name; ///< "<stage>/<way>"
    std::function<Job(std::uint32_t n)>
        prepare; ///< runs it once; throws Error if the result is wrong
};
using Rows = std::vector<Row>;

// The rows of every stage. `backends` must outlive them.
Rows copy_rows(const Backends& backends);
Rows transform_rows(const Backends& backends);
Rows pyramid_rows(const Backends& backends);
Rows cull_rows(const Backends& backends);
Rows facing_rows(const Backends& backends);
Rows project_clip_rows(const Backends& backends);
Rows scan_rows(const Backends& backends);
Rows atlas_rows(const Backends& backends);
Rows compact_rows(const Backends& backends);
Rows compact_runs_rows(const Backends& backends);
Rows intervals_rows(const Backends& backends);
Rows halo_rows(const Backends& backends);
Rows density_rows(const Backends& backends);

/// "<stage>/copy": the plainest kernel that reads and writes as many bytes as `bytes_of` says of n
/// elements, half each.
Row copy_row(const Backends& backends, const std::string& stage,
             std::function<double(std::uint32_t n)> bytes_of);

/// Wall-clock time of one run, after a reset.
double seconds_of(const Job& job);

double median(std::vector<double> values);

/// Runs the jobs in turns, so that what else happens on the machine meets all of them alike: the
/// median seconds of each.
std::vector<double> race(const std::vector<Job>& jobs, int rounds);

/// Bytes per second of the fastest plain copy of n uint32 on the device: the limit that
/// `share_of_copy` refers to. Measured when first asked for.
double copy_limit(const Backends& backends, std::uint32_t n);

/// Random numbers that are the same in every run.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    std::uint32_t below(std::uint32_t limit) {
        return static_cast<std::uint32_t>((std::uint64_t{bits()} * limit) >> 32U);
    }
    /// In [low, high).
    float between(float low, float high) {
        return low + (high - low) * (static_cast<float>(bits() >> 8U) * 0x1p-24F);
    }

  private:
    std::uint32_t bits() { return static_cast<std::uint32_t>(engine_()); }

    std::mt19937 engine_;
};

/// A job of a backend owns its buffers through this.
using SharedBuffer = std::shared_ptr<compute::Buffer>;

template <class T>
SharedBuffer to_device(compute::Backend& backend, const std::vector<T>& values) {
    SharedBuffer buffer = backend.allocate(values.size() * sizeof(T));
    backend.upload(*buffer, std::as_bytes(std::span{values}));
    return buffer;
}

template <class T>
std::vector<T> read_back(compute::Backend& backend, compute::Buffer& buffer, std::size_t count) {
    std::vector<T> values(count);
    backend.download(buffer, std::as_writable_bytes(std::span{values}));
    return values;
}

/// Throws Error unless the results of a row and of the plain C++ are equal.
void require(bool right, const std::string& row);

/// "<stage>/ours" on the device and "<stage>/reference" in plain C++: `prepare` serves both.
template <class Prepare>
Rows own_rows(const Backends& backends, const std::string& stage, Prepare prepare) {
    const auto on = [prepare](compute::Backend& backend) {
        return [prepare, &backend](std::uint32_t n) { return prepare(backend, n); };
    };
    return {{stage + "/ours", on(*backends.device)},
            {stage + "/reference", on(*backends.reference)}};
}

} // namespace lineatlas::bench
