// Lines with visible parts that are known by hand, tested with the whole renderer: with the raster
// and the compute atlas, high and low quality, perspective and parallel projection.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>

#include <glm/geometric.hpp>
#include <unistd.h>

#include "compare.hpp"
#include "environment_variable.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "known_visibility.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;

/// The visible part of a segment that is nearest to one of the expected spans.
struct Seen {
    double length = 0; ///< pixels
    double moment = 0; ///< moment of the visible part about the start of the segment
};

/// One part per expected span, or a single part if none is expected. length: of the segment, in
/// pixels.
std::vector<Seen> seen_of(const Renderer::Samples& samples, std::uint32_t segment, double length,
                          const std::vector<Span>& expected) {
    const std::uint32_t begin = samples.offsets[segment];
    const std::uint32_t l = samples.offsets[segment + 1] - begin;
    std::vector<Seen> seen(std::max<std::size_t>(expected.size(), 1));
    for (std::uint32_t j = 0; j < l; ++j) {
        const double place = (j + 0.5) / l * length;
        const auto distance = [&](const Span& s) {
            return std::max({s.from - place, place - s.to, 0.0});
        };
        const auto nearest = std::ranges::min_element(expected, {}, distance);
        Seen& own = seen[static_cast<std::size_t>(nearest - expected.begin()) % seen.size()];
        const double visible = samples.alpha[begin + j] / 255.0 * length / l;
        own.length += visible;
        own.moment += visible * place;
    }
    return seen;
}

struct Setting {
    bool perspective;
    StageForm form;
    bool high;

    FrameOptions options() const {
        return {.probes = high ? 9U : 1U,
                .depth_scale = high ? 2 : 1,
                .lines = all_line_kinds & ~mask_of(LineKind::silhouette),
                .forms = {.atlas = form}};
    }
    /// A single probe only tells whether a sample of two pixels is visible.
    double tolerance() const { return high ? 1 : 2; }
};

class Visibility : public testing::Test {
  protected:
    Renderer::Samples draw(Renderer& renderer, const LineSet& lines, const Camera& camera,
                           const FrameOptions& options) {
        renderer.set_lines(lines);
        renderer.draw(camera, options, canvas_.framebuffer());
        return renderer.read_samples();
    }

    /// The largest error of a case in pixels. Prints the places of errors if `say`.
    double error(Renderer& renderer, const Case& known_case, const Setting& setting, bool say) {
        const Camera camera = known_case.camera(setting.perspective);
        const Known known = known_case.make(setting.perspective, camera);
        // Every face has its own material. No line shows between two faces of one material in a
        // plane.
        Mesh mesh = known.mesh;
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            mesh.groups.push_back({.object = "", .material = std::to_string(i)});
            mesh.triangle_group.push_back(i);
        }
        const LineSet lines = extract_lines(mesh);
        const Renderer::Samples samples = draw(renderer, lines, camera, setting.options());
        double worst = 0;
        for (std::size_t a = 0; a < known.answers.size(); ++a) {
            const Answer& answer = known.answers[a];
            const double off = error_of(answer, lines, samples, camera);
            worst = std::max(worst, off);
            if (say) {
                EXPECT_LE(off, setting.tolerance()) << "line " << a;
            }
        }
        return worst;
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{side, side}};

  private:
    static double error_of(const Answer& answer, const LineSet& lines,
                           const Renderer::Samples& samples, const Camera& camera) {
        for (std::uint32_t i = 0; i < lines.segments.size(); ++i) {
            const glm::vec3 p = lines.vertices[lines.segments[i].p];
            const glm::vec3 q = lines.vertices[lines.segments[i].q];
            const bool same = p == answer.p && q == answer.q;
            const bool turned = p == answer.q && q == answer.p;
            if (!same && !turned) continue;
            // The length within the picture. No answer has more than one end outside.
            const double whole = length_px(camera, p, q);
            double end = 0;
            for (const Span& s : answer.visible) end = std::max(end, s.to);
            const bool clipped = [&] {
                for (const glm::vec3 v : {p, q}) {
                    const glm::dvec2 w = window(camera, v);
                    if (w.x < 0 || w.y < 0 || w.x > side || w.y > side) return true;
                }
                return false;
            }();
            const double length = clipped ? end : whole;
            std::vector<Span> expected = answer.visible;
            if (turned) {
                for (Span& s : expected) s = {length - s.to, length - s.from};
                std::ranges::reverse(expected);
            }
            return difference(expected, seen_of(samples, i, length, expected));
        }
        ADD_FAILURE() << "the line is not in the table";
        return 0;
    }

    /// The largest difference between lengths, and between the middles of parts that are not too
    /// short.
    static double difference(const std::vector<Span>& expected, const std::vector<Seen>& seen) {
        if (expected.empty()) return seen[0].length;
        double worst = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const double length = expected[i].to - expected[i].from;
            worst = std::max(worst, std::abs(seen[i].length - length));
            if (length < 3 || seen[i].length == 0) continue;
            const double middle = (expected[i].from + expected[i].to) / 2;
            worst = std::max(worst, std::abs(seen[i].moment / seen[i].length - middle));
        }
        return worst;
    }
};

class KnownVisibility : public Visibility,
                        public testing::WithParamInterface<std::tuple<bool, StageForm, bool>> {
  protected:
    Setting setting() const {
        return {std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())};
    }
};

TEST_P(KnownVisibility, OfEveryCase) {
    Renderer renderer;
    for (const Case& known : known_cases()) {
        SCOPED_TRACE(known.name);
        error(renderer, known, setting(), true);
    }
}

/// A unit sphere.
Mesh sphere() {
    Mesh mesh;
    constexpr std::uint32_t rings = 96, sectors = 192;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        for (std::uint32_t j = 0; j < sectors; ++j) {
            const double a = std::numbers::pi * i / rings, b = 2 * std::numbers::pi * j / sectors;
            mesh.positions.emplace_back(std::sin(a) * std::cos(b), std::cos(a),
                                        std::sin(a) * std::sin(b));
        }
    }
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < sectors; ++j) {
            const std::uint32_t k = (j + 1) % sectors;
            const std::uint32_t a = i * sectors + j, b = i * sectors + k;
            mesh.triangles.emplace_back(a, b, b + sectors);
            mesh.triangles.emplace_back(a, b + sectors, a + sectors);
        }
    }
    return mesh;
}

TEST_P(KnownVisibility, OfTheOutlineOfASphere) {
    // The silhouette is a circle. Every piece of it as long as a sample must have a stroke.
    const Camera camera = front_camera(setting().perspective);
    const LineSet lines = extract_lines(sphere(), {.lines = mask_of(LineKind::silhouette)});
    FrameOptions options = setting().options();
    options.lines = all_line_kinds;
    Renderer renderer;
    const Renderer::Samples samples = draw(renderer, lines, camera, options);
    const double radius =
        per_unit * (setting().perspective ? eye_z / std::sqrt(eye_z * eye_z - 1) : 1);
    const double circle = 2 * std::numbers::pi * radius;
    std::vector<bool> covered(static_cast<std::size_t>(circle / 2));
    for (const lineatlas::Run& run : samples.runs) {
        for (int k = 0; k <= 20; ++k) {
            const double u = k / 20.0;
            const glm::dvec2 from_center{run.start[0] + (run.end[0] - run.start[0]) * u - side / 2,
                                         run.start[1] + (run.end[1] - run.start[1]) * u - side / 2};
            EXPECT_NEAR(glm::length(from_center), radius, 1);
            const double turn = std::atan2(from_center.y, from_center.x) / (2 * std::numbers::pi);
            covered[static_cast<std::size_t>((turn + 0.5) * static_cast<double>(covered.size())) %
                    covered.size()] = true;
        }
    }
    EXPECT_EQ(std::ranges::count(covered, false), 0);
    double visible = 0;
    for (const lineatlas::Run& run : samples.runs) {
        visible += std::hypot(run.end[0] - run.start[0], run.end[1] - run.start[1]);
    }
    // Edges between triangles zigzag about the circle.
    EXPECT_GT(visible, circle - setting().tolerance());
    EXPECT_LT(visible, 1.5 * circle);
}

std::string setting_name(const testing::TestParamInfo<std::tuple<bool, StageForm, bool>>& info) {
    const auto [perspective, form, high] = info.param;
    return std::string{form == StageForm::raster ? "Raster" : "Compute"} + (high ? "High" : "Low") +
           (perspective ? "Perspective" : "Parallel");
}

INSTANTIATE_TEST_SUITE_P(All, KnownVisibility,
                         testing::Combine(testing::Bool(),
                                          testing::Values(StageForm::raster, StageForm::compute),
                                          testing::Bool()),
                         setting_name);

/// Replaces a text in the sources while this object lives.
class Planted {
  public:
    Planted(const std::string& folder, const char* variable, const std::string& from,
            const std::string& to)
        : folder_(fs::path{testing::TempDir()} /
                  ("lineatlas-planted-" + folder + "-" + std::to_string(getpid()))) {
        fs::copy(fs::path{LINEATLAS_SOURCE_DIR} / folder, folder_, fs::copy_options::recursive);
        int planted = 0;
        for (const auto& entry : fs::recursive_directory_iterator{folder_}) {
            if (!entry.is_regular_file()) continue;
            std::ostringstream content;
            content << std::ifstream{entry.path()}.rdbuf();
            std::string text = content.str();
            if (const auto at = text.find(from); at != std::string::npos) {
                text.replace(at, from.size(), to);
                ++planted;
            }
            std::ofstream{entry.path()} << text;
        }
        EXPECT_EQ(planted, 1) << from;
        variable_.emplace(variable, folder_.string());
    }
    ~Planted() { fs::remove_all(folder_); }
    Planted(const Planted&) = delete;
    Planted& operator=(const Planted&) = delete;

  private:
    fs::path folder_;
    std::optional<EnvironmentVariable> variable_;
};

TEST_F(Visibility, ABiasOfTwentyPixelsIsFound) {
    const Planted kernels{"kernels", "LINEATLAS_KERNEL_DIR", "!(before > contact)",
                          "!(before > contact + 10.0f * depths.bend * inverse_w)"};
    Renderer renderer;
    for (const StageForm form : {StageForm::raster, StageForm::compute}) {
        for (const bool high : {false, true}) {
            const Setting setting{true, form, high};
            EXPECT_GT(error(renderer, known_cases().back(), setting, false), 100) << high;
            // Other lines are far behind the surfaces that hide them.
            EXPECT_LE(error(renderer, known_cases().front(), setting, false), setting.tolerance())
                << high;
        }
    }
}

TEST_F(Visibility, APlaneAtATexelsMiddleIsFound) {
    const Planted kernels{"kernels", "LINEATLAS_KERNEL_DIR", "plane_x * (side_x *",
                          "plane_x * ((TO_FLOAT(column) + 0.5f - x) *"};
    Renderer renderer;
    const Case& steep = known_cases()[known_cases().size() - 2];
    for (const StageForm form : {StageForm::raster, StageForm::compute})
        EXPECT_GT(error(renderer, steep, {true, form, true}, false), 10);
}

TEST_F(Visibility, APatchNumberOffByOneIsFound) {
    const Camera camera = front_camera(true);
    const LineSet lines = extract_lines(sphere(), {.lines = mask_of(LineKind::silhouette)});
    const auto seen = [&](StageForm form) {
        Renderer renderer;
        FrameOptions options = Setting{true, form, true}.options();
        options.lines = all_line_kinds;
        const Renderer::Samples samples = draw(renderer, lines, camera, options);
        return std::accumulate(samples.alpha.begin(), samples.alpha.end(), 0.0);
    };
    const std::array forms{StageForm::raster, StageForm::compute};
    const std::array good{seen(forms[0]), seen(forms[1])};
    const Planted kernels{"kernels", "LINEATLAS_KERNEL_DIR",
                          "own == spine.patch_a || own == spine.patch_b",
                          "own == spine.patch_a + 1 || own == spine.patch_b + 1"};
    EXPECT_LT(seen(forms[0]), 0.985 * good[0]);
    EXPECT_LT(seen(forms[1]), 0.985 * good[1]);
}

} // namespace
} // namespace lineatlas::test
