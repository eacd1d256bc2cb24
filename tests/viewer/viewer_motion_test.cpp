// The costs of an orbit in the viewer, and that rest costs nothing. LINEATLAS_MOTION_SCENE: a scene
// or a file. LINEATLAS_MOTION_FRAMES: the number of pictures. LINEATLAS_MOTION_STAGES: prints the
// times of stages. The figures are printed for docs/viewer.md.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "viewer_driver.hpp"

namespace lineatlas::test {
namespace {

std::string setting(const char* name, const char* usual) {
    const char* text = std::getenv(name);
    return text != nullptr ? text : usual;
}

/// The time of all threads in milliseconds.
double processor_time() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double wall_time() {
    return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
                     .count();
}

double share_of(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

void print_stages(const viewer::Timings& timings) {
    std::printf("medians of the last pictures, ms: frame %.1f", timings.median_total());
    for (std::size_t i = 0; i < timings.stages().size(); ++i)
        std::printf(", %s %.1f", timings.stages()[i].c_str(), timings.median_of(i));
    std::printf("\n");
}

TEST(ViewerMotion, IsDrawnAndEndsAtRest) {
    ImageWriter writer;
    viewer::Application app{{.size = {1280, 800}, .scale = 1, .scripted = true}, writer};
    ViewerDriver hand{app};
    viewer::Session& session = app.session();
    const std::string scene = setting("LINEATLAS_MOTION_SCENE", "clevis");
    if (scene.find('.') == std::string::npos)
        session.open_scene(scene);
    else
        session.open(scene);
    hand.rest();
    const int frames = std::atoi(setting("LINEATLAS_MOTION_FRAMES", "20").c_str());
    std::vector<double> wall, processor;
    const glm::dvec3 middle = session.point_at({-1, -1});
    const std::uint64_t before = session.frames_drawn();
    app.ui().timings = std::getenv("LINEATLAS_MOTION_STAGES") != nullptr;
    for (int i = 0; i < frames; ++i) {
        const double wall_start = wall_time(), start = processor_time();
        session.navigation.orbit(middle, {0.02, 0});
        app.step(0);
        wall.push_back(wall_time() - wall_start);
        processor.push_back(processor_time() - start);
    }
    EXPECT_EQ(session.frames_drawn(), before + static_cast<std::uint64_t>(frames));
    std::printf("%s, %d pictures of %d x %d: wall median %.1f ms, 95 %% within %.1f ms; processor "
                "median %.1f ms, 95 %% within %.1f ms; economy %d\n",
                scene.c_str(), frames, session.size().x, session.size().y, share_of(wall, 0.5),
                share_of(wall, 0.95), share_of(processor, 0.5), share_of(processor, 0.95),
                static_cast<int>(session.economy()));
    hand.screenshot("moving");
    if (app.ui().timings) print_stages(session.timings);
    const double moved = wall_time();
    hand.rest();
    std::printf("at rest after %.0f ms, %s\n", wall_time() - moved,
                session.refined() ? "exact" : "as it moves");
    EXPECT_TRUE(session.refined());
    // Messages about files disappear by themselves.
    while (session.messages.passing()) app.step(0.1);
    hand.rest();
    const std::uint64_t shown = app.frames_shown(), drawn = session.frames_drawn();
    const double start = processor_time(), wall_start = wall_time();
    while (wall_time() - wall_start < 1000) app.step(1);
    std::printf("a second of rest: %.2f ms of processor time\n", processor_time() - start);
    EXPECT_EQ(app.frames_shown(), shown);
    EXPECT_EQ(session.frames_drawn(), drawn);
}

} // namespace
} // namespace lineatlas::test
