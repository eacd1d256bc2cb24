// Drawings of exact bodies that are round, whose silhouettes are known by hand, seen from all sides
// and level, where they are hardest to find.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <glm/geometric.hpp>

#include "brep_files.hpp"
#include "brep_fixture.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::vec3 up{0, 0, 1};
const std::vector<std::string> level{"front", "back", "left", "right"};
const std::vector<std::string> aslant{"isometric", "30,20", "75,35", "130,-20", "250,10"};

class RoundThings : public Brep {
  protected:
    std::vector<VectorPath> silhouettes(const TopoDS_Shape& shape, const std::string& direction,
                                        glm::ivec2 size) const {
        const LineSet lines =
            extract_lines(load("a.brep", to_brep(shape),
                               {.pixels = static_cast<double>(std::max(size.x, size.y))})
                              .mesh);
        const Camera camera =
            make_camera(frame_points_from(view_direction(direction, up), lines.vertices, size),
                        size, lines.bounds);
        LineVisibility visibility{lines};
        std::vector<VectorPath> paths =
            make_vector_drawing(lines, camera, visibility.find(camera), {}).paths;
        std::erase_if(paths, [](const VectorPath& path) {
            return !path.visible || path.kind != LineKind::silhouette;
        });
        return paths;
    }

    /// Calls it with the silhouettes from every side.
    template <class Check>
    void from_all_sides(const TopoDS_Shape& shape, const Check& check) const {
        for (const auto& directions : {level, aslant})
            for (const std::string& direction : directions) {
                SCOPED_TRACE(direction);
                check(silhouettes(shape, direction, {1024, 768}));
            }
    }
};

TEST_F(RoundThings, AConeHasTwoLinesThatMeetAtItsTip) {
    constexpr double height = 20;
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(10, 0, height).Shape();
    from_all_sides(cone, [&](const std::vector<VectorPath>& paths) {
        ASSERT_EQ(paths.size(), 2U);
        std::vector<glm::dvec2> tips;
        for (const VectorPath& path : paths)
            for (const VectorPoint& end : {path.points.front(), path.points.back()})
                if (end.world.z > height / 2) tips.push_back(end.at);
        ASSERT_EQ(tips.size(), 2U);
        EXPECT_LT(glm::distance(tips[0], tips[1]), 1e-9);
    });
}

TEST_F(RoundThings, ASphereIsOneClosedCurve) {
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(10).Shape();
    from_all_sides(sphere, [&](const std::vector<VectorPath>& paths) {
        ASSERT_EQ(paths.size(), 1U);
        EXPECT_TRUE(paths[0].closed);
    });
}

TEST_F(RoundThings, ATallCylinderHasTwoStraightLines) {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 300).Shape();
    from_all_sides(cylinder, [&](const std::vector<VectorPath>& paths) {
        ASSERT_EQ(paths.size(), 2U);
        for (const VectorPath& path : paths) {
            const glm::dvec2 a = path.points.front().at;
            const glm::dvec2 way = path.points.back().at - a;
            for (const VectorPoint& point : path.points) {
                const glm::dvec2 to = point.at - a;
                EXPECT_NEAR((way.x * to.y - way.y * to.x) / glm::length(way), 0, 0.05);
            }
        }
    });
}

/// A fillet so thin that its triangles lie aslant costs neither it nor others their silhouettes.
TEST_F(RoundThings, ThinFilletsAreNotTorn) {
    for (const double radius : {0.3, 0.5}) {
        SCOPED_TRACE(radius);
        const TopoDS_Shape pillar = BRepPrimAPI_MakeCylinder(20, 40).Shape();
        BRepFilletAPI_MakeFillet fillet(pillar);
        for (TopExp_Explorer edges(pillar, TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
            TopoDS_Vertex first, last;
            TopExp::Vertices(edge, first, last);
            if (first.IsSame(last) && BRep_Tool::Pnt(first).Z() > 39) {
                fillet.Add(radius, edge);
                break;
            }
        }
        const TopoDS_Shape rounded = fillet.Shape();
        for (const std::string& direction : aslant) {
            SCOPED_TRACE(direction);
            // One way around the upper rim and down both sides, or less where it is seen from
            // below.
            EXPECT_LE(silhouettes(rounded, direction, {1024, 768}).size(), 3U);
        }
    }
}

} // namespace
} // namespace lineatlas::test
