// Draws frames like a whole night of use, but in less time. Methods, styles, models and sharing
// modes change all the time. Memory, numbers of objects, frame times and the pictures of equal
// frames must not change. ./run soak is a long run; the suite runs a short one.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <map>
#include <memory>
#include <ranges>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <malloc.h>
#include <sys/prctl.h>

#include "core/median.hpp"
#include "gl_faults.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "io/reader_protocol.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "lineatlas/style_files.hpp"
#include "support/fault_layer/fault_layer.hpp"
#include "support/held_memory.hpp"

namespace {

using namespace lineatlas;

constexpr glm::ivec2 size{320, 240};
constexpr int angles = 30;           // of the turntable
constexpr int frames_per_change = 5; // of method and style
constexpr double most_allocated_growth_percent = 1;
// Held memory may grow more than allocated memory, because it counts touched pages. A frame may use
// only the beginning of a table. Then the table holds little memory on fresh pages and much on used
// ones, and the allocator decides which pages it gets.
constexpr double most_held_growth_percent = 5;

struct Look {
    std::string name;
    FrameOptions options;
};

std::vector<Look> make_looks() {
    std::vector<Look> looks;
    for (const StyleInfo& style : list_styles()) {
        looks.push_back({"atlas, " + style.name, {.style = load_style(style.name)}});
    }
    looks.push_back({"atlas, raster", {.forms = {.atlas = StageForm::raster}}});
    looks.push_back({"atlas, low", {.probes = 1, .depth_scale = 1}});
    looks.push_back({"spine", {.method = Method::spine}});
    looks.push_back({"item-buffer", {.method = Method::item_buffer}});
    looks.push_back({"opengl", {.method = Method::opengl}});
    for (Look& look : looks) look.options.steady = false; // frames must not depend on earlier ones
    return looks;
}

std::uint64_t hash(const std::vector<std::uint8_t>& pixels) {
    std::uint64_t value = 14695981039346656037ULL; // FNV-1a
    for (const std::uint8_t byte : pixels) value = (value ^ byte) * 1099511628211ULL;
    return value;
}

/// Lets the system count only memory that the program holds. By default the allocator keeps large
/// freed blocks that have something small behind them, and the kernel gives memory in pages of 2
/// MiB.
void keep_no_free_memory() {
    mallopt(M_MMAP_THRESHOLD, 128 * 1024); // fixed, because otherwise it grows with freed blocks
    prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);
}

/// The memory that the system counts, in KiB, without free memory that is kept for later. It
/// includes memory from elsewhere than the allocator, such as code that a driver builds.
long held_memory() {
    malloc_trim(0);
    return test::held_memory();
}

/// The memory that all threads have allocated and not freed, in KiB.
long allocated_memory() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<long>((info.uordblks + info.hblkhd) / 1024);
}

long opencl_objects(const char* layer) {
    static auto* faults = reinterpret_cast<test::GetOpenClFaults*>(
        dlsym(dlopen(layer, RTLD_NOW), test::opencl_faults_symbol));
    return faults()->live();
}

class Soak {
  public:
    Soak() : scenes_{make_scene("clevis"), make_scene("house")} {
        for (const Scene& scene : scenes_) lines_.push_back(extract_lines(scene.mesh));
        renderer_.set_lines(lines_[0]);
    }

    /// Draws one frame. Returns false if its picture has changed.
    bool draw(int frame) {
        const int change = frame / frames_per_change;
        const auto look = static_cast<std::size_t>(change) % looks_.size();
        const auto scene = static_cast<std::size_t>(change) / looks_.size() % scenes_.size();
        const bool shared = change / static_cast<int>(looks_.size() * scenes_.size()) % 2 != 0;
        if (frame % frames_per_change == 0) {
            renderer_.set_lines(lines_[scene]);
        }
        // Changes rarely, because PoCL 3.1 keeps about a KiB of every program that is built, and
        // each change builds some twenty.
        if (shared != shared_) renderer_.set_device({.interop = shared ? "host-pointer" : "copy"});
        shared_ = shared;
        const int angle = frame % angles;
        const View view = scenes_[scene].view(static_cast<float>(angle) / angles);
        canvas_.clear({1, 1, 1, 1});
        renderer_.draw(make_camera(view, size, lines_[scene].bounds), looks_[look].options,
                       canvas_.framebuffer());
        const std::uint64_t picture = hash(canvas_.read());
        const auto [known, is_new] = pictures_.try_emplace({look, scene, angle}, picture);
        if (known->second == picture) return true;
        std::cerr << "frame " << frame << " (" << looks_[look].name << ", " << scenes_[scene].name
                  << ") differs from an equal one\n";
        return false;
    }

    std::size_t pictures() const { return pictures_.size(); }
    /// The number of frames until all combinations were drawn.
    int period() const {
        return frames_per_change * static_cast<int>(looks_.size() * scenes_.size()) * 2;
    }

  private:
    std::vector<Scene> scenes_;
    std::vector<LineSet> lines_;
    std::vector<Look> looks_ = make_looks();
    gl::Canvas canvas_{size};
    Renderer renderer_{{.interop = "copy"}};
    bool shared_ = false;
    std::map<std::tuple<std::size_t, std::size_t, int>, std::uint64_t> pictures_;
};

struct Sample {
    long allocated, held, gl, opencl; ///< KiB, KiB, objects, references
    double frame;                     ///< median since the last sample, ms of all threads
};

/// The growth in percent from the least memory of the first half of the samples to that of the
/// second half. Memory that drivers free late comes and goes, but leaks are in the least values,
/// too. The first sample does not count, because things are still loaded after it.
double growth_of(const std::vector<Sample>& samples, long Sample::*memory) {
    const auto half = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
    const auto least = [&](auto first, auto last) {
        return std::ranges::min(std::ranges::subrange(first, last) | std::views::transform(memory));
    };
    const long before = least(samples.begin() + 1, half);
    return 100.0 * static_cast<double>(least(half, samples.end()) - before) /
           static_cast<double>(before);
}

bool is_flat(const std::vector<Sample>& samples) {
    // A sanitizer's allocator keeps freed memory to find code that still uses it.
    if (reader::sanitized) return true;
    return growth_of(samples, &Sample::allocated) <= most_allocated_growth_percent &&
           growth_of(samples, &Sample::held) <= most_held_growth_percent;
}

int run(int least_frames, const char* layer) {
    const gl::HeadlessContext context;
    test::hook_gl();
    Soak soak;
    const int period = soak.period(); // every sample is taken in the same state
    // Three samples in each half, although the first of all does not count.
    const int rounds = std::max(6, (least_frames + period - 1) / period);
    std::vector<Sample> samples;
    std::vector<double> times;
    bool equal = true;
    int frames = 0;
    std::cout << "frames   MiB allocated   MiB held   GL objects   OpenCL objects   ms of "
                 "processor time a frame\n";
    const auto draw_round = [&] {
        for (int i = 0; i < period; ++i, ++frames) {
            const std::clock_t start = std::clock();
            equal = soak.draw(frames) && equal;
            times.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        }
        samples.push_back({allocated_memory(), held_memory(), test::gl_faults().live,
                           opencl_objects(layer), median(std::exchange(times, {}))});
        const Sample& s = samples.back();
        std::cout << frames << "   " << s.allocated / 1024 << "   " << s.held / 1024 << "   "
                  << s.gl << "   " << s.opencl << "   " << s.frame << std::endl;
    };
    for (int i = 0; i < rounds; ++i) draw_round();
    // On a busy machine memory settles late. A leak goes on growing.
    for (int i = rounds; i < 4 * rounds && !is_flat(samples); ++i) draw_round();
    const auto half = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
    const bool objects_flat = std::all_of(half, samples.end(), [&](const Sample& s) {
        return s.gl == half->gl && s.opencl == half->opencl;
    });
    const auto time_of = [](auto first, auto last) {
        std::vector<double> medians;
        std::transform(first, last, std::back_inserter(medians), [](auto& s) { return s.frame; });
        return median(medians);
    };
    std::cout << frames << " frames, " << soak.pictures() << " different pictures, equal frames "
              << (equal ? "equal" : "DIFFER") << "; allocated grew by "
              << growth_of(samples, &Sample::allocated) << " %, held by "
              << growth_of(samples, &Sample::held) << " %, objects "
              << (objects_flat ? "flat" : "GROW") << ", a frame takes "
              << time_of(half, samples.end()) / time_of(samples.begin(), half)
              << " of its time in the first half\n";
    return equal && objects_flat && is_flat(samples) ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    const int least_frames = argc > 1 ? std::atoi(argv[1]) : 10'000;
    if (least_frames < 1) {
        std::cerr
            << "Usage: soak [FRAMES], which are rounded up to whole rounds of all that changes, "
               "at least six\n";
        return 2;
    }
    keep_no_free_memory();
    setenv("OPENCL_LAYERS", LINEATLAS_FAULT_LAYER, 1);
    setenv("LINEATLAS_CACHE", "off", 1); // no trial of the device comes first
    return run(least_frames, LINEATLAS_FAULT_LAYER);
}
