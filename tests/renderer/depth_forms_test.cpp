// The two forms of `depth` compared in four scenes, at three cameras each, one of them inside the
// model. Kernels and GL draw the same depth, except for rounding at the edges of faces.

#include <cmath>
#include <iostream>

#include "core/clusters.hpp"
#include "depth_model.hpp"
#include "devices.hpp"
#include "gl_depth.hpp"
#include "glpasses/headless_context.hpp"
#include "scene_cameras.hpp"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace {

constexpr int scale = 2;

/// Shares of the texels.
struct Difference {
    double coverage = 0; ///< texels that only one form covers
    double depth = 0;    ///< texels that both forms cover, at depths more than 1e-5 apart
};

Difference difference(const std::vector<float>& a, const std::vector<float>& b) {
    std::size_t coverage = 0, depth = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if ((a[i] == 1) != (b[i] == 1))
            ++coverage;
        else if (std::fabs(a[i] - b[i]) > 1e-5F)
            ++depth;
    }
    const auto all = static_cast<double>(a.size());
    return {static_cast<double>(coverage) / all, static_cast<double>(depth) / all};
}

class DepthForms : public testing::TestWithParam<TestDevice> {
  protected:
    void compare(const std::string& scene, glm::ivec2 size) {
        const LineSet& lines = scene_lines(scene);
        DeviceStages on{GetParam().make()};
        DepthModel model{*on.device, lines.vertices, lines.triangles, 64};
        for (const NamedCamera& view : scene_cameras(scene, size)) {
            SCOPED_TRACE(scene + " " + view.name);
            const auto drawn = model.draw(on.stages, view.camera.clip_from_world(), size * scale);
            const Difference found =
                difference(drawn.texels, draw_depth_by_gl(lines, view.camera, scale));
            EXPECT_LE(found.coverage, 3e-5);
            EXPECT_LE(found.depth, 2e-5);
            std::cout << scene << ' ' << view.name << ": coverage differs in "
                      << 100 * found.coverage << " %, depth in " << 100 * found.depth << " %\n";
        }
    }

  private:
    gl::HeadlessContext context_;
};

// The size of the program's pictures, because a texel is a larger share of a small picture.
constexpr glm::ivec2 usual{1024, 768};

TEST_P(DepthForms, AgreeOnClevis) {
    compare("clevis", usual);
}
TEST_P(DepthForms, AgreeOnHouse) {
    compare("house", usual);
}
TEST_P(DepthForms, AgreeOnShip) {
    compare("ship", usual);
}
TEST_P(DepthForms, AgreeOnOffice) {
    compare("office", usual);
}

INSTANTIATE_TEST_SUITE_P(OnDevice, DepthForms, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lineatlas::test
