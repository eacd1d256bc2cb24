// Kernels and shaders that do not build: their messages, and that a new renderer works afterwards.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "planted_error.hpp"
#include "scene_cameras.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

struct BrokenSource {
    const char *name, *file, *from;
};

/// Errors in several lines, so that the test notices a log that is cut off.
constexpr const char* two_errors =
    "float broken() { float x = first_unknown_name; return x + second_unknown_name; }\n";

void PrintTo(const BrokenSource& source, std::ostream* out) {
    *out << source.file;
}

class BrokenSources : public testing::TestWithParam<BrokenSource> {
  protected:
    PlantedError break_source() const {
        const std::string from = GetParam().from;
        return PlantedError{GetParam().file, from, two_errors + from};
    }
    /// The renderer does not replace a named device by another one.
    static constexpr const char* device = "opencl:portable";

    BrokenSources() { ::setenv("LINEATLAS_BUILD_LOG", log_.c_str(), 1); }
    ~BrokenSources() override { ::unsetenv("LINEATLAS_BUILD_LOG"); }

    /// Expects a message of one line about a kernel, and the whole log in a file.
    void expect_whole_log(std::string said) const {
        std::ostringstream log;
        log << std::ifstream{log_}.rdbuf();
        said += log.str();
        for (const char* word : {GetParam().file, "first_unknown_name", "second_unknown_name"}) {
            EXPECT_NE(said.find(word), std::string::npos) << word << " is not in: " << said;
        }
    }

    std::vector<std::uint8_t> draw() {
        Renderer renderer{{.device = device}};
        renderer.set_lines(scene_lines("clevis"));
        return draw_with(renderer);
    }
    std::vector<std::uint8_t> draw_with(Renderer& renderer) {
        canvas_.clear(glm::vec4{1});
        const Camera camera = scene_cameras("clevis", canvas_.size())[0].camera;
        // Draws strokes by GL, because some tests break its shaders.
        renderer.draw(camera, {.forms = {.strokes = StageForm::raster}}, canvas_.framebuffer());
        return canvas_.read();
    }

    TemporaryFolder folder_;
    std::filesystem::path log_ = folder_.path() / "build.log";
    gl::HeadlessContext context_;
    gl::Canvas canvas_{{200, 150}};
};

TEST_P(BrokenSources, AreSaidWithTheWholeLogAndANewRendererWorks) {
    const std::vector<std::uint8_t> expected = draw();
    {
        const PlantedError broken = break_source();
        try {
            draw();
            ADD_FAILURE() << "nothing was said";
        } catch (const DeviceError& error) {
            expect_whole_log(error.what());
        }
    }
    EXPECT_EQ(draw(), expected);
}

TEST_P(BrokenSources, LeaveARendererThatDrawsOnceTheyAreMended) {
    const std::vector<std::uint8_t> expected = draw();
    std::unique_ptr<Renderer> renderer;
    try {
        const PlantedError broken = break_source();
        renderer = std::make_unique<Renderer>(
            DeviceOptions{.device = device}); // compiles what it needs in any case
        renderer->set_lines(scene_lines("clevis"));
        EXPECT_THROW(draw_with(*renderer), DeviceError);
    } catch (const DeviceError& error) {
        expect_whole_log(error.what());
    }
    if (!renderer) return;
    EXPECT_EQ(draw_with(*renderer), expected);
}

TEST_P(BrokenSources, EndTheToolWithTheWholeLog) {
    const PlantedError broken = break_source();
    const std::filesystem::path picture =
        std::filesystem::temp_directory_path() /
        ("lineatlas_broken_" + std::to_string(::getpid()) + ".png");
    const std::string command =
        LINEATLAS_TOOL
        " draw --scene clevis --method atlas --strokes raster --size 200x150 --device " +
        std::string{device} + " -o \"" + picture.string() + "\" 2>&1";
    FILE* tool = popen(command.c_str(), "r");
    ASSERT_NE(tool, nullptr);
    std::string said;
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), part.size(), tool) != nullptr) said += part.data();
    const int status = pclose(tool);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1) << said;
    EXPECT_FALSE(std::filesystem::exists(picture));
    expect_whole_log(said);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, BrokenSources,
    testing::Values(BrokenSource{"Kernel", "compact.cl", "KERNEL(compact_count,"},
                    BrokenSource{"KernelOfTheAtlas", "atlas.cl", "KERNEL(atlas,"},
                    BrokenSource{"VertexShader", "strokes.vert", "void main()"},
                    BrokenSource{"FragmentShader", "strokes.frag", "void main()"},
                    BrokenSource{"GeometryShader", "atlas.geom", "void main()"}),
    [](const auto& tested) { return tested.param.name; });

} // namespace
} // namespace lineatlas::test
