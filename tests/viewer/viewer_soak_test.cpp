// Frames of the viewer with constant switching of all settings leave nothing behind. The test
// counts references to OpenCL objects, names of GL objects and memory. LINEATLAS_SOAK_FRAMES: the
// number of frames; 300 if it is not set.

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include <dlfcn.h>
#include <epoxy/gl.h>

#include "io/reader_protocol.hpp"
#include "support/fault_layer/fault_layer.hpp"
#include "support/held_memory.hpp"
#include "viewer_support.hpp"

namespace lineatlas::test {
namespace {

constexpr int frames_per_switch = 10;
constexpr int switches_per_period = 12;
constexpr int frames_per_period = frames_per_switch * switches_per_period;

struct Counts {
    ClCounts cl{};
    int gl = 0;
    double megabytes = 0;
};

ClCounts count_cl() {
    void* layer = dlopen(LINEATLAS_FAULT_LAYER, RTLD_LAZY | RTLD_NOLOAD);
    if (layer == nullptr) throw std::runtime_error{"the OpenCL loader has not taken the layer"};
    const auto faults = reinterpret_cast<GetOpenClFaults*>(dlsym(layer, opencl_faults_symbol));
    dlclose(layer);
    return faults()->references;
}

/// The number of names in use. Mesa gives the lowest free name, so that no name is beyond `most`.
int count_gl() {
    constexpr GLuint most = 4096;
    int count = 0;
    for (GLuint name = 1; name <= most; ++name) {
        count += glIsBuffer(name) + glIsTexture(name) + glIsFramebuffer(name) +
                 glIsRenderbuffer(name) + glIsVertexArray(name) + glIsSampler(name) +
                 glIsProgram(name) + glIsShader(name) + glIsQuery(name);
    }
    return count;
}

int frames_wanted() {
    const char* text = std::getenv("LINEATLAS_SOAK_FRAMES");
    return text == nullptr ? 300 : std::max(std::atoi(text), 2 * frames_per_period);
}

/// Every period goes through the same combinations and ends with the atlas, because that has the
/// most objects.
void switch_everything(viewer::Session& session, int number) {
    static const std::array<DeviceOptions, 4> devices{
        {{}, {.interop = "copy"}, {.compute = "cpp"}, {.interop = "host-pointer"}}};
    static const std::array<std::string, 3> styles{"", "pencil", "technical"};
    const auto n = static_cast<std::size_t>(number % switches_per_period);
    session.settings.sides[0].method = viewer::method_labels.at((n + 1) % 4).method;
    session.settings.split = n % 3 == 1;
    session.use_style(styles.at(n % styles.size()));
    session.use_device(devices.at((n + n / 4) % devices.size()));
}

TEST(ViewerSoak, LeavesNothingBehind) {
    ::setenv("OPENCL_LAYERS", LINEATLAS_FAULT_LAYER, 1); // before the first OpenCL call
    ::setenv("LINEATLAS_CACHE", "off", 1);               // no trial of the device comes first
    ImageWriter writer;
    viewer::Application app{{.size = {800, 500}, .scripted = true}, writer};
    ViewerDriver hand{app};
    hand.open_scene("clevis");
    hand.key(GLFW_KEY_T);
    std::vector<Counts> periods;
    const int frames = frames_wanted();
    for (int frame = 0; frame < frames; ++frame) {
        if (frame % frames_per_switch == 0)
            switch_everything(app.session(), frame / frames_per_switch);
        app.session().navigation.orbit({0, 0, 0}, {0.01, 0});
        hand.frames(1);
        // Economies and their objects must not depend on the load of the machine.
        for (int i = 0; i < 3; ++i) app.session().note_duration(1);
        ASSERT_TRUE(app.session().messages.all().empty())
            << app.session().messages.all().front().text;
        if ((frame + 1) % frames_per_period != 0) continue;
        hand.rest();
        for (int i = 0; app.session().timings_due() && i < 500; ++i) app.step(0.01);
        periods.push_back(
            {count_cl(), count_gl(), static_cast<double>(held_memory()) * 1024 / 1e6});
        const Counts& now = periods.back();
        std::printf(
            "frame %4d: %ld CL contexts, %ld queues, %ld buffers, %ld programs, %ld kernels, "
            "%ld events; %d GL objects; %.1f MB\n",
            frame + 1, now.cl[0], now.cl[1], now.cl[2], now.cl[3], now.cl[4], now.cl[5], now.gl,
            now.megabytes);
    }
    EXPECT_GE(app.session().frames_drawn(), static_cast<std::uint64_t>(frames));
    const Counts &first = periods.front(), &last = periods.back();
    EXPECT_GT(first.cl[cl_kernels], 0) << "nothing was counted";
    EXPECT_EQ(first.cl[cl_events], 0) << "timings of frames that never came";
    EXPECT_GT(first.gl, 20) << "nothing was counted";
    EXPECT_EQ(last.cl, first.cl);
    EXPECT_EQ(last.gl, first.gl);
    // Allocators sometimes keep about 20 MB. The least value of several periods does not contain
    // these.
    const std::ptrdiff_t quarter = std::ssize(periods) / 4;
    if (quarter == 0) return;
    const auto least = [](auto from, auto to) {
        return std::ranges::min_element(from, to, {}, &Counts::megabytes)->megabytes;
    };
    constexpr double most_growth = 4; // MB
    EXPECT_LT(least(periods.end() - quarter, periods.end()),
              least(periods.end() - 2 * quarter, periods.end() - quarter) + most_growth);
}

/// Sanitizers have allocators of their own.
#ifdef __GLIBC__
constexpr bool gives_memory_back = !reader::sanitized;
#else
constexpr bool gives_memory_back = false;
#endif

/// LINEATLAS_SOAK_SIDE: the large model has twice its square of triangles.
TEST(ViewerSoak, GivesTheMemoryOfALargeModelBack) {
    if (!gives_memory_back) GTEST_SKIP() << "only glibc's allocator gives memory back";
    const char* wanted = std::getenv("LINEATLAS_SOAK_SIDE");
    const TemporaryFolder folder;
    const std::filesystem::path small = folder.path() / "small.obj",
                                large = folder.path() / "large.obj";
    std::ofstream{small} << torus(60);
    std::ofstream{large} << torus(wanted == nullptr ? 600 : std::atoi(wanted));
    ImageWriter writer;
    viewer::Application app{{.size = {800, 500}, .scripted = true}, writer};
    ViewerDriver hand{app};
    std::array<double, 5> megabytes{};
    for (std::size_t i = 0; i < megabytes.size(); ++i) {
        hand.drop(i % 2 == 0 ? small : large);
        ASSERT_TRUE(app.session().refined()) << "the exact picture has its memory, too";
        megabytes.at(i) = static_cast<double>(held_memory()) * 1024 / 1e6;
        std::printf("%s, %zu triangles: %.1f MB\n", app.session().model()->source.name().c_str(),
                    app.session().model()->lines.triangles.size(), megabytes.at(i));
    }
    const double taken = megabytes[1] - megabytes[0];
    EXPECT_GT(taken, 100) << "nothing was measured";
    // Without a trim 0.6 of it stay.
    for (const std::size_t small_again : {2, 4})
        EXPECT_LT(megabytes.at(small_again) - megabytes[0], 0.4 * taken);
}

} // namespace
} // namespace lineatlas::test
