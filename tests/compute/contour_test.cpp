// contour: where the interpolated normal turns away from the eye, on edges whose answers are known.

#include <array>
#include <cmath>
#include <utility>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "compute/stages/silhouette_chains.hpp"
#include "core/objects.hpp"
#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

/// A corner on the unit circle of the plane z = 0, whose normal points away from the middle.
ContourCorner on_circle(std::uint32_t vertex, float angle) {
    return {.vertex = vertex, .normal = {std::cos(angle), std::sin(angle), 0}};
}

/// A mesh of which contours may run through all triangles, behind one other candidate.
struct ContourModel {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    std::vector<ContourCorner> corners;
    std::vector<compute::ContourEdge> edges;
    std::vector<glm::uvec3> face_corners;
    std::vector<compute::ContourFace> faces;
};

struct FoundContour {
    std::vector<std::uint32_t> is_crossed; ///< of each face
    std::vector<compute::ContourCrossing> crossings;
    std::vector<glm::vec3> vertices; ///< behind those of the mesh
};

class ContourTest : public StageTest {
  protected:
    FoundContour find_contour(const ContourModel& model, const glm::vec4& eye,
                              const std::vector<std::uint8_t>& shows_front) {
        const auto faces = static_cast<std::uint32_t>(model.faces.size());
        const auto own_vertices = static_cast<std::uint32_t>(model.vertices.size());
        std::vector<glm::vec3> room = model.vertices;
        room.resize(own_vertices + 4 * faces);
        const auto vertices = put(room), triangles = put(model.triangles),
                   corners = put(model.corners), edges = put(model.edges),
                   face_corners = put(model.face_corners), face_table = put(model.faces),
                   front = put(shows_front);
        const compute::ContourTables tables{.corners = corners.get(),
                                            .edges = edges.get(),
                                            .face_corners = face_corners.get(),
                                            .faces = face_table.get(),
                                            .edge_count =
                                                static_cast<std::uint32_t>(model.edges.size()),
                                            .face_count = faces,
                                            .replaced = 0,
                                            .vertex_count = own_vertices};
        const compute::SilhouetteCandidates candidates{
            .first = 0, .count = 1 + faces, .contours = tables};
        const std::vector<std::uint32_t> nothing(faces + 2, 0);
        const compute::SegmentTable table{*vertices, *triangles, *vertices,
                                          faces,     1 + faces,  candidates};
        compute::ChainTables made{&device()};
        made.numbers.upload(std::span{nothing});
        stages().contour(table, eye, made);
        FoundContour found;
        const auto flags = get<std::uint32_t>(*made.numbers, 1 + faces);
        found.is_crossed.assign(flags.begin() + 1, flags.end());
        std::vector<std::uint32_t> scanned{0}, chosen;
        for (std::uint32_t c = 0; c <= faces; ++c) {
            if (flags[c] != 0) chosen.push_back(c);
            scanned.push_back(static_cast<std::uint32_t>(chosen.size()));
        }
        const auto count = static_cast<std::uint32_t>(chosen.size());
        if (count == 0) return found;
        made.numbers.upload(std::span{std::as_const(scanned)});
        made.chosen.upload(std::span{std::as_const(chosen)});
        const auto crossings = device().allocate(count * sizeof(compute::ContourCrossing));
        stages().contour_places({.table = table,
                                 .view = {eye, true},
                                 .lifted = true,
                                 .count = count,
                                 .tables = made,
                                 .crossings = crossings.get()},
                                *front);
        found.crossings = get<compute::ContourCrossing>(*crossings, count);
        const auto all = get<glm::vec3>(*vertices, room.size());
        found.vertices.assign(all.begin() + own_vertices, all.end());
        return found;
    }
};

LINEATLAS_STAGE_TEST_OF(ContourStage, ContourTest);

TEST_P(ContourStage, CrossesTheArcWhereItTurnsAway) {
    // Three corners: two on an arc, of which the second is seen from +x, and one beside. Two
    // triangles lie on each other, and share all their edges but one.
    const float half = 0.1F, ahead = 0.03F, middle = 0.5F * 3.14159265F;
    const std::array<float, 2> angle{middle + half + ahead, middle - half + ahead};
    constexpr std::uint32_t turned = LA_CONTOUR_TURNED;
    const ContourModel model{
        .vertices = {{std::cos(angle[0]), std::sin(angle[0]), 0},
                     {std::cos(angle[1]), std::sin(angle[1]), 0},
                     {std::cos(angle[1]), std::sin(angle[1]), 1}},
        .triangles = {{0, 1, 2}, {0, 2, 1}},
        .corners = {on_circle(0, angle[0]), on_circle(1, angle[1]), on_circle(2, angle[1])},
        .edges = {{0, 1}, {0, 1}, {0, 1}, {0, 1}},
        .face_corners = {{0, 1, 2}, {0, 2, 1}},
        .faces = {{{0, 1, 2 | turned}, {1, LA_NO_FACE, 1}},
                  {{2, 3, 0 | turned}, {0, LA_NO_FACE, 0}}}};
    const FoundContour all = find_contour(model, {1, 0, 0, 0}, {1, 1});
    EXPECT_EQ(all.is_crossed, (std::vector<std::uint32_t>{1, 1}));
    ASSERT_EQ(all.crossings.size(), 2U);
    // Around the first triangle it rises on the first edge, where it finds the place, and falls on
    // the last, which is turned: there the other one does.
    EXPECT_EQ(all.crossings[0].q, 3U + 2);
    EXPECT_EQ(all.crossings[0].p, 3U + 4 + 2);
    EXPECT_EQ(all.crossings[1].p, all.crossings[0].q);
    EXPECT_EQ(all.crossings[1].q, all.crossings[0].p);
    for (const int i : {0, 1}) {
        EXPECT_EQ(all.crossings[static_cast<std::size_t>(i)].before, 1U - i) << i;
        EXPECT_EQ(all.crossings[static_cast<std::size_t>(i)].after, 1U - i) << i;
    }
    for (const std::size_t kept : {0, 1, 4, 5}) EXPECT_EQ(all.vertices[kept], glm::vec3{0}) << kept;
    const glm::vec3 found = all.vertices[2], lifted = all.vertices[3];
    // By the cubic's four points, at the share where the normals turn, but for the sine of an angle
    // that counts as none; and the arc's top as far as a cubic can be, whose error grows with the
    // fourth power of the angle.
    const glm::dvec2 a{model.vertices[0]}, d{model.vertices[1]}, way = d - a;
    const glm::dvec2 b = a + (way - glm::dot(way, a) * a) / 3.0;
    const glm::dvec2 c = d - (way - glm::dot(way, d) * d) / 3.0;
    const double t = (a.x - 1e-5) / (a.x - d.x);
    const glm::dvec2 ab = glm::mix(a, b, t), bc = glm::mix(b, c, t), cd = glm::mix(c, d, t);
    const glm::dvec2 on_cubic = glm::mix(glm::mix(ab, bc, t), glm::mix(bc, cd, t), t);
    EXPECT_NEAR(found.x, on_cubic.x, 1e-6);
    EXPECT_NEAR(found.y, on_cubic.y, 1e-6);
    const double fourth = std::pow(double{half}, 4);
    EXPECT_NEAR(glm::length(on_cubic), 1, 0.4 * fourth);
    EXPECT_NEAR(found.x, 0, fourth);
    EXPECT_NEAR(found.z, 0, 1e-6);
    const float chord = 2 * std::sin(half);
    EXPECT_NEAR(glm::distance(lifted, found), LA_CONTOUR_LIFT * 0.5 * chord * chord, 1e-5);
    EXPECT_GT(lifted.y, found.y);
    EXPECT_NEAR(all.vertices[6].y, 1, 2e-3); // runs aslant over the arc
    EXPECT_NEAR(all.vertices[6].x, 0, 1e-2);
}

TEST_P(ContourStage, EndsWhereTheLineOfABorderDoes) {
    // An edge of the unit circle, from 0.13 to -0.07 radians about its top as an eye at +x sees it,
    // where one surface ends in another.
    const float middle = 0.5F * 3.14159265F, ahead = 0.13F, behind = 0.07F;
    const std::array<float, 2> angle{middle + ahead, middle - behind};
    const std::vector<glm::vec3> vertices{{std::cos(angle[0]), std::sin(angle[0]), 0},
                                          {std::cos(angle[1]), std::sin(angle[1]), 0},
                                          {0, 1, 1},
                                          {0, 1, -1}};
    const auto place = [&](std::vector<std::uint8_t> shows_front, bool mirrored = false) {
        // Counter-clockwise as seen from where the normals point to, or clockwise.
        std::vector<glm::uvec3> triangles{{1, 0, 2}, {0, 1, 3}};
        if (mirrored) triangles = {{0, 1, 2}, {1, 0, 3}};
        // Of the surface one triangle, whose last two corners are one and the same.
        const FoundContour found =
            find_contour({.vertices = vertices,
                          .triangles = triangles,
                          .corners = {on_circle(0, angle[0]), on_circle(1, angle[1])},
                          .edges = {{0, 1}, {0, 1}, {0, 1}},
                          .face_corners = {{0, 1, 1}},
                          .faces = {{{0, 1, 2}, {LA_NO_FACE, LA_NO_FACE, LA_NO_FACE}}}},
                         {1, 0, 0, 0}, shows_front);
        EXPECT_EQ(found.crossings.at(0).after, LA_NO_SILHOUETTE);
        EXPECT_EQ(found.crossings.at(0).q, 4U + 2);
        return found.vertices.at(2);
    };
    // The line along the edge is straight, and all of it is seen if one of its faces shows its
    // front. Else none of it is, and the line before it ends at the vertex whose surface does.
    const double share = std::sin(0.13) / (std::sin(0.13) + std::sin(0.07));
    const double height = std::cos(0.13) + share * (std::cos(0.07) - std::cos(0.13));
    for (const std::vector<std::uint8_t>& front :
         {std::vector<std::uint8_t>{1, 0}, {0, 1}, {1, 1}}) {
        EXPECT_NEAR(place(front).x, 0, 2e-5);
        EXPECT_NEAR(place(front).y, height, 1e-6);
    }
    EXPECT_EQ(place({0, 0}), vertices[1]);
    // What is mirrored shows its front where its triangles are clockwise.
    EXPECT_EQ(place({1, 1}, true), vertices[1]);
    EXPECT_NEAR(place({0, 0}, true).y, height, 1e-6);
    EXPECT_NEAR(place({0, 1}, true).y, height, 1e-6);
}

TEST_P(ContourStage, EndsAtATip) {
    // A cone of half a right angle around z, whose tip has no normal: two triangles from the rim to
    // it, of which the eye at +x sees one on either side of its outline, and one beside.
    const auto on_rim = [](std::uint32_t vertex, float angle) {
        const float slant = std::sqrt(0.5F);
        return ContourCorner{vertex, {slant * std::cos(angle), slant * std::sin(angle), slant}};
    };
    const std::array<float, 3> angle{1.4F, 1.7F, 2.0F};
    ContourModel model{.vertices = {{0, 0, 1}},
                       .triangles = {{1, 2, 0}, {2, 3, 0}},
                       .corners = {{0, {0, 0, 0}}},
                       .edges = {{0, LA_NO_FACE}, {0, 1}, {0, 1}, {1, LA_NO_FACE}, {1, 1}},
                       .face_corners = {{1, 2, 0}, {2, 3, 0}},
                       .faces = {{{0, 1, 2}, {LA_NO_FACE, 1, LA_NO_FACE}},
                                 {{3, 4, 1 | LA_CONTOUR_TURNED}, {LA_NO_FACE, LA_NO_FACE, 0}}}};
    for (std::uint32_t i = 0; i < 3; ++i) {
        model.vertices.push_back({std::cos(angle[i]), std::sin(angle[i]), 0});
        model.corners.push_back(on_rim(i + 1, angle[i]));
    }
    const FoundContour found = find_contour(model, {1, 0, 0, 0}, {1, 1});
    EXPECT_EQ(found.is_crossed, (std::vector<std::uint32_t>{1, 0}));
    ASSERT_EQ(found.crossings.size(), 1U);
    const compute::ContourCrossing& crossing = found.crossings[0];
    EXPECT_EQ(crossing.before, LA_NO_SILHOUETTE);
    EXPECT_EQ(crossing.after, LA_NO_SILHOUETTE);
    const std::uint32_t own = 4;
    // It runs from the rim to the tip, which is no higher where it is lifted, or the other way.
    const std::uint32_t at_tip = crossing.underside != 0 ? crossing.p : crossing.q;
    const std::uint32_t at_rim = crossing.p + crossing.q - at_tip;
    EXPECT_EQ(found.vertices.at(at_tip - own), model.vertices[0]);
    EXPECT_EQ(found.vertices.at(at_tip - own + 1), model.vertices[0]);
    EXPECT_NEAR(found.vertices.at(at_rim - own).x, 0, 1e-3);
}

TEST_P(ContourStage, LeavesOutWhatIsSeenWhole) {
    const FoundContour found =
        find_contour({.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                      .triangles = {{0, 1, 2}},
                      .corners = {{0, {0, 0, 1}}, {1, {0.6F, 0, 0.8F}}, {2, {0, -0.6F, 0.8F}}},
                      .edges = {{0, 1}, {0, 1}, {0, 1}},
                      .face_corners = {{0, 1, 2}},
                      .faces = {{{0, 1, 2}, {LA_NO_FACE, LA_NO_FACE, LA_NO_FACE}}}},
                     {1, 2, 30, 1}, {1});
    EXPECT_EQ(found.is_crossed, std::vector<std::uint32_t>{0});
}

void expect_normal(const ContourCorner& corner, glm::vec3 expected, float within) {
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(corner.normal[axis], expected[axis], within) << axis;
}

TEST_P(ContourStage, NormalsTurnWithTheirObjects) {
    const float third = 1.0F / 3;
    const std::vector<ContourCorner> made{{0, {third, 2 * third, -2 * third}},
                                          {1, {0.6F, 0.8F, 0}},
                                          {2, {0.6F, 0.8F, 0}},
                                          {3, {0.6F, 0.8F, 0}},
                                          {1, {0, 0, 1}}};
    const glm::mat4 moved = glm::translate(glm::mat4{1}, {5, -6, 7});
    const glm::mat4 quarter = glm::rotate(moved, 0.5F * 3.14159265F, {0, 0, 1});
    // A plane along (4, -3, 0) lies along (-8, -3, 0) then: its normal is (-3, 8, 0).
    const glm::mat4 mirrored = glm::scale(glm::mat4{1}, {-2, 1, 3});
    std::vector<float> turns;
    for (const glm::mat4& m : {moved, quarter, mirrored, glm::mat4{0}}) {
        const glm::mat3 turn = normal_turn(m);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) turns.push_back(turn[column][row]);
    }
    const auto rest = put(made), corners = put(std::vector<ContourCorner>(made.size()));
    const auto objects = put(std::vector<std::uint32_t>{0, 1, 2, 3});
    const auto rows = put(turns);
    stages().launch_each<compute::kernels::contour_turn>(
        static_cast<std::uint32_t>(made.size()),
        {.rest = *rest, .objects = *objects, .turns = *rows, .corners = *corners});
    const auto turned = get<ContourCorner>(*corners, made.size());
    for (std::size_t i = 0; i < made.size(); ++i) EXPECT_EQ(turned[i].vertex, made[i].vertex);
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(turned[0].normal[axis], made[0].normal[axis]);
    expect_normal(turned[1], {-0.8F, 0.6F, 0}, 1e-6F);
    expect_normal(turned[2], glm::vec3{-3, 8, 0} / std::sqrt(73.0F), 1e-6F);
    expect_normal(turned[3], {0, 0, 0}, 0);
    expect_normal(turned[4], {0, 0, 1}, 1e-6F);
}

TEST_P(ContourStage, NormalsAnewAreThoseOfTrianglesByTheirAngles) {
    // Around the first vertex three squares of a cube, one of them in two triangles; at the next
    // corner 135 degrees of one plane and 45 of another; the last one has a triangle without area.
    const auto vertices = put(std::vector<glm::vec3>{
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, 0, 3}, {-1, 1, 0}, {0, 1, 1}});
    const auto triangles = put(std::vector<glm::uvec3>{
        {0, 1, 2}, {3, 0, 2}, {3, 4, 0}, {0, 4, 1}, {0, 1, 5}, {0, 2, 6}, {0, 1, 1}});
    const auto offsets = put(std::vector<std::uint32_t>{0, 4, 6, 7});
    const auto places = put(std::vector<std::uint32_t>{0, 4, 8, 9, 12, 15, 18});
    const auto corners =
        put(std::vector<ContourCorner>{{0, {9, 9, 9}}, {0, {9, 9, 9}}, {0, {9, 9, 9}}});
    stages().launch_each<compute::kernels::contour_normals>(3, {.vertices = *vertices,
                                                                .triangles = *triangles,
                                                                .offsets = *offsets,
                                                                .places = *places,
                                                                .corners = *corners});
    const auto found = get<ContourCorner>(*corners, 3);
    expect_normal(found[0], glm::vec3{1, 1, 1} / std::sqrt(3.0F), 2e-5F);
    expect_normal(found[1], glm::vec3{1, 0, 3} / std::sqrt(10.0F), 2e-5F);
    expect_normal(found[2], {0, 0, 0}, 0);
}

} // namespace
} // namespace lineatlas::test
