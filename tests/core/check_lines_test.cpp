// Line sets that a program has made or changed, in which kernels and GL would read out of range.

#include "core/check_lines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "lineatlas/assembly.hpp"
#include "lineatlas/error.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t far_out = 1U << 30U;

/// A line set with all tables that it may have.
LineSet whole_set() {
    Mesh mesh = test::sphere(2);
    mesh.groups = {{.object = "ball", .material = "", .color = glm::vec3{1, 0, 0}}};
    mesh.triangle_group.assign(mesh.triangles.size(), 0);
    return extract_lines(mesh, {.separate_objects = true, .silhouettes = Silhouettes::smooth});
}

struct Change {
    std::string part; ///< of the message
    std::function<void(LineSet&)> apply;
};

std::vector<Change> changes() {
    return {
        {"vertex 2 is not finite", [](LineSet& l) { l.vertices[2].y = NAN; }},
        {"triangle 1 has the index", [](LineSet& l) { l.triangles[1].z = far_out; }},
        {"segment 0 has the index", [](LineSet& l) { l.segments[0].p = far_out; }},
        {"segment 0 has the index", [](LineSet& l) { l.segments[0].q = far_out; }},
        {"segment 0 has the index", [](LineSet& l) { l.segments[0].face_a = far_out; }},
        {"segment 0 has the index",
         [](LineSet& l) { l.segments[0].face_b = far_out | LA_FACE_FLIPPED; }},
        {"segment 0 has other neighbours", [](LineSet& l) { l.segments[0].from_start = 1; }},
        {"has other neighbours", [](LineSet& l) { l.segments.back().to_end = 7; }},
        {"triangle_color has 1 values", [](LineSet& l) { l.triangle_color.resize(1); }},
        {"triangle_color 0 has the index 9", [](LineSet& l) { l.triangle_color[0] = 9; }},
        {"triangle_group has 1 values", [](LineSet& l) { l.triangle_group.resize(1); }},
        {"triangle_group 0 has the index 9", [](LineSet& l) { l.triangle_group[0] = 9; }},
        {"object 0 has vertices up to", [](LineSet& l) { l.objects[0].vertex_count += 1; }},
        {"cut vertex 0 has the index",
         [](LineSet& l) {
             l.cut_vertices.push_back({0, far_out, 0, 0});
         }},
        {"corner 0 has the index", [](LineSet& l) { l.contours.corners[0].vertex = far_out; }},
        {"edge 0 has the index", [](LineSet& l) { l.contours.edges[0].y = far_out; }},
        {"face 0 has the index",
         [](LineSet& l) { l.contours.faces[0].x = far_out | LA_CONTOUR_TURNED; }},
        {"contours stand for", [](LineSet& l) { l.contours.replaced = far_out; }},
        {"stands for a contour", [](LineSet& l) { l.segments.back().face_a = LA_NO_FACE; }},
    };
}

TEST(CheckLines, EachIndexOutOfRangeIsNamed) {
    const LineSet whole = whole_set();
    ASSERT_FALSE(whole.contours.empty());
    ASSERT_FALSE(whole.triangle_color.empty());
    ASSERT_FALSE(whole.objects.empty());
    EXPECT_NO_THROW(check_lines(whole));
    for (const auto& [part, apply] : changes()) {
        LineSet wrong = whole;
        apply(wrong);
        try {
            check_lines(wrong);
            ADD_FAILURE() << "taken: " << part;
        } catch (const UsageError& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find("line set: "), 0U) << message;
            EXPECT_NE(message.find(part), std::string::npos) << message;
        }
    }
}

TEST(CheckLines, PathsOfSeveralSegmentsCountEachOther) {
    LineSet lines = extract_lines(test::cylinder(16, true));
    const auto inner =
        std::ranges::find_if(lines.segments, [](const Segment& s) { return s.from_start > 0; });
    ASSERT_NE(inner, lines.segments.end());
    EXPECT_NO_THROW(check_lines(lines));
    inner->from_start += 1;
    EXPECT_THROW(check_lines(lines), UsageError);
}

TEST(CheckLines, NothingAndPartsWithRoomBetweenThemAreTaken) {
    EXPECT_NO_THROW(check_lines({}));
    Assembly parts;
    EXPECT_NO_THROW(check_lines(parts.lines()));
    for (int i = 0; i < 3; ++i) parts.add(whole_set());
    parts.remove(1);
    EXPECT_NO_THROW(check_lines(parts.lines()));
}

} // namespace
} // namespace lineatlas
