// The truth of round things: surfaces, not the triangles that stand for them.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "lines/weld.hpp"
#include "truth/fine_mesh.hpp"
#include "truth/model_truth.hpp"
#include "truth_views.hpp"

namespace lineatlas {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double large = 10, small = 4; ///< radii of the torus
constexpr glm::ivec2 size{800, 600};

/// A curve in the half plane y = 0, x > 0, turned about z, in `around` by `along` quads.
Mesh turned(const SurfaceCurve& curve, double first, double last, int around, int along) {
    Mesh mesh;
    mesh.surfaces.shapes = {{.point = {}, .axis = {0, 0, 1}, .curve = curve}};
    mesh.surfaces.surfaces = {{}};
    const auto profile = [&](double v) {
        return curve.kind == SurfaceCurve::Kind::line
                   ? std::pair{curve.point + v * curve.u, curve.u}
                   : std::pair{curve.point + std::cos(v) * curve.u + std::sin(v) * curve.v,
                               std::cos(v) * curve.v - std::sin(v) * curve.u};
    };
    struct Corner {
        glm::dvec2 parameters;
        glm::dvec3 at, normal;
    };
    const auto corner = [&](int i, int j) {
        const double u = turn * (i % around) / around;
        const double v = first + (last - first) * j / along;
        const auto [at, way] = profile(j == along && last - first == turn ? first : v);
        const glm::dvec3 out{std::cos(u), std::sin(u), 0};
        const glm::dvec3 normal = glm::normalize(glm::dvec3{way.z * out.x, way.z * out.y, -way.x});
        const bool on_axis = std::abs(at.x) < 1e-12, tip = on_axis && std::abs(way.z) > 1e-12;
        return Corner{{turn * i / around, v},
                      on_axis ? glm::dvec3{0, 0, at.z}
                              : glm::dvec3{at.x * out.x, at.x * out.y, at.z},
                      tip ? glm::dvec3{0} : normal};
    };
    const auto add = [&](const Corner& a, const Corner& b, const Corner& c) {
        if (a.at == b.at || b.at == c.at || c.at == a.at) return;
        const auto index = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Corner& one : {a, b, c}) {
            mesh.positions.emplace_back(one.at);
            mesh.corner_normals.emplace_back(one.normal);
        }
        mesh.triangles.emplace_back(index, index + 1, index + 2);
        mesh.surfaces.add_triangle(0, {a.parameters, b.parameters, c.parameters});
    };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < along; ++j) {
            add(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
            add(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
        }
    }
    return mesh;
}

Mesh torus() {
    return turned({.kind = SurfaceCurve::Kind::ellipse,
                   .point = {large, 0, 0},
                   .u = {small, 0, 0},
                   .v = {0, 0, small}},
                  0, turn, 96, 48);
}

Mesh sphere(int around) {
    return turned({.kind = SurfaceCurve::Kind::ellipse, .u = {9, 0, 0}, .v = {0, 0, 9}}, -turn / 4,
                  turn / 4, around, around / 2);
}

/// Open below; its rim is a circle of the file.
Mesh cone() {
    Mesh mesh = turned({.kind = SurfaceCurve::Kind::line, .point = {8, 0, -9}, .u = {-8, 0, 18}}, 0,
                       1, 32, 1);
    mesh.edge_curves = {EdgeCurve{.center = {0, 0, -9}, .u = {8, 0, 0}, .v = {0, 8, 0}}};
    for (const glm::uvec3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
            if (mesh.positions[t[k]].z == -9 && mesh.positions[t[(k + 1) % 3]].z == -9)
                mesh.known_edges.push_back(
                    {.from = t[k], .to = t[(k + 1) % 3], .kind = KnownEdge::Kind::free, .edge = 0});
    return mesh;
}

/// A mesh, its drawing from one direction, and what is true of it.
struct Seen {
    explicit Seen(Mesh one, const char* direction, const LineOptions& options = {},
                  Projection projection = Projection::perspective)
        : mesh(std::move(one)), lines(extract_lines(mesh, options)),
          camera(make_camera(frame_points_from(view_direction(direction, {0, 0, 1}), lines.vertices,
                                               size, View{}.fov_y, projection),
                             size, lines.bounds)),
          model(mesh, lines, options) {
        LineVisibility visibility{lines};
        drawing = make_vector_drawing(lines, camera, visibility.find(camera, {.hidden = true}),
                                      {.hidden = true}, {.mesh = &mesh});
    }

    Certificate certify() const {
        return model.certify(model.seen(camera), camera, drawn_lines(drawing));
    }

    Mesh mesh;
    LineSet lines;
    Camera camera;
    ModelTruth model;
    VectorDrawing drawing;
};

void expect_right(const Certificate& found) {
    EXPECT_GT(found.narrow.visible, 100);
    EXPECT_LT(found.narrow.missed_share(), 0.0005);
    EXPECT_LT(found.narrow.false_share(), 0.0001);
    EXPECT_LT(found.narrow.off, 0.05);
    if (::testing::Test::HasFailure()) std::puts(certificate_table(found, 5).c_str());
}

TEST(FineMesh, LiesOnTheSurfaceAndHasNoCracks) {
    const Mesh mesh = fine_mesh(torus(), 4);
    EXPECT_EQ(mesh.triangles.size(), 96U * 48 * 2 * 16);
    EXPECT_EQ(mesh.surfaces.of_triangle.size(), mesh.triangles.size());
    EXPECT_EQ(mesh.corner_normals.size(), 3 * mesh.triangles.size());
    for (const glm::vec3& position : mesh.positions) {
        const glm::dvec3 at{position};
        const double ring = std::hypot(at.x, at.y) - large;
        EXPECT_NEAR(std::hypot(ring, at.z), small, 1e-5);
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const glm::uvec3& triangle : weld(mesh).triangles)
        for (int k = 0; k < 3; ++k) ++sides[{triangle[k], triangle[(k + 1) % 3]}];
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(sides.contains({side.second, side.first}));
    }
}

TEST(FineMesh, KeepsWhatStandsBesideASurface) {
    // A lid on the cone's rim, which has the rim's chords.
    Mesh mesh = cone();
    const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.emplace_back(0, 0, -9);
    for (const KnownEdge& edge : mesh.known_edges) {
        mesh.triangles.emplace_back(edge.to, edge.from, middle);
        mesh.surfaces.add_triangle(KnownSurfaces::none, {});
        for (int k = 0; k < 3; ++k) mesh.corner_normals.emplace_back(0, 0, -1);
    }
    const Mesh fine = fine_mesh(mesh, 5);
    ASSERT_EQ(fine.known_edges.size(), 32U * 5);
    for (const KnownEdge& edge : fine.known_edges) {
        const glm::dvec3 at{fine.positions[edge.to]};
        EXPECT_NEAR(std::hypot(at.x, at.y), 8, 1e-5);
        EXPECT_EQ(edge.edge, 0U);
    }
    double lid = 0;
    for (std::size_t i = 0; i < fine.triangles.size(); ++i) {
        if (fine.surfaces.of_triangle[i] != KnownSurfaces::none) continue;
        const glm::uvec3 t = fine.triangles[i];
        const glm::dvec3 a{fine.positions[t.x]}, b{fine.positions[t.y]}, c{fine.positions[t.z]};
        lid -= glm::cross(b - a, c - a).z / 2;
    }
    const double sides = 32 * 5;
    EXPECT_NEAR(lid, sides / 2 * 64 * std::sin(turn / sides), 1e-3);
}

TEST(ModelTruth, ATorusAndAConeAreRightByTheMethodExact) {
    for (const char* direction : {"isometric", "front", "top", "75,35"}) {
        SCOPED_TRACE(direction);
        expect_right(Seen{torus(), direction}.certify());
    }
    for (const char* direction : {"isometric", "front"}) {
        SCOPED_TRACE(direction);
        expect_right(Seen{cone(), direction}.certify());
    }
}

/// A silhouette along meridians that the mesh has, through both poles.
TEST(ModelTruth, ASphereIsRightInParallelViews) {
    for (const int around : {32, 36}) {
        for (const char* direction : {"front", "right", "top", "isometric"}) {
            SCOPED_TRACE(direction);
            const Seen seen{sphere(around), direction, {}, Projection::orthographic};
            expect_right(seen.certify());
            EXPECT_EQ(std::ranges::count(seen.drawing.paths, true, &VectorPath::visible), 1);
        }
    }
}

TEST(ModelTruth, SilhouettesAlongEdgesAreNotRight) {
    const Certificate found =
        Seen{torus(), "isometric", {.silhouettes = Silhouettes::mesh}}.certify();
    EXPECT_GT(found.narrow.off, 0.1);
    EXPECT_GT(found.narrow.false_share() + found.narrow.missed_share(), 0.002);
}

TEST(ModelTruth, FindsPlantedErrors) {
    const Seen right{torus(), "isometric"};
    const auto certify = [&](const VectorDrawing& drawing) {
        return right.model.certify(right.model.seen(right.camera), right.camera,
                                   drawn_lines(drawing));
    };
    VectorDrawing moved = right.drawing;
    for (VectorPath& path : moved.paths) {
        path.curves.clear();
        for (VectorPoint& point : path.points) point.at.x += 0.3;
    }
    EXPECT_NEAR(certify(moved).narrow.off, 0.3, 0.06);

    VectorDrawing shown = right.drawing;
    double hidden = 0;
    for (VectorPath& path : shown.paths) {
        if (path.visible) continue;
        for (std::size_t i = 1; i < path.points.size(); ++i)
            hidden += glm::distance(path.points[i - 1].at, path.points[i].at);
        path.visible = true;
    }
    ASSERT_GT(hidden, 50);
    EXPECT_NEAR(certify(shown).narrow.false_pixels(), hidden, 0.2 * hidden);

    VectorDrawing halved = right.drawing;
    std::erase_if(halved.paths, [](const VectorPath& path) { return path.visible; });
    EXPECT_EQ(certify(halved).narrow.missed_share(), 1);
}

/// The rim of a disc of chords, 150 pixels wide: along chords or along the circle, but nowhere
/// else.
TEST(ModelTruth, AMeshMayBeDrawnAlongTheCircleThatItWasCutFrom) {
    Mesh disc;
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = 0; i < 24; ++i) {
        const double angle = turn * i / 24;
        disc.positions.emplace_back(1.5 * std::cos(angle), 1.5 * std::sin(angle), 0);
        corners.push_back(i);
    }
    add_polygon(disc, corners);
    const LineSet lines = extract_lines(disc);
    const ModelTruth model{disc, lines, {}};
    const Camera camera = test::front_camera();
    const EdgeTruth truth = model.seen(camera);
    const auto drawn = [&](double radius, int chords) {
        std::vector<glm::dvec2> points;
        for (int i = 0; i <= chords; ++i) {
            const double angle = turn * i / chords;
            points.push_back(200.0 + radius * glm::dvec2{std::cos(angle), std::sin(angle)});
        }
        DrawnLines along;
        append_legs(points, along.legs);
        return model.certify(truth, camera, along).narrow;
    };
    for (const int chords : {24, 480}) {
        SCOPED_TRACE(chords);
        const DrawingErrors right = drawn(150, chords), wrong = drawn(152, chords);
        EXPECT_EQ(right.missed_pixels() + right.false_pixels(), 0);
        EXPECT_GT(wrong.missed_share(), 0.3);
        EXPECT_GT(wrong.false_share(), 0.3);
    }
}

} // namespace
} // namespace lineatlas
