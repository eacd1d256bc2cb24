// Lines whose visibility is known by hand, through the whole renderer: raster and compute atlas,
// high and low quality, perspective and parallel projection.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <numeric>
#include <sstream>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <unistd.h>

#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;

constexpr int side = 400;        // of the viewport, pixels
constexpr double per_unit = 100; // pixels, at z = 0
constexpr double eye_z = 10;

/// From (0, 0, 10) along -z; in perspective the frame at z = 0 is that of the parallel projection.
Camera front_camera(bool perspective) {
    Camera camera;
    camera.size = {side, side};
    camera.view = glm::lookAt(glm::vec3{0, 0, eye_z}, glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = perspective ? glm::perspective(2 * std::atan(0.2F), 1.0F, 1.0F, 100.0F)
                                    : glm::ortho(-2.0F, 2.0F, -2.0F, 2.0F, 1.0F, 100.0F);
    return camera;
}

/// Pixels a unit is worth at depth z.
double scale_at(bool perspective, double z) {
    return perspective ? per_unit * eye_z / (eye_z - z) : per_unit;
}

/// x at depth z of what stands before it at x, `from` z.
double behind(bool perspective, double x, double from, double z) {
    return x * scale_at(perspective, from) / scale_at(perspective, z);
}

/// A span of a line on the screen, pixels from its start.
struct Span {
    double from, to;
};

/// A line and where it is visible.
struct Answer {
    glm::vec3 p, q;
    std::vector<Span> visible;
};

struct Known {
    Mesh mesh;
    std::vector<Answer> answers;

    std::uint32_t vertex(glm::vec3 position) {
        mesh.positions.push_back(position);
        return static_cast<std::uint32_t>(mesh.positions.size() - 1);
    }
    void quad(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
        const std::uint32_t first = vertex(a);
        vertex(b), vertex(c), vertex(d);
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
    /// Facing the eye.
    void sheet(glm::vec2 low, glm::vec2 high, float z) {
        quad({low, z}, {high.x, low.y, z}, {high, z}, {low.x, high.y, z});
    }
    void box(glm::vec3 low, glm::vec3 high) {
        const auto corner = [&](int i) {
            return glm::vec3{(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                             (i & 4) != 0 ? high.z : low.z};
        };
        constexpr int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (const auto& q : quads) quad(corner(q[0]), corner(q[1]), corner(q[2]), corner(q[3]));
    }
    void line(glm::vec3 p, glm::vec3 q, std::vector<Span> visible) {
        const std::uint32_t first = vertex(p);
        vertex(q);
        mesh.polylines.push_back({first, first + 1});
        answers.push_back({p, q, std::move(visible)});
    }
};

/// Window position in pixels.
glm::dvec2 window(const Camera& camera, glm::vec3 point) {
    const glm::dvec4 clip =
        glm::dmat4{camera.projection} * glm::dmat4{camera.view} * glm::dvec4{point, 1};
    return (glm::dvec2{clip} / clip.w + 1.0) * (0.5 * side);
}

double length_px(const Camera& camera, glm::vec3 p, glm::vec3 q) {
    return glm::distance(window(camera, p), window(camera, q));
}

/// A line across the picture at depth z, a little oblique, so that it meets texels anywhere.
struct Across {
    glm::vec3 p, q;
    double length; ///< on the screen

    Across(const Camera& camera, float z, float y = 0.013F)
        : p{-1.503F, y, z}, q{1.497F, y + 0.1F, z}, length(length_px(camera, p, q)) {}
    /// The place where it passes x.
    double at(double x) const { return (x - p.x) / (q.x - p.x) * length; }
};

Known behind_a_box(bool perspective, const Camera& camera) {
    Known known;
    known.box({-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F});
    const Across line{camera, -1};
    const double half = behind(perspective, 0.5, 0.5, -1);
    known.line(line.p, line.q, {{0, line.at(-half)}, {line.at(half), line.length}});
    return known;
}

Known before_a_box(bool, const Camera& camera) {
    Known known;
    known.box({-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F});
    const Across line{camera, 0.6F};
    known.line(line.p, line.q, {{0, line.length}});
    return known;
}

Known on_a_face(bool, const Camera& camera) {
    Known known;
    known.box({-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F});
    const glm::vec3 p{-0.4F, 0.1F, 0.5F}, q{0.4F, 0.2F, 0.5F};
    known.line(p, q, {{0, length_px(camera, p, q)}});
    return known;
}

Known through_a_window(bool perspective, const Camera& camera) {
    Known known; // wall from -1.7 to 1, window from -0.6 to 0.3, at z = 0.5
    known.sheet({-1.7F, -1}, {-0.6F, 1}, 0.5F);
    known.sheet({0.3F, -1}, {1, 1}, 0.5F);
    known.sheet({-0.6F, -1}, {0.3F, -0.4F}, 0.5F);
    known.sheet({-0.6F, 0.5F}, {0.3F, 1}, 0.5F);
    const Across line{camera, -0.5F};
    const auto at = [&](double x) { return line.at(behind(perspective, x, 0.5, -0.5)); };
    known.line(line.p, line.q, {{at(-0.6), at(0.3)}, {at(1), line.length}});
    return known;
}

Known thin_gap(bool perspective, const Camera& camera) {
    Known known; // three pixels wide
    const double left = -0.211, right = left + 3 / scale_at(perspective, 0.5);
    known.sheet({-1.9F, -1}, {static_cast<float>(left), 1}, 0.5F);
    known.sheet({static_cast<float>(right), -1}, {1.9F, 1}, 0.5F);
    const Across line{camera, -0.5F};
    const auto at = [&](double x) { return line.at(behind(perspective, x, 0.5, -0.5)); };
    known.line(line.p, line.q, {{at(left), at(right)}});
    // The same gap, seen through lengthwise.
    const auto middle = static_cast<float>(behind(perspective, (left + right) / 2, 0.5, -0.5));
    const glm::vec3 p{middle, -0.7F, -0.5F}, q{middle, 0.7F, -0.5F};
    known.line(p, q, {{0, length_px(camera, p, q)}});
    return known;
}

/// Sheets 0.3, 0.7, 1, 1.5 and 5 pixels before lines hide them: a surface hides however near it is.
Known sheets_before_lines(bool, const Camera& camera) {
    Known known;
    float y = -1.5F;
    for (const float before : {0.003F, 0.007F, 0.01F, 0.015F, 0.05F}) {
        const Across line{camera, 0, y + 0.2F};
        known.sheet({-1.9F, y}, {1.9F, y + 0.5F}, before);
        known.line(line.p, line.q, {});
        y += 0.6F;
    }
    return known;
}

/// A line 5.5 pixels before a sheet that rises by 10 to 1 across it: half a pixel to its right the
/// sheet comes before it, and that far no probe stands.
Known before_a_steep_sheet(bool, const Camera& camera) {
    Known known;
    const glm::vec3 p{0.013F, -1.5F, 0}, q{0.113F, 1.5F, 0};
    const glm::vec3 up{0.1F, 0, 1}, behind{0, 0, -0.055F};
    known.quad(p - up + behind, p + up + behind, q + up + behind, q - up + behind);
    known.line(p, q, {{0, length_px(camera, p, q)}});
    return known;
}

/// A post that touches the back of a panel one pixel thick.
Known post_behind_a_panel(bool, const Camera& camera) {
    Known known;
    known.box({-0.5F, -1.2F, 0}, {0.5F, 1.2F, 0.01F});
    known.box({-0.1F, -0.9F, -0.2F}, {0.1F, 0.9F, 0});
    const auto answer = [&](glm::vec3 p, glm::vec3 q, bool visible) {
        known.answers.push_back({p, q, {}});
        if (visible) known.answers.back().visible = {{0, length_px(camera, p, q)}};
    };
    answer({-0.1F, -0.9F, 0}, {-0.1F, 0.9F, 0}, false);
    answer({0.1F, -0.9F, 0}, {0.1F, 0.9F, 0}, false);
    answer({-0.1F, -0.9F, 0}, {0.1F, -0.9F, 0}, false);
    answer({-0.5F, -1.2F, 0.01F}, {-0.5F, 1.2F, 0.01F}, true);
    answer({-0.5F, 1.2F, 0.01F}, {0.5F, 1.2F, 0.01F}, true);
    return known;
}

/// Two planks 1.2 pixels thick, one on the other and across it.
Known planks(bool perspective, const Camera& camera) {
    Known known;
    const float thick = 0.012F;
    known.box({-1.5F, -0.15F, 0}, {1.5F, 0.15F, thick});
    known.box({-0.2F, -1, thick}, {0.2F, 1, 2 * thick});
    const double half = behind(perspective, 0.2, 2 * thick, thick);
    for (const float y : {-0.15F, 0.15F}) {
        const glm::vec3 p{-1.5F, y, thick}, q{1.5F, y, thick};
        const double scale = scale_at(perspective, thick), length = length_px(camera, p, q);
        known.answers.push_back(
            {p, q, {{0, (1.5 - half) * scale}, {(1.5 + half) * scale, length}}});
    }
    for (const float x : {-0.2F, 0.2F}) {
        const glm::vec3 p{x, -1, 2 * thick}, q{x, 1, 2 * thick};
        known.answers.push_back({p, q, {{0, length_px(camera, p, q)}}});
    }
    return known;
}

/// A bar through a sheet that rises by 45 degrees to the right.
Known bar_through_a_sheet(bool perspective, const Camera& camera) {
    Known known;
    known.quad({-1, -1, -1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, -1});
    known.box({-1.5F, -0.2F, -0.3F}, {1.6F, 0.2F, 0.1F});
    const double scale = scale_at(perspective, 0.1);
    for (const float y : {-0.2F, 0.2F}) {
        const glm::vec3 p{-1.5F, y, 0.1F}, q{1.6F, y, 0.1F};
        const double length = length_px(camera, p, q);
        const double beyond = (1.5 + behind(perspective, 1, 1, 0.1)) * scale;
        known.answers.push_back({p, q, {{0, 1.6 * scale}, {beyond, length}}});
    }
    return known;
}

/// A slope of 45 degrees, long edge on one side, two short ones on the other.
Known t_junction(bool, const Camera& camera) {
    Known known;
    const glm::vec3 low{0.03F, -1, -0.5F}, high{0.03F, 1, 1.5F}, middle{0.03F, 0.25F, 0.75F};
    const glm::vec3 left{-1.5F, 0.1F, 0.6F}, right{1.5F, 0.1F, 0.6F};
    for (const auto& t : {std::array{low, high, left}, std::array{low, right, middle},
                          std::array{middle, right, high}}) {
        const std::uint32_t first = known.vertex(t[0]);
        known.vertex(t[1]), known.vertex(t[2]);
        known.mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    const auto whole = [&](glm::vec3 p, glm::vec3 q) {
        known.answers.push_back({p, q, {{0, length_px(camera, p, q)}}});
    };
    whole(low, high), whole(low, middle), whole(middle, high); // boundaries, one on the other
    const auto drawn = [&](glm::vec3 p, glm::vec3 q, bool visible) {
        known.line(p, q, {});
        if (visible) known.answers.back().visible = {{0, length_px(camera, p, q)}};
    };
    drawn({-0.5F, 0.25F, 0.75F}, {0.5F, 0.25F, 0.75F}, true); // on the faces, over the junction
    drawn({-0.5F, 0.2F, 0.4F}, {0.5F, 0.3F, 0.4F}, false);    // behind them
    drawn({0.03F, -0.6F, -0.6F}, {0.03F, 0.7F, 0.7F}, false); // behind the edge, along it
    return known;
}

/// A sheet tilted by 60 degrees: a line in it, and smaller sheets in its plane, one of them twice.
Known coplanar(bool, const Camera& camera) {
    Known known;
    const auto at = [](float x, float y) { return glm::vec3{x, y, 1.732F * y}; };
    const auto patch = [&](float x0, float y0, float x1, float y1, bool other_diagonal) {
        const std::array c{at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)};
        const int k = other_diagonal ? 1 : 0;
        known.quad(c[k], c[k + 1], c[(k + 2) % 4], c[(k + 3) % 4]);
        for (int i = 0; i < 4; ++i) {
            const glm::vec3 p = c[i], q = c[(i + 1) % 4];
            known.answers.push_back({p, q, {{0, length_px(camera, p, q)}}});
        }
    };
    patch(-1.5F, -1, 1.5F, 1, false);
    patch(-1.2F, -0.6F, -0.2F, 0.5F, true);
    patch(0.2F, -0.5F, 1.1F, 0.6F, false);
    patch(0.2F, -0.5F, 1.1F, 0.6F, true);
    const glm::vec3 p = at(-1, -0.8F), q = at(1.1F, 0.9F);
    known.line(p, q, {{0, length_px(camera, p, q)}});
    return known;
}

Known at_the_border(bool perspective, const Camera& camera) {
    Known known;
    // In the outermost pixels, and out of the picture on the right.
    const glm::vec3 p{-1.995F, -1.5F, 0}, q{-1.995F, 1.5F, 0};
    known.line(p, q, {{0, length_px(camera, p, q)}});
    known.line({0.5F, 0.3F, 0}, {3, 0.3F, 0}, {{0, 150}}); // pixels inside
    // Behind a sheet that also goes beyond the picture, from below.
    known.sheet({-0.4F, -3}, {0.4F, -1.2F}, 0.5F);
    const double top = behind(perspective, -1.2, 0.5, 0);
    known.line({0.1F, -2.7F, 0}, {0.1F, 0, 0}, {{(2 + top) * per_unit, 2 * per_unit}});
    return known;
}

/// A cube seen from above and the right: nine of its edges are visible.
Known creases(bool, const Camera& camera) {
    Known known;
    known.box({-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F});
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 4; ++i) {
            glm::vec3 p{0};
            p[(axis + 1) % 3] = (i & 1) != 0 ? 0.5F : -0.5F;
            p[(axis + 2) % 3] = (i & 2) != 0 ? 0.5F : -0.5F;
            glm::vec3 q = p;
            p[axis] = -0.5F, q[axis] = 0.5F;
            known.answers.push_back({p, q, {}});
            if (i != 0) known.answers.back().visible = {{0, length_px(camera, p, q)}};
        }
    }
    return known;
}

/// The same cube on a floor, which touches it and hides nothing.
Known on_a_floor(bool perspective, const Camera& camera) {
    Known known = creases(perspective, camera);
    known.quad({-2, -0.5F, -2}, {-2, -0.5F, 2}, {2, -0.5F, 2}, {2, -0.5F, -2});
    return known;
}

Camera cube_camera(bool perspective) {
    Camera camera = front_camera(perspective);
    camera.view = glm::lookAt(glm::vec3{5, 4, 8}, glm::vec3{0}, glm::vec3{0, 1, 0});
    return camera;
}

struct Case {
    const char* name;
    Known (*make)(bool perspective, const Camera& camera);
    Camera (*camera)(bool perspective) = front_camera;
};

constexpr std::array<Case, 15> cases{{
    {"BehindABox", behind_a_box},
    {"BeforeABox", before_a_box},
    {"OnAFace", on_a_face},
    {"Creases", creases, cube_camera},
    {"ThroughAWindow", through_a_window},
    {"TJunction", t_junction},
    {"CoplanarFaces", coplanar},
    {"AtTheBorder", at_the_border},
    {"ThinGap", thin_gap},
    {"PostBehindAPanel", post_behind_a_panel},
    {"Planks", planks},
    {"BarThroughASheet", bar_through_a_sheet},
    {"OnAFloor", on_a_floor, cube_camera},
    {"BeforeASteepSheet", before_a_steep_sheet},
    {"SheetsBeforeLines", sheets_before_lines},
}};

/// What is seen of a segment nearest to one of the spans where it should be.
struct Seen {
    double length = 0; ///< pixels
    double moment = 0; ///< of that, about the start of the segment
};

/// One per span; `length` of the segment in pixels. What is seen although no span is expected
/// comes alone.
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
    AtlasForm form;
    bool high;

    FrameOptions options() const {
        return {.probes = high ? 9U : 1U,
                .depth_scale = high ? 2 : 1,
                .lines = all_line_kinds & ~mask_of(LineKind::silhouette),
                .atlas = form};
    }
    /// A single probe says only whether a sample of two pixels is visible.
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

    /// How far, in pixels, what is seen of a case is from the answer; says where if `say`.
    double error(Renderer& renderer, const Case& known_case, const Setting& setting, bool say) {
        const Camera camera = known_case.camera(setting.perspective);
        const Known known = known_case.make(setting.perspective, camera);
        // A material for each face: where two of one lie in a plane, no line is seen.
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
            // In the picture; of no answer is more than one end outside.
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

    /// Of lengths, and of the middles of what is not too short to have one.
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
                        public testing::WithParamInterface<std::tuple<bool, AtlasForm, bool>> {
  protected:
    Setting setting() const {
        return {std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())};
    }
};

TEST_P(KnownVisibility, OfEveryCase) {
    Renderer renderer;
    for (const Case& known : cases) {
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
    // A circle; pieces of it as long as a sample, none of them without a stroke.
    const Camera camera = front_camera(setting().perspective);
    const LineSet lines = extract_lines(sphere(), {.kinds = mask_of(LineKind::silhouette)});
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

std::string setting_name(const testing::TestParamInfo<std::tuple<bool, AtlasForm, bool>>& info) {
    const auto [perspective, form, high] = info.param;
    return std::string{form == AtlasForm::raster ? "Raster" : "Compute"} + (high ? "High" : "Low") +
           (perspective ? "Perspective" : "Parallel");
}

INSTANTIATE_TEST_SUITE_P(All, KnownVisibility,
                         testing::Combine(testing::Bool(),
                                          testing::Values(AtlasForm::raster, AtlasForm::compute),
                                          testing::Bool()),
                         setting_name);

/// Sources in which a text is replaced, in use until the end of its life.
class Planted {
  public:
    Planted(const std::string& folder, const char* variable, const std::string& from,
            const std::string& to)
        : folder_(fs::path{testing::TempDir()} /
                  ("lineatlas-planted-" + folder + "-" + std::to_string(getpid()))),
          variable_(variable) {
        fs::create_directories(folder_);
        int planted = 0;
        for (const auto& entry : fs::directory_iterator{fs::path{LINEATLAS_SOURCE_DIR} / folder}) {
            std::ostringstream content;
            content << std::ifstream{entry.path()}.rdbuf();
            std::string text = content.str();
            if (const auto at = text.find(from); at != std::string::npos) {
                text.replace(at, from.size(), to);
                ++planted;
            }
            std::ofstream{folder_ / entry.path().filename()} << text;
        }
        EXPECT_EQ(planted, 1) << from;
        ::setenv(variable, folder_.c_str(), 1);
    }
    ~Planted() {
        ::unsetenv(variable_);
        fs::remove_all(folder_);
    }
    Planted(const Planted&) = delete;
    Planted& operator=(const Planted&) = delete;

  private:
    fs::path folder_;
    const char* variable_;
};

TEST_F(Visibility, ABiasOfTwentyPixelsIsFound) {
    const Planted kernels{"kernels", "LINEATLAS_KERNEL_DIR", "!(before > contact)",
                          "!(before > contact + 10.0f * depths.bend * inverse_w)"};
    Renderer renderer;
    for (const AtlasForm form : {AtlasForm::raster, AtlasForm::compute}) {
        for (const bool high : {false, true}) {
            const Setting setting{true, form, high};
            EXPECT_GT(error(renderer, cases.back(), setting, false), 100) << high;
            // Other lines are far behind what hides them.
            EXPECT_LE(error(renderer, cases.front(), setting, false), setting.tolerance()) << high;
        }
    }
}

TEST_F(Visibility, APlaneAtATexelsMiddleIsFound) {
    const Planted kernels{"kernels", "LINEATLAS_KERNEL_DIR", "plane_x * (side_x *",
                          "plane_x * ((TO_FLOAT(column) + 0.5f - x) *"};
    Renderer renderer;
    const Case& steep = cases[cases.size() - 2];
    for (const AtlasForm form : {AtlasForm::raster, AtlasForm::compute})
        EXPECT_GT(error(renderer, steep, {true, form, true}, false), 10);
}

TEST_F(Visibility, APatchNumberOffByOneIsFound) {
    const Camera camera = front_camera(true);
    const LineSet lines = extract_lines(sphere(), {.kinds = mask_of(LineKind::silhouette)});
    const auto seen = [&](AtlasForm form) {
        Renderer renderer;
        FrameOptions options = Setting{true, form, true}.options();
        options.lines = all_line_kinds;
        const Renderer::Samples samples = draw(renderer, lines, camera, options);
        return std::accumulate(samples.alpha.begin(), samples.alpha.end(), 0.0);
    };
    const std::array forms{AtlasForm::raster, AtlasForm::compute};
    const std::array good{seen(forms[0]), seen(forms[1])};
    const Planted kernels{"kernels", "LINEATLAS_KERNEL_DIR",
                          "own == spine.patch_a || own == spine.patch_b",
                          "own == spine.patch_a + 1 || own == spine.patch_b + 1"};
    EXPECT_LT(seen(forms[0]), 0.985 * good[0]);
    EXPECT_LT(seen(forms[1]), 0.985 * good[1]);
}

} // namespace
} // namespace lineatlas::test
