// Hidden objects. With every method the picture is that of a model without them.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "allocation_count.hpp"
#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "lineatlas/visibility.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{480, 360};
constexpr LineOptions apart{.separate_objects = true};

const LineSet& house() {
    static const LineSet lines = extract_lines(make_scene("house").mesh, apart);
    return lines;
}

/// Every third object.
std::vector<std::uint32_t> hidden_objects() {
    std::vector<std::uint32_t> hidden;
    for (std::uint32_t i = 1; i < house().objects.size(); i += 3) hidden.push_back(i);
    return hidden;
}

/// The scene without the hidden objects. The other objects are its objects.
LineSet house_without(const std::vector<std::uint32_t>& hidden) {
    Mesh mesh = make_scene("house").mesh;
    const auto is_hidden = [&](std::uint32_t group) {
        const std::string& name = mesh.groups[group].object;
        return std::ranges::any_of(
            hidden, [&](std::uint32_t object) { return house().objects[object].name == name; });
    };
    Mesh left = mesh;
    left.triangles.clear();
    left.triangle_group.clear();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (is_hidden(mesh.triangle_group[i])) continue;
        left.triangles.push_back(mesh.triangles[i]);
        left.triangle_group.push_back(mesh.triangle_group[i]);
    }
    return extract_lines(left, apart);
}

/// A camera with the planes of the whole scene, so that depth is the same.
Camera camera(int which = 0) {
    return scene_cameras("house", size)[static_cast<std::size_t>(which)].camera;
}

class Hidden : public testing::TestWithParam<Method> {
  protected:
    std::vector<std::uint8_t> picture(Renderer& renderer, const Camera& seen,
                                      FrameOptions options = {}) {
        options.method = GetParam();
        canvas_.clear({1, 1, 1, 1});
        renderer.draw(seen, options, canvas_.framebuffer());
        return canvas_.read();
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{size};
};

/// The share of bytes that differ by more than 8 between two pictures.
double differing_share(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    return compare_bytes(a, b, 8).share();
}

TEST_P(Hidden, IsThePictureWithoutThem) {
    const std::vector<std::uint32_t> hidden = hidden_objects();
    ASSERT_GT(hidden.size(), 1U);
    Renderer all, without;
    all.set_lines(house());
    without.set_lines(house_without(hidden));
    for (const StageForm form : {StageForm::raster, StageForm::compute}) {
        for (const int view : {0, 1}) {
            const FrameOptions options{.forms = {.depth = form}, .steady = false};
            all.set_hidden({});
            const auto shown = picture(all, camera(view), options);
            all.set_hidden(hidden);
            const auto drawn = picture(all, camera(view), options);
            const auto wanted = picture(without, camera(view), options);
            EXPECT_GT(differing_share(shown, wanted), 0.005);
            // Where faces of two boxes coincide, a texel may show either of them: see moving_test.
            EXPECT_LT(differing_share(drawn, wanted), 2e-4);
        }
    }
}

TEST_P(Hidden, ShownAgainIsThePictureThatWas) {
    Renderer renderer{{.compute = "cpp"}};
    renderer.set_lines(house());
    const auto before = picture(renderer, camera());
    for (int i = 0; i < 2; ++i) {
        renderer.set_hidden(hidden_objects());
        const auto hidden = picture(renderer, camera());
        EXPECT_FALSE(equal(before, hidden));
        EXPECT_TRUE(equal(hidden, picture(renderer, camera()))) << "nothing of frames before";
        renderer.set_hidden({});
        EXPECT_TRUE(equal(before, picture(renderer, camera())));
    }
}

TEST_P(Hidden, AllOfThemIsAnEmptyPicture) {
    Renderer renderer{{.compute = "cpp"}};
    renderer.set_lines(house());
    std::vector<std::uint32_t> all(house().objects.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    renderer.set_hidden(all);
    FrameOptions options;
    options.style.fill.mode = FillMode::flat;
    const auto drawn = picture(renderer, camera(), options);
    EXPECT_EQ(std::ranges::count(drawn, 255), static_cast<std::ptrdiff_t>(drawn.size()));
}

TEST_P(Hidden, StaysSoOnAnotherDevice) {
    Renderer renderer{{.compute = "cpp"}};
    renderer.set_lines(house());
    renderer.set_hidden(hidden_objects());
    const auto before = picture(renderer, camera());
    renderer.set_device({.compute = "cpp", .interop = "copy"});
    EXPECT_TRUE(equal(before, picture(renderer, camera())));
}

std::string name_of(const testing::TestParamInfo<Method>& info) {
    constexpr std::array names{"atlas", "exact", "spine", "item_buffer", "opengl"};
    return names.at(static_cast<std::size_t>(info.param));
}

INSTANTIATE_TEST_SUITE_P(By, Hidden,
                         testing::Values(Method::atlas, Method::exact, Method::spine,
                                         Method::item_buffer, Method::opengl),
                         name_of);

TEST(HiddenObjects, AllocateNothingOnceSomeWereHidden) {
    const gl::HeadlessContext context;
    gl::Canvas canvas{size};
    Renderer renderer{{.compute = "cpp"}};
    renderer.set_lines(house());
    const std::vector<std::uint32_t> hidden = hidden_objects();
    const std::vector<std::uint32_t> nothing;
    const Camera seen = camera();
    const FrameOptions options;
    const auto frames = [&] {
        for (const auto* objects : {&hidden, &nothing}) {
            renderer.set_hidden(*objects);
            renderer.draw(seen, options, canvas.framebuffer());
        }
    };
    frames();
    frames();
    AllocationCount allocations;
    for (int i = 0; i < 5; ++i) frames();
    const std::size_t changing = allocations.stop();
    AllocationCount still;
    for (int i = 0; i < 10; ++i) renderer.draw(seen, options, canvas.framebuffer());
    EXPECT_EQ(changing, still.stop());
}

TEST(HiddenObjects, AreRefusedWhereThereAreNone) {
    const gl::HeadlessContext context;
    Renderer renderer;
    const std::array<std::uint32_t, 1> first{0};
    EXPECT_THROW(renderer.set_hidden(first), UsageError);
    renderer.set_lines(house());
    const std::array beyond{static_cast<std::uint32_t>(house().objects.size())};
    EXPECT_THROW(renderer.set_hidden(beyond), UsageError);
    LineSet lines = house();
    EXPECT_THROW(hide_objects(lines, beyond), UsageError);
}

TEST(HiddenObjects, OfALineSetAreHiddenAsOfARenderer) {
    const gl::HeadlessContext context;
    Renderer renderer{{.compute = "cpp"}};
    renderer.set_lines(house());
    renderer.set_hidden(hidden_objects());
    renderer.draw(camera(),
                  {.method = Method::exact, .intervals = KeptIntervals::visible, .draw = false}, 0);
    LineSet lines = house();
    hide_objects(lines, hidden_objects());
    const std::vector<Interval> wanted = renderer.read_intervals();
    const std::vector<Interval> found = LineVisibility{lines}.find(camera());
    ASSERT_EQ(found.size(), wanted.size());
    ASSERT_GT(found.size(), 100U);
    for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].segment, wanted[i].segment);
        ASSERT_TRUE(close(found[i], wanted[i]));
    }
}

} // namespace
} // namespace lineatlas::test
