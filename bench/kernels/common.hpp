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

/// The devices that rows are measured on: one OpenCL device, and `cpp` with the same kernels.
struct Devices {
    std::unique_ptr<compute::OpenClBackend> opencl;
    std::unique_ptr<compute::Device> cpp;
    std::unique_ptr<compute::Stages> opencl_stages, cpp_stages; ///< the stages on these devices
};

Devices make_devices(std::unique_ptr<compute::OpenClBackend> opencl);

/// Opens the device `name`, else that of LINEATLAS_DEVICE, else the first one. `form`: "cpu" or
/// "gpu" for the launch parameters of such devices; empty: the device's own. Throws as
/// find_opencl_devices() does.
Devices open_devices(std::string name, const std::string& form = {});

/// Integers are equal bit by bit on every device, floats are nearly equal.
using Result = std::variant<std::vector<std::uint8_t>, std::vector<float>>;

/// One row at one size, ready to be timed.
struct Job {
    std::function<void()> run;     ///< does all of the work and waits for it
    double bytes = 0;              ///< counted per run, as the head of the stage's file says
    std::function<void()> reset{}; ///< if set, restores what a run overwrites; not timed
    /// The result of a run, the same on every device. Only jobs of stages have it.
    std::function<Result()> result{};
};

/// One way to do a stage's work.
struct Row {
    std::string name; ///< "<stage>/<way>"
    std::function<Job(std::uint32_t n)>
        prepare; ///< also runs the job once; throws Error if the result is wrong
};
using Rows = std::vector<Row>;

// The rows of every stage. Rows of a frame's kernels are "<stage>/ours" and "<stage>/cpp".
// `devices` must outlive the rows.
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
Rows vector_path_rows(const Devices& devices); ///< steps on the host: "<step>/host"

/// The rows of all stages, about in the order of a frame.
Rows all_rows(const Devices& devices);

/// The row "<stage>/copy": a plain kernel that copies. It reads half of `bytes_of(n)` bytes and
/// writes as many.
Row copy_row(const Devices& devices, const std::string& stage,
             std::function<double(std::uint32_t n)> bytes_of);

/// Wall-clock time of one run, after a reset.
double seconds_of(const Job& job);

/// The median seconds of each job. The jobs run by turns, so that other work on the machine affects
/// all of them alike.
std::vector<double> race(const std::vector<Job>& jobs, int rounds);

/// Bytes per second of the fastest plain copy of n uint32 on the device. `share_of_copy` refers to
/// this limit. The first call for each n measures it.
double copy_limit(const Devices& devices, std::uint32_t n);

/// Random numbers, the same in every run.
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

/// A buffer that the functions of a job own together.
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

/// Throws Error with the row's name unless `right`.
void require(bool right, const std::string& row);

/// Makes a job on a device.
using Prepare = Job (*)(compute::Stages& stages, std::uint32_t n);

/// The rows "<stage>/ours" on the OpenCL device and "<stage>/cpp". Both must give the same result.
Rows own_rows(const Devices& devices, const std::string& stage, Prepare prepare);

} // namespace lineatlas::bench
