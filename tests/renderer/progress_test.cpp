// Long calls report their progress, and stop when they are told to.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>

#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "lineatlas/visibility.hpp"
#include "scene_cameras.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

/// A Progress that records its reports and stops the call after some of them.
class Watch {
  public:
    explicit Watch(std::size_t most = 1000000) : most_(most) {}

    Progress progress() {
        return [this](float done) {
            told_.push_back(done);
            return told_.size() < most_;
        };
    }
    const std::vector<float>& told() const { return told_; }
    /// Expects at least `least` reports, from 0 to 1, that never decrease.
    void expect_whole(std::size_t least) const {
        ASSERT_GE(told_.size(), least);
        EXPECT_EQ(told_.front(), 0);
        EXPECT_EQ(told_.back(), 1);
        for (std::size_t i = 1; i < told_.size(); ++i) EXPECT_GE(told_[i], told_[i - 1]);
    }

  private:
    std::size_t most_;
    std::vector<float> told_;
};

/// Stops the call at each of its reports, and expects no report after that. Threads that work on
/// one step may tell of it together, so that a call has a report less than another time.
template <class Call>
void expect_stops_everywhere(const Call& call) {
    Watch whole;
    call(whole.progress());
    const std::size_t asked = whole.told().size();
    for (std::size_t most = 1; most <= asked; ++most) {
        Watch watch{most};
        bool is_stopped = false;
        try {
            call(watch.progress());
        } catch (const Cancelled&) {
            is_stopped = true;
        }
        EXPECT_LE(watch.told().size(), most);
        EXPECT_EQ(is_stopped, watch.told().size() == most) << most;
        EXPECT_TRUE(is_stopped || most + 2 >= asked) << most;
    }
}

TEST(ProgressOf, FindingLines) {
    const Mesh mesh = make_scene("house").mesh;
    Watch watch;
    const LineSet lines = extract_lines(mesh, {}, watch.progress());
    watch.expect_whole(5);
    EXPECT_EQ(lines.segments.size(), extract_lines(mesh).segments.size());
    expect_stops_everywhere([&](const Progress& progress) { extract_lines(mesh, {}, progress); });
}

TEST(ProgressOf, FindingWhatIsVisible) {
    const LineSet& lines = scene_lines("clevis");
    const Camera camera = scene_cameras("clevis", {320, 240})[0].camera;
    LineVisibility visibility{lines};
    const std::size_t all = visibility.find(camera).size();
    Watch watch;
    EXPECT_EQ(visibility.find(camera, {}, watch.progress()).size(), all);
    watch.expect_whole(5);
    expect_stops_everywhere(
        [&](const Progress& progress) { visibility.find(camera, {}, progress); });
    EXPECT_EQ(visibility.find(camera).size(), all) << "after it was stopped";
}

TEST(ProgressOf, ReadingAFile) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "strip.obj";
    {
        std::ofstream file{path};
        constexpr int steps = 40000;
        for (int i = 0; i <= steps; ++i) file << "v " << i << " 0 0\nv " << i << " 1 0\n";
        for (int i = 0; i < steps; ++i)
            file << "f " << 2 * i + 1 << ' ' << 2 * i + 2 << ' ' << 2 * i + 3 << '\n';
    }
    Watch watch;
    EXPECT_EQ(load_mesh(path, {}, watch.progress()).mesh.triangles.size(), 40000U);
    watch.expect_whole(8);
    expect_stops_everywhere([&](const Progress& progress) { load_mesh(path, {}, progress); });
}

class ProgressOfTiles : public testing::TestWithParam<Method> {};

TEST_P(ProgressOfTiles, IsToldAndStops) {
    const gl::HeadlessContext context;
    constexpr int tile = 128;
    gl::Canvas canvas{{tile, tile}};
    Renderer renderer;
    renderer.set_lines(scene_lines("clevis"));
    const Camera camera = scene_cameras("clevis", {320, 240})[0].camera;
    FrameOptions options{.method = GetParam()};
    std::vector<std::uint8_t> pixels;
    const auto draw = [&](const Progress& progress) {
        pixels.clear();
        renderer.draw_tiles(camera, options,
                            {.framebuffer = canvas.framebuffer(),
                             .tile_size = tile,
                             .begin =
                                 [&](const PictureTile&) {
                                     canvas.clear({1, 1, 1, 1});
                                 },
                             .end =
                                 [&](const PictureTile&) {
                                     const std::vector<std::uint8_t> drawn = canvas.read();
                                     pixels.insert(pixels.end(), drawn.begin(), drawn.end());
                                 },
                             .progress = progress});
    };
    draw({});
    const std::vector<std::uint8_t> wanted = pixels;
    Watch watch;
    draw(watch.progress());
    watch.expect_whole(7); // six tiles, and the end
    EXPECT_TRUE(equal(pixels, wanted));
    expect_stops_everywhere(draw);
    draw({});
    EXPECT_TRUE(equal(pixels, wanted)) << "after it was stopped";
}

INSTANTIATE_TEST_SUITE_P(By, ProgressOfTiles, testing::Values(Method::atlas, Method::exact),
                         [](const auto& info) {
                             return info.param == Method::atlas ? "atlas" : "exact";
                         });

} // namespace
} // namespace lineatlas::test
