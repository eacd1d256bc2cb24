// Silhouettes of what nobody designed: what of them is noise goes, and the rest is smooth to the
// eye. A rule is seen by what it does to the same lines without the tag that they are of such a
// surface.

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "compute/cpp/cpp_device.hpp"
#include "compute/kernels.hpp"
#include "compute/stages/silhouette_chains.hpp"
#include "devices.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "test_meshes.hpp"
#include "vector/paths.hpp"
#include "visibility/line_tables.hpp"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace {

Camera view_of_ball(int pixels) {
    Camera camera;
    camera.size = glm::ivec2{pixels};
    camera.view = glm::lookAt(glm::vec3{3, 2, 4}, glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = glm::ortho(-1.2F, 1.2F, -1.2F, 1.2F, 1.0F, 20.0F);
    return camera;
}

class RoughContours : public testing::Test {
  protected:
    RoughContours() {
        untagged_.segments = lines_.segments;
        for (Segment& segment : untagged_.segments) segment.tag &= ~LA_TAG_UNDESIGNED;
    }

    static LineSet rough_ball() {
        Random random{48};
        return extract_lines(with_random_radii(sphere(6), random, 0.98F),
                             {.lines = mask_of(LineKind::silhouette),
                              .crease = 3.1F,
                              .silhouettes = Silhouettes::smooth});
    }
    const LineSet lines_ = rough_ball();
    LineSet untagged_ = lines_;
};

/// The turns of the visible lines at their points, radians, each point of a line alike.
double mean_turn(const VectorDrawing& drawing) {
    double sum = 0;
    std::size_t count = 0;
    for (const VectorPath& path : drawing.paths) {
        for (std::size_t i = 1; path.visible && i + 1 < path.points.size(); ++i) {
            const glm::dvec2 before = path.points[i].at - path.points[i - 1].at;
            const glm::dvec2 after = path.points[i + 1].at - path.points[i].at;
            if (before == glm::dvec2{0} || after == glm::dvec2{0}) continue;
            const double cosine = glm::dot(glm::normalize(before), glm::normalize(after));
            sum += std::acos(std::clamp(cosine, -1.0, 1.0));
            ++count;
        }
    }
    return sum / static_cast<double>(std::max<std::size_t>(count, 1));
}

/// The lines drawn from the same intervals with the tag, and without it.
struct Drawings {
    VectorDrawing tagged, untagged;
};
Drawings drawings_of(const LineSet& lines, const LineSet& untagged, const Camera& camera) {
    const std::vector<Interval> found = LineVisibility{lines}.find(camera, {.hidden = true});
    return {make_vector_drawing(lines, camera, found, Style{}),
            make_vector_drawing(untagged, camera, found, Style{})};
}

TEST_F(RoughContours, AreFaired) {
    const Drawings drawn = drawings_of(lines_, untagged_, view_of_ball(200));
    EXPECT_LT(mean_turn(drawn.tagged), 0.7 * mean_turn(drawn.untagged));
}

/// Visible lines that end sooner than crumbs do.
std::size_t crumbs(const VectorDrawing& drawing) {
    return static_cast<std::size_t>(std::ranges::count_if(drawing.paths, [&](const auto& path) {
        return path.visible && !path.closed &&
               length_of(path) < double{LA_LEAST_ROUGH} * drawing.size.y;
    }));
}

TEST_F(RoughContours, HaveNoCrumbs) {
    const Drawings drawn = drawings_of(lines_, untagged_, view_of_ball(800));
    EXPECT_GT(crumbs(drawn.untagged), 20U);
    EXPECT_LT(crumbs(drawn.tagged), crumbs(drawn.untagged) / 10);
}

/// Of the chains that a device makes of silhouettes, closed ones through few triangles, which are
/// not left out.
std::size_t small_loops(const LineSet& lines) {
    DeviceStages on{compute::make_cpp_device()};
    const LineTables tables = upload_lines(*on.device, lines);
    const LineTables::Chunk& chunk = tables.chunks[0];
    const compute::SegmentTable table{.vertices = *tables.vertices,
                                      .triangles = *tables.triangles,
                                      .segments = *chunk.segments,
                                      .triangle_count =
                                          static_cast<std::uint32_t>(lines.triangles.size()),
                                      .segment_count = chunk.range.count,
                                      .candidates = chunk.candidates()};
    compute::SilhouetteChains chains{on.stages, compute::SilhouetteChains::Contours::on_surface};
    const compute::SegmentTable found =
        chains.table_of(table, true, {{glm::normalize(glm::vec3{3, 2, 4}), 0}, false},
                        [](const char*, const auto& action) { action(); });
    const auto segments = read_back<Segment>(*on.device, found.segments, found.segment_count);
    return static_cast<std::size_t>(std::ranges::count_if(segments, [](const Segment& segment) {
        return segment.from_start == 0 && segment.to_end + 1 < LA_LEAST_LOOP &&
               (segment.tag & LA_TAG_CLOSED) != 0 && (segment.tag & LA_TAG_BURIED) == 0;
    }));
}

TEST_F(RoughContours, HaveNoSmallLoops) {
    EXPECT_GT(small_loops(untagged_), 20U);
    EXPECT_EQ(small_loops(lines_), 0U);
}

} // namespace
} // namespace lineatlas::test
