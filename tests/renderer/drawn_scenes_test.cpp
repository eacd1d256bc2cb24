// Drawings of the built-in scenes as paths. No line is drawn twice. Every tag leads back to an edge
// of the mesh, or to the two triangles that intersect there.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "vector_support.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{800, 600};

class DrawnScene : public testing::TestWithParam<const char*> {
  protected:
    DrawnScene()
        : scene_(make_scene(GetParam())), lines_(extract_lines(scene_.mesh)),
          camera_(make_camera(scene_.view(0), size, lines_.bounds)) {
        Renderer renderer;
        renderer.set_lines(lines_);
        FrameOptions options;
        options.intervals = KeptIntervals::all;
        options.draw = false;
        renderer.draw(camera_, options, 0);
        intervals_ = renderer.read_intervals();
    }

    VectorDrawing drawing(bool hidden) const {
        Style style;
        style.hidden = hidden;
        return make_vector_drawing(lines_, camera_, intervals_, style, {.mesh = &scene_.mesh});
    }

    /// The distance in pixels between a piece's part of its path and the edge of the mesh that it
    /// names; 0 for an edge that is partly behind the eye.
    double distance_to_edge(const VectorPath& path, const VectorPiece& piece) const {
        const glm::dmat4 clip_from_world{camera_.clip_from_world()};
        std::array<glm::dvec2, 2> edge;
        for (std::size_t end = 0; end < 2; ++end) {
            const std::uint32_t position = end == 0 ? piece.source.from : piece.source.to;
            const glm::dvec4 clip =
                clip_from_world * glm::dvec4{glm::dvec3{scene_.mesh.positions[position]}, 1};
            if (!(clip.w > 0)) return 0;
            edge[end] = (glm::dvec2{clip.x, -clip.y} / clip.w + 1.0) * 0.5 * glm::dvec2{size};
        }
        const glm::dvec2 start = path.points[piece.point].at;
        const glm::dvec2 way = path.points[piece.point + 1].at - start;
        const std::array<glm::dvec2, 2> part{start + way * double{piece.from},
                                             start + way * double{piece.to}};
        return std::max(distance(part[0], edge), distance(part[1], edge));
    }

    static double distance(glm::dvec2 point, const std::array<glm::dvec2, 2>& line) {
        const glm::dvec2 way = line[1] - line[0];
        const double squared = glm::dot(way, way);
        const double share =
            squared > 0 ? std::clamp(glm::dot(point - line[0], way) / squared, 0.0, 1.0) : 0;
        return glm::distance(point, line[0] + way * share);
    }

    static bool on_edge(glm::vec3 point, glm::vec3 p, glm::vec3 q, float near) {
        const float share = glm::dot(point - p, q - p) / glm::dot(q - p, q - p);
        return share >= 0 && share <= 1 && glm::distance(point, glm::mix(p, q, share)) <= near;
    }

    void expect_in_both_triangles(const VectorPiece& piece, float near) const {
        const Mesh& mesh = scene_.mesh;
        EXPECT_EQ(piece.source.from, LineSource::none);
        EXPECT_EQ(piece.source.to, LineSource::none);
        ASSERT_LT(piece.source.triangle, mesh.triangles.size());
        ASSERT_LT(piece.source.crossing, mesh.triangles.size());
        const Segment& segment = lines_.segments[piece.segment];
        for (const std::uint32_t triangle : {piece.source.triangle, piece.source.crossing}) {
            const glm::uvec3 t = mesh.triangles[triangle];
            const glm::dvec3 a{mesh.positions[t.x]};
            const glm::dvec3 normal = glm::normalize(glm::cross(
                glm::dvec3{mesh.positions[t.y]} - a, glm::dvec3{mesh.positions[t.z]} - a));
            for (const std::uint32_t end : {segment.p, segment.q})
                EXPECT_LE(std::abs(glm::dot(normal, glm::dvec3{lines_.vertices[end]} - a)),
                          static_cast<double>(near));
        }
    }

    gl::HeadlessContext context_;
    Scene scene_;
    LineSet lines_;
    Camera camera_;
    std::vector<Interval> intervals_;
};

TEST_P(DrawnScene, HasNoLineTwice) {
    for (const bool hidden : {false, true}) {
        const VectorDrawing drawing = this->drawing(hidden);
        EXPECT_GT(drawing.paths.size(), 20U);
        EXPECT_EQ(flaws_of(drawing), "");
        EXPECT_LE(longest_overlap(drawing.paths), 0.5);
    }
}

TEST_P(DrawnScene, TagsLeadBackToTheMesh) {
    const Mesh& mesh = scene_.mesh;
    const VectorDrawing drawing = this->drawing(true);
    const float near = 1e-6F * glm::distance(lines_.bounds.min, lines_.bounds.max);
    std::size_t pieces = 0;
    for (const VectorPath& path : drawing.paths) {
        for (const VectorPiece& piece : path.pieces) {
            const LineSource& source = piece.source;
            if (path.kind == LineKind::intersection) {
                // A vertex this near to a plane counts as in the plane (contact in
                // lines/intersections).
                expect_in_both_triangles(piece, 2.1F * near);
                continue;
            }
            ASSERT_LT(source.from, mesh.positions.size());
            ASSERT_LT(source.to, mesh.positions.size());
            ASSERT_LT(source.triangle, mesh.triangles.size());
            const glm::uvec3 corners = mesh.triangles[source.triangle];
            const auto is_corner = [&](std::uint32_t position) {
                return corners.x == position || corners.y == position || corners.z == position;
            };
            ASSERT_TRUE(is_corner(source.from) && is_corner(source.to) && source.from != source.to);
            ASSERT_EQ(piece.group, mesh.triangle_group[source.triangle]);
            const Segment& segment = lines_.segments[piece.segment];
            const glm::vec3 p = mesh.positions[source.from], q = mesh.positions[source.to];
            const glm::vec3 a = lines_.vertices[segment.p], b = lines_.vertices[segment.q];
            // The piece is the whole edge, or a part of it between seams.
            const bool is_whole = (p == a && q == b) || (p == b && q == a);
            ASSERT_TRUE(is_whole || (on_edge(a, p, q, near) && on_edge(b, p, q, near)));
            ++pieces;
            ASSERT_LT(piece.point + 1, path.points.size());
            ASSERT_LE(distance_to_edge(path, piece), 0.1);
        }
    }
    EXPECT_GT(pieces, 100U);
}

INSTANTIATE_TEST_SUITE_P(Scenes, DrawnScene, testing::Values("clevis", "house", "ship", "office"),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace lineatlas::test
