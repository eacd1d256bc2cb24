// Circles of a part with holes in all sides, counted against what the part was made of: in a view
// that looks along its axis every one of them is drawn once, as one circle.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <glm/geometric.hpp>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>

#include "brep_files.hpp"
#include "brep_fixture.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{1200, 900};

/// A circle in space.
struct Circle {
    glm::dvec3 center;
    int axis; ///< 0 to 2
    double radius;
};

/// A body and the circles on it.
struct Part {
    TopoDS_Shape shape = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 80, 60, 40).Shape();
    std::vector<Circle> circles{};

    static gp_Ax2 axis_from(glm::dvec3 from, int axis) {
        return {gp_Pnt(from.x, from.y, from.z), gp_Dir(axis == 0, axis == 1, axis == 2)};
    }
    static glm::dvec3 along(glm::dvec3 from, int axis, double way) {
        from[axis] += way;
        return from;
    }
    void hole(glm::dvec3 from, int axis, double radius, double depth) {
        const gp_Ax2 place = axis_from(from, axis);
        shape = BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeCylinder(place, radius, depth)).Shape();
        circles.push_back({from, axis, radius});
        circles.push_back({along(from, axis, depth), axis, radius});
    }
    /// A countersink from one radius to another.
    void sink(glm::dvec3 from, int axis, double radius, double to, double depth) {
        const gp_Ax2 place = axis_from(from, axis);
        shape = BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeCone(place, radius, to, depth)).Shape();
        circles.push_back({from, axis, radius});
        circles.push_back({along(from, axis, depth), axis, to});
    }
    void boss(glm::dvec3 from, int axis, double radius, double height) {
        const gp_Ax2 place = axis_from(from, axis);
        shape = BRepAlgoAPI_Fuse(shape, BRepPrimAPI_MakeCylinder(place, radius, height)).Shape();
        circles.push_back({from, axis, radius});
        circles.push_back({along(from, axis, height), axis, radius});
    }
};

/// Through holes, blind holes, counterbores, countersinks, bosses with holes; in three directions.
Part block() {
    Part part;
    for (const double x : {12.0, 40.0, 68.0}) part.hole({x, 12, 0}, 2, 4, 40); // through
    part.hole({20, 40, 40 - 15}, 2, 5, 15);                                    // blind
    part.hole({20, 40, 40 - 6}, 2, 8, 6);                                      // counterbored
    part.circles[part.circles.size() - 3] = {{20, 40, 34}, 2, 5};              // where the two meet
    part.boss({55, 40, 40}, 2, 12, 10);
    part.hole({55, 40, 30}, 2, 6, 20);
    part.hole({0, 20, 20}, 0, 3, 9);
    part.hole({0, 45, 12}, 0, 2.5, 8);
    part.sink({12, 0, 28}, 1, 5, 2, 6);
    part.hole({70, 0, 28}, 1, 3.5, 7);
    return part;
}

/// Where a view shows a point, right and up, in the part's units.
struct Side {
    std::string name;
    glm::dvec3 right, up;
};

const std::vector<Side> sides{{"front", {1, 0, 0}, {0, 0, 1}}, {"back", {-1, 0, 0}, {0, 0, 1}},
                              {"right", {0, 1, 0}, {0, 0, 1}}, {"left", {0, -1, 0}, {0, 0, 1}},
                              {"top", {1, 0, 0}, {0, 1, 0}},   {"bottom", {1, 0, 0}, {0, -1, 0}}};

/// A circle on paper.
struct Drawn {
    glm::dvec2 center;
    double radius;

    bool is(const Drawn& other) const {
        return glm::distance(center, other.center) < 1e-3 && std::abs(radius - other.radius) < 1e-4;
    }
};

class Circles : public Brep {
  protected:
    /// Every whole circle, and each that is drawn in parts once for each part.
    std::vector<Drawn> drawn(const std::string& name, const std::string& file,
                             const Side& side) const {
        const Mesh mesh = load(name, file, {.pixels = double{size.x}}).mesh;
        const LineSet lines = extract_lines(mesh);
        const View view = frame_points_from(view_direction(side.name, {0, 0, 1}), lines.vertices,
                                            size, View{}.fov_y, Projection::orthographic);
        const Camera camera = make_camera(view, size, lines.bounds);
        Style style;
        style.hidden = true;
        LineVisibility visibility{lines};
        const VectorDrawing drawing = make_vector_drawing(
            lines, camera, visibility.find(camera, {.hidden = true}), style, {.mesh = &mesh});
        const double unit = size.y / static_cast<double>(shown_height(view));
        const glm::dvec3 target{view.target};
        const glm::dvec2 middle{glm::dot(target, side.right), glm::dot(target, side.up)};
        std::vector<Drawn> found;
        for (const VectorPath& path : drawing.paths) {
            for (const VectorCurve& curve : path.curves) {
                const glm::dvec2 at = (curve.arc.center - 0.5 * glm::dvec2{size}) / unit;
                found.push_back(
                    {middle + glm::dvec2{at.x, -at.y}, glm::length(curve.arc.major) / unit});
                EXPECT_TRUE(path.closed && path.curves.size() == 1)
                    << "a part of the circle of radius " << found.back().radius;
            }
        }
        return found;
    }

    void expect_all_once(const std::string& name, const std::string& file,
                         const std::vector<Circle>& circles) const {
        for (const Side& side : sides) {
            SCOPED_TRACE(side.name);
            std::vector<Drawn> wanted;
            for (const Circle& circle : circles) {
                glm::dvec3 axis{0};
                axis[circle.axis] = 1;
                if (glm::dot(axis, side.right) != 0 || glm::dot(axis, side.up) != 0) continue;
                const Drawn one{
                    {glm::dot(circle.center, side.right), glm::dot(circle.center, side.up)},
                    circle.radius};
                if (std::ranges::none_of(wanted, [&](const Drawn& w) { return w.is(one); }))
                    wanted.push_back(one);
            }
            const std::vector<Drawn> found = drawn(name, file, side);
            EXPECT_FALSE(wanted.empty());
            EXPECT_EQ(found.size(), wanted.size());
            for (const Drawn& one : wanted)
                EXPECT_EQ(std::ranges::count_if(found, [&](const Drawn& f) { return f.is(one); }),
                          1)
                    << one.radius << " at " << one.center.x << ", " << one.center.y;
        }
    }
};

TEST_F(Circles, OfAPartSeenEndOnAreDrawnOnceEach) {
    const Part part = block();
    expect_all_once("a.step", to_step({{"block", part.shape, {gp_Trsf{}}}}), part.circles);
}

// A post with a ball on top, and one that is a ball alone: the silhouettes of balls.
TEST_F(Circles, OfBallsOfSplinesAreCircles) {
    Part part;
    part.shape =
        BRepAlgoAPI_Fuse(part.shape,
                         BRepPrimAPI_MakeCylinder(Part::axis_from({20, 20, 40}, 2), 4, 10).Shape())
            .Shape();
    for (const double x : {20.0, 55.0}) {
        const gp_Pnt middle(x, 20, x < 30 ? 52 : 42);
        part.shape =
            BRepAlgoAPI_Fuse(part.shape, BRepPrimAPI_MakeSphere(middle, 7).Shape()).Shape();
    }
    const std::string file = to_brep(BRepBuilderAPI_NurbsConvert(part.shape).Shape());
    int balls = 0;
    for (const Drawn& one : drawn("a.brep", file, sides[4])) {
        if (std::abs(one.radius - 7) > 1e-3) continue;
        EXPECT_NEAR(one.radius, 7, 1e-4);
        EXPECT_NEAR(one.center.x, one.center.x < 30 ? 20 : 55, 1e-4);
        EXPECT_NEAR(one.center.y, 20, 1e-4);
        ++balls;
    }
    EXPECT_EQ(balls, 2);
}

TEST_F(Circles, OfSplinesSeenEndOnAreDrawnOnceEach) {
    const Part part = block();
    expect_all_once("a.brep", to_brep(BRepBuilderAPI_NurbsConvert(part.shape).Shape()),
                    part.circles);
}

} // namespace
} // namespace lineatlas::test
