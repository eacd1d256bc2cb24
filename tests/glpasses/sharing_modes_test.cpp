// On every device each mode that works on this machine draws the same as copying, bit by bit.

#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "glpasses/interop/connect.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

using interop::SharingMode;

class SharingModes : public testing::TestWithParam<SharingMode> {
  protected:
    std::vector<std::uint8_t> draw(Renderer& renderer, const Camera& camera) {
        canvas_.clear(glm::vec4{1});
        EXPECT_GT(renderer.draw(camera, {}, canvas_.framebuffer()).runs, 0U) << "an empty picture";
        return canvas_.read();
    }
    void expect_same_as_copy(const std::string& device, const char* scene) {
        Renderer shared{{.device = device, .interop = std::string{name_of(GetParam())}}};
        Renderer copied{{.device = device, .interop = "copy"}};
        shared.set_lines(scene_lines(scene));
        copied.set_lines(scene_lines(scene));
        for (const NamedCamera& view : scene_cameras(scene, canvas_.size())) {
            SCOPED_TRACE(device + ", " + scene + ", " + view.name);
            EXPECT_TRUE(equal(draw(shared, view.camera), draw(copied, view.camera)));
        }
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{400, 300}};
};

TEST_P(SharingModes, DrawWhatCopyingDraws) {
    std::string reasons;
    bool any = false;
    for (const compute::OpenClDevice& device : compute::list_opencl_devices()) {
        const interop::ModeReport report = interop::probe_mode(device, GetParam());
        if (!report.works) {
            reasons += device.name() + ": " + report.reason + "\n";
            continue;
        }
        any = true;
        for (const char* scene : {"clevis", "house", "ship"}) {
            expect_same_as_copy(device.name(), scene);
        }
    }
    if (!any) GTEST_SKIP() << reasons;
}

INSTANTIATE_TEST_SUITE_P(Mode, SharingModes,
                         testing::Values(SharingMode::gl_sharing, SharingMode::external_memory,
                                         SharingMode::host_pointer),
                         [](const auto& info) {
                             std::string name{name_of(info.param)};
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

} // namespace
} // namespace lineatlas::test
