#include "known_visibility.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace lineatlas::test {

Camera front_camera(bool perspective) {
    Camera camera;
    camera.size = {side, side};
    camera.view = glm::lookAt(glm::vec3{0, 0, eye_z}, glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = perspective ? glm::perspective(2 * std::atan(0.2F), 1.0F, 1.0F, 100.0F)
                                    : glm::ortho(-2.0F, 2.0F, -2.0F, 2.0F, 1.0F, 100.0F);
    return camera;
}

glm::dvec2 window(const Camera& camera, glm::vec3 point) {
    const glm::dvec4 clip =
        glm::dmat4{camera.projection} * glm::dmat4{camera.view} * glm::dvec4{point, 1};
    return (glm::dvec2{clip} / clip.w + 1.0) * (0.5 * side);
}

double length_px(const Camera& camera, glm::vec3 p, glm::vec3 q) {
    return glm::distance(window(camera, p), window(camera, q));
}

namespace {

/// Pixels per unit at depth z.
double scale_at(bool perspective, double z) {
    return perspective ? per_unit * eye_z / (eye_z - z) : per_unit;
}

/// The x at depth z of the place that a point at x and depth `from` covers.
double behind(bool perspective, double x, double from, double z) {
    return x * scale_at(perspective, from) / scale_at(perspective, z);
}

/// A slightly oblique line across the picture at depth z, so that it crosses texels at all places.
struct Across {
    glm::vec3 p, q;
    double length; ///< on the screen

    Across(const Camera& camera, float z, float y = 0.013F)
        : p{-1.503F, y, z}, q{1.497F, y + 0.1F, z}, length(length_px(camera, p, q)) {}
    /// The place on the line where it passes x.
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
    // A line that is seen through the same gap lengthwise.
    const auto middle = static_cast<float>(behind(perspective, (left + right) / 2, 0.5, -0.5));
    const glm::vec3 p{middle, -0.7F, -0.5F}, q{middle, 0.7F, -0.5F};
    known.line(p, q, {{0, length_px(camera, p, q)}});
    return known;
}

/// Sheets 0.3, 0.7, 1, 1.5 and 5 pixels before lines hide the lines. A surface hides at any
/// distance.
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

/// A line 5.5 pixels before a sheet that rises by 10 to 1 across it. Half a pixel to the right the
/// sheet comes before the line, but no probe is that far away.
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

/// A slope of 45 degrees with a long edge on one side and two short ones on the other.
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
    whole(low, middle), whole(middle, high); // both are edges of two faces
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
    // A line in the outermost pixels, and one that leaves the picture on the right.
    const glm::vec3 p{-1.995F, -1.5F, 0}, q{-1.995F, 1.5F, 0};
    known.line(p, q, {{0, length_px(camera, p, q)}});
    known.line({0.5F, 0.3F, 0}, {3, 0.3F, 0}, {{0, 150}}); // pixels inside
    // A line behind a sheet. Both leave the picture at the bottom.
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

} // namespace

std::span<const Case> known_cases() {
    return cases;
}

} // namespace lineatlas::test
