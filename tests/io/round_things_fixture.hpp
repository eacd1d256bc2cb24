#pragma once

// Drawings of exact round bodies, and what the lines of such drawings are.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
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
#include "lineatlas/section.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"

namespace lineatlas::test {

inline constexpr glm::vec3 up{0, 0, 1};

/// Pixels per unit of length.
inline double scale_of(const View& view, int height) {
    return height / static_cast<double>(shown_height(view));
}

inline const std::vector<std::string> level{"front", "back", "left", "right"};

inline const std::vector<std::string> aslant{"isometric", "30,20", "75,35", "130,-20", "250,10"};

/// The radii of the drawing's lines, which must be whole circles: smallest first, in the model's
/// units.
inline std::vector<double> circles(const VectorDrawing& drawing, double scale) {
    std::vector<double> radii;
    for (const VectorPath& path : drawing.paths) {
        if (!path.visible) continue;
        EXPECT_TRUE(path.closed);
        EXPECT_EQ(path.curves.size(), 1U);
        if (path.curves.size() != 1) return {};
        EXPECT_FALSE(path.curves[0].cubic);
        EXPECT_EQ(path.curves[0].arc.ratio, 1);
        radii.push_back(path.curves[0].arc.major.x / scale);
    }
    std::ranges::sort(radii);
    return radii;
}

class RoundThings : public Brep {
  protected:
    /// A drawing of a file.
    VectorDrawing drawing(const std::string& name, const std::string& file,
                          const std::string& direction, glm::ivec2 size, Projection projection,
                          const std::vector<SectionPlane>& planes = {}) const {
        const Mesh mesh =
            cut_mesh(
                load(name, file, {.pixels = static_cast<double>(std::max(size.x, size.y))}).mesh,
                planes, {.none = true})
                .mesh;
        const LineSet lines = extract_lines(mesh);
        view_ = frame_points_from(view_direction(direction, up), lines.vertices, size, View{}.fov_y,
                                  projection);
        const Camera camera = make_camera(view_, size, lines.bounds);
        LineVisibility visibility{lines};
        return make_vector_drawing(lines, camera, visibility.find(camera, {.hidden = true}), {},
                                   {.mesh = &mesh});
    }

    std::vector<VectorPath> silhouettes(const TopoDS_Shape& shape, const std::string& direction,
                                        glm::ivec2 size) const {
        std::vector<VectorPath> paths =
            drawing("a.brep", to_brep(shape), direction, size, Projection::perspective).paths;
        std::erase_if(paths, [](const VectorPath& path) {
            return !path.visible || path.kind != LineKind::silhouette;
        });
        return paths;
    }

    mutable View view_; ///< of the last drawing

    /// Calls `check` with the silhouettes from every side.
    template <class Check>
    void from_all_sides(const TopoDS_Shape& shape, const Check& check) const {
        for (const auto& directions : {level, aslant})
            for (const std::string& direction : directions) {
                SCOPED_TRACE(direction);
                check(silhouettes(shape, direction, {1024, 768}));
            }
    }
};

/// Pixels from a place to the nearest point of a path.
inline double distance_to(const VectorPath& path, glm::dvec2 at) {
    double nearest = INFINITY;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
        const glm::dvec2 a = path.points[i].at, way = path.points[i + 1].at - a;
        const double share = std::clamp(glm::dot(at - a, way) / glm::dot(way, way), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(at, a + share * way));
    }
    return nearest;
}

/// What a drawing's lines are: the arcs, and the length of what is straight, both in the model's
/// units.
struct Parts {
    std::vector<VectorArc> arcs;
    double straight = 0;
};

inline Parts parts_of(const VectorDrawing& drawing, double scale) {
    Parts parts;
    for (const VectorPath& path : drawing.paths) {
        if (!path.visible) continue;
        std::vector<bool> is_straight(path.points.size() - 1, true);
        for (const VectorCurve& curve : path.curves) {
            EXPECT_FALSE(curve.cubic);
            for (std::uint32_t i = curve.first; i < curve.last; ++i) is_straight[i] = false;
            VectorArc arc = curve.arc;
            arc.major /= scale;
            parts.arcs.push_back(arc);
        }
        for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
            if (is_straight[i])
                parts.straight += glm::distance(path.points[i].at, path.points[i + 1].at) / scale;
    }
    return parts;
}

/// Of radius 10 and height 30, with a fillet of 3 around its top.
inline TopoDS_Shape rounded_cylinder() {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 30).Shape();
    BRepFilletAPI_MakeFillet fillet{cylinder};
    for (TopExp_Explorer edges{cylinder, TopAbs_EDGE}; edges.More(); edges.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
        const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
        if (BRep_Tool::Pnt(vertex).Z() > 29 && TopExp::LastVertex(edge).IsSame(vertex))
            fillet.Add(3, edge);
    }
    return fillet.Shape();
}

} // namespace lineatlas::test
