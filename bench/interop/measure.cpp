#include "measure.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <memory>

#include <glm/gtc/matrix_transform.hpp>

#include "core/median.hpp"
#include "core/standard_camera.hpp"
#include "glpasses/current_context.hpp"
#include "glpasses/import_depth_pass.hpp"
#include "glpasses/interop/shared_table.hpp"
#include "glpasses/objects.hpp"
#include "glpasses/state_guard.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

using interop::SharingMode;
using Clock = std::chrono::steady_clock;

double milliseconds_of(const auto& work) {
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A device and a sharing mode that works on it.
struct Path {
    std::string device;
    interop::Connection connection;
};

/// A path with a buffer of one size, and its measured times.
class Subject {
  public:
    Subject(const Path& path, std::size_t bytes)
        : path_(path), table_(*path.connection.sharing, compute::table::work_space), from_(bytes),
          to_(bytes) {
        table_.fit(bytes);
    }

    void run_round() {
        write_by_gl();
        to_compute_.push_back(milliseconds_of([&] {
            table_.compute();
            path_.connection.device->finish();
        }));
        write_by_compute();
        to_gl_.push_back(milliseconds_of([&] {
            table_.gl();
            glFinish();
        }));
        right_ = right_ && last_seen_by_gl() == count() - 1;
        order_only_.push_back(milliseconds_of([&] {
            table_.compute();
            table_.gl();
        }));
        memcpy_.push_back(
            milliseconds_of([&] { std::memcpy(to_.data(), from_.data(), from_.size()); }));
    }

    HandoverCost cost() const {
        return {.device = path_.device,
                .mode = std::string{name_of(path_.connection.sharing->mode())},
                .bytes = table_.room(),
                .to_compute = median(to_compute_),
                .to_gl = median(to_gl_),
                .order_only = median(order_only_),
                .host_memcpy = median(memcpy_),
                .right = right_};
    }

  private:
    std::uint32_t count() const {
        return static_cast<std::uint32_t>(table_.room() / sizeof(std::uint32_t));
    }
    void write_by_gl() {
        const std::uint32_t one = 1;
        glClearNamedBufferData(table_.gl_to_write(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT,
                               &one);
        glFinish();
    }
    /// Scans a buffer of ones into 0, 1, 2, ...
    void write_by_compute() {
        path_.connection.stages->scan(table_.compute(), count() - 1, compute::ScanKind::saturate);
        path_.connection.device->finish();
    }
    std::uint32_t last_seen_by_gl() {
        std::uint32_t last = 0;
        glGetNamedBufferSubData(table_.gl(), static_cast<GLintptr>(table_.room() - sizeof(last)),
                                sizeof(last), &last);
        return last;
    }

    const Path& path_;
    interop::SharedTable table_;
    std::vector<std::byte> from_, to_;
    std::vector<double> to_compute_, to_gl_, order_only_, memcpy_;
    bool right_ = true;
};

std::vector<Path> find_paths(const HandoverOptions& options, HandoverReport& report) {
    std::vector<Path> paths;
    const auto devices = options.device.empty() ? compute::list_opencl_devices()
                                                : compute::find_opencl_devices(options.device);
    for (const compute::OpenClDevice& device : devices) {
        for (const SharingMode mode : interop::all_modes) {
            const std::string name{name_of(mode)};
            if (std::ranges::find(options.modes, name) == options.modes.end()) continue;
            try {
                paths.push_back(
                    {device.name(), interop::connect({.device = device.name(), .interop = name})});
            } catch (const DeviceError& error) {
                report.left_out.push_back({device.name(), name, error.what()});
            }
        }
    }
    return paths;
}

void measure_size(const std::vector<Path>& paths, std::size_t bytes, unsigned rounds,
                  HandoverReport& report) {
    std::vector<std::unique_ptr<Subject>> subjects;
    for (const Path& path : paths) subjects.push_back(std::make_unique<Subject>(path, bytes));
    for (unsigned round = 0; round < rounds; ++round) {
        for (const auto& subject : subjects) subject->run_round();
    }
    for (const auto& subject : subjects) report.costs.push_back(subject->cost());
}

/// Milliseconds of a renderer's call in a program's context beyond its passes. The call checks the
/// context and the program's depth, saves and restores GL's state, and converts the camera.
double measure_call() {
    constexpr glm::ivec2 size{320, 240};
    const gl::Texture2D depth = gl::Texture2D::create();
    glTextureStorage2D(depth.id(), 1, GL_DEPTH_COMPONENT32F, size.x, size.y);
    const Camera camera{.view = glm::translate(glm::mat4{1}, glm::vec3{0, 0, -4}),
                        .projection = glm::perspective(0.9F, 4.0F / 3.0F, 0.1F, 10.0F),
                        .size = size};
    const Bounds bounds{glm::vec3{-1}, glm::vec3{1}};
    std::vector<double> milliseconds;
    for (int i = 0; i < 1000; ++i) {
        milliseconds.push_back(milliseconds_of([&] {
            gl::require_context();
            const gl::StateGuard guard;
            standard_camera(camera, bounds, gl::check_depth_texture(depth.id(), {0, 0}, size));
        }));
    }
    return median(std::move(milliseconds));
}

} // namespace

HandoverReport measure_handovers(const HandoverOptions& options) {
    HandoverReport report;
    report.gl = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    report.call = measure_call();
    const std::vector<Path> paths = find_paths(options, report);
    for (const std::size_t bytes : options.sizes) {
        measure_size(paths, bytes, 1,
                     report); // builds the kernels for this size and touches the pages
        report.costs.resize(report.costs.size() - paths.size());
        measure_size(paths, bytes, options.rounds, report);
    }
    std::ranges::stable_sort(report.costs, {}, &HandoverCost::device);
    return report;
}

} // namespace lineatlas::bench
