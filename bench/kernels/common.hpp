#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compute/opencl/opencl_backend.hpp"
#include "compute/stages/stages.hpp"
#include "compute/transfer.hpp"

namespace lineatlas::bench {

/// What rows are measured on: one OpenCL device, and the same kernels as C++ beside it.
struct Devices {
    std::unique_ptr<compute::OpenClBackend> opencl;
    std::unique_ptr<compute::Device> cpp;
    std::unique_ptr<compute::Stages> opencl_stages, cpp_stages; ///< on them
};

Devices make_devices(std::unique_ptr<compute::OpenClBackend> opencl);

/// The device is `name`, else LINEATLAS_DEVICE, else the first. `form`: "cpu" or "gpu", whose
/// launch parameters are taken; empty: the device's own. Throws as find_opencl_devices does.
Devices open_devices(std::string name, const std::string& form = {});

/// Integers, which are equal bit by bit on every device, or floats, which are nearly.
using Result = std::variant<std::vector<std::uint8_t>, std::vector<float>>;

/// One row at one size, ready to be timed.
struct Job {
    std::function<void()> run;     ///< all of the work; returns when it is done
    double bytes = 0;              ///< counted per run; every stage's file says what is counted
    std::function<void()> reset{}; ///< if set, restores what a run overwrites; not timed
    /// What a run leaves, of a job of stages: the same on every device.
    std::function<Result()> result{};
};

/// A way of doing a stage.
struct Row {
    std::string name; ///< "<stage>/<way>"
    std::function<Job(std::uint32_t n)>
        prepare; ///< runs it once; throws Error if the result is wrong
};
using Rows = std::vector<Row>;

// The rows of every stage; those of a frame's kernels are "<stage>/ours" and "<stage>/cpp".
// `devices` must outlive them.
Rows copy_rows(const Devices& devices);
Rows transform_rows(const Devices& devices);
Rows depth_rows(const Devices& devices);
Rows planes_rows(const Devices& devices);
Rows pyramid_rows(const Devices& devices);
Rows cull_rows(const Devices& devices);
Rows facing_rows(const Devices& devices);
Rows contour_rows(const Devices& devices);
Rows silhouette_rows(const Devices& devices);
Rows chain_rows(const Devices& devices);
Rows project_clip_rows(const Devices& devices);
Rows scan_rows(const Devices& devices);
Rows carry_rows(const Devices& devices);
Rows atlas_rows(const Devices& devices);
Rows temporal_rows(const Devices& devices);
Rows intervals_rows(const Devices& devices);
Rows exact_rows(const Devices& devices);
Rows outline_rows(const Devices& devices);
Rows compact_rows(const Devices& devices);
Rows pens_rows(const Devices& devices);
Rows halo_rows(const Devices& devices);
Rows filter_rows(const Devices& devices);
Rows density_rows(const Devices& devices);
Rows fill_rows(const Devices& devices);
Rows strokes_rows(const Devices& devices);
Rows vector_path_rows(const Devices& devices); ///< on the host alone: "<step>/host"

/// All of them, in the order of a frame.
Rows all_rows(const Devices& devices);

/// "<stage>/copy": the plainest kernel that reads and writes as many bytes as `bytes_of` says of n
/// elements, half each.
Row copy_row(const Devices& devices, const std::string& stage,
             std::function<double(std::uint32_t n)> bytes_of);

/// Wall-clock time of one run, after a reset.
double seconds_of(const Job& job);

/// Runs the jobs in turns, so that what else happens on the machine meets all of them alike: the
/// median seconds of each.
std::vector<double> race(const std::vector<Job>& jobs, int rounds);

/// Bytes per second of the fastest plain copy of n uint32 on the device: the limit that
/// `share_of_copy` refers to. Measured when first asked for.
double copy_limit(const Devices& devices, std::uint32_t n);

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

/// A job owns its buffers through this.
using SharedBuffer = std::shared_ptr<compute::Buffer>;

template <class T>
void write(compute::Device& device, compute::Buffer& buffer, const std::vector<T>& values) {
    device.upload(buffer, std::as_bytes(std::span{values}));
}

using compute::read_back;
using compute::to_device;

/// The member `of` of every element, as bytes.
template <class T>
std::vector<std::uint8_t> members(const std::vector<T>& elements, std::uint32_t T::*of) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(elements.size() * sizeof(std::uint32_t));
    for (const T& element : elements) {
        const auto* first = reinterpret_cast<const std::uint8_t*>(&(element.*of));
        bytes.insert(bytes.end(), first, first + sizeof(std::uint32_t));
    }
    return bytes;
}

/// Throws Error unless it is right.
void require(bool right, const std::string& row);

/// Makes a job on a device.
using Prepare = Job (*)(compute::Stages& stages, std::uint32_t n);

/// "<stage>/ours" on the OpenCL device, which must leave what C++ does, and "<stage>/cpp".
Rows own_rows(const Devices& devices, const std::string& stage, Prepare prepare);

} // namespace lineatlas::bench
