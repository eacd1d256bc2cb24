#include "lineatlas/lines.hpp"
#include "lines/edges.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "compute/cpp/cpp_device.hpp"
#include "devices.hpp"
#include "lineatlas/error.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

LineKind kind_of(const Segment& segment) {
    return static_cast<LineKind>(segment.tag & LA_TAG_KIND_MASK);
}
bool is_closed(const Segment& segment) {
    return (segment.tag & LA_TAG_CLOSED) != 0;
}
bool is_lone(const Segment& segment) {
    return (segment.tag & LA_TAG_LONE) != 0;
}
std::uint32_t count(const LineSet& lines, LineKind kind) {
    return lines.kind_counts[static_cast<std::size_t>(kind)];
}

/// Expects all that lines.hpp and segment_table.h promise about vertices and triangles.
void expect_sound_vertices(const LineSet& lines) {
    std::set<std::array<float, 3>> positions;
    std::vector<bool> used(lines.vertices.size(), false);
    Bounds bounds;
    for (const glm::vec3& v : lines.vertices) {
        EXPECT_TRUE(positions.insert({v.x, v.y, v.z}).second) << "two vertices are equal";
        bounds.min = glm::min(bounds.min, v);
        bounds.max = glm::max(bounds.max, v);
    }
    EXPECT_EQ(lines.bounds.min, bounds.min);
    EXPECT_EQ(lines.bounds.max, bounds.max);
    std::set<std::set<std::uint32_t>> triangles;
    for (const glm::uvec3& t : lines.triangles) {
        const std::set corners{t.x, t.y, t.z};
        EXPECT_EQ(corners.size(), 3U) << "a repeated corner";
        EXPECT_TRUE(triangles.insert(corners).second) << "a duplicate triangle";
        for (const std::uint32_t corner : corners) used.at(corner) = true;
    }
    for (const Segment& s : lines.segments) used.at(s.p) = used.at(s.q) = true;
    EXPECT_EQ(std::ranges::count(used, false), 0) << "vertices that nothing uses";
}

/// Expects all that is promised about the segments of one path, which are neighbours in the table.
void expect_sound_path(std::span<const Segment> path) {
    for (std::size_t i = 0; i < path.size(); ++i) {
        EXPECT_EQ(path[i].from_start, i);
        EXPECT_EQ(path[i].to_end, path.size() - 1 - i);
        EXPECT_EQ(path[i].tag & ~LA_TAG_LONE, path[0].tag & ~LA_TAG_LONE) << "kinds are mixed";
        if (i > 0) {
            EXPECT_EQ(path[i - 1].q, path[i].p) << "neighbours without a common vertex";
        }
    }
    if (is_closed(path[0])) {
        EXPECT_GE(path.size(), 3U);
        EXPECT_EQ(path.back().q, path.front().p);
    }
    if (kind_of(path[0]) == LineKind::silhouette) {
        EXPECT_EQ(path.size(), 1U);
    }
}

void expect_sound(const LineSet& lines) {
    expect_sound_vertices(lines);
    WeldedMesh faces;
    faces.vertices = lines.vertices;
    faces.triangles = lines.triangles;
    const std::vector<glm::dvec3> normals = face_normals(faces);
    const bool has_slivers = std::ranges::find(normals, glm::dvec3{0}) != normals.end();
    std::array<std::uint32_t, LA_KIND_COUNT> kinds{};
    std::vector<int> touching(lines.vertices.size(), 0);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    bool silhouettes = false;
    std::set<std::uint32_t> cut;
    for (const CutVertex& vertex : lines.cut_vertices) cut.insert(vertex.vertex);
    for (const Segment& s : lines.segments) {
        ASSERT_NE(s.p, s.q);
        EXPECT_TRUE(edges.insert(std::minmax(s.p, s.q)).second) << "an edge stands twice";
        ASSERT_LT(static_cast<std::size_t>(kind_of(s)), kinds.size());
        ++kinds[static_cast<std::size_t>(kind_of(s))];
        ++touching[s.p];
        ++touching[s.q];
        silhouettes = silhouettes || kind_of(s) == LineKind::silhouette;
        EXPECT_EQ(silhouettes, kind_of(s) == LineKind::silhouette) << "candidates are not last";
        for (const std::uint32_t face : {s.face_a, s.face_b}) {
            if (face == LA_NO_FACE) continue;
            const glm::uvec3 t = lines.triangles.at(face & LA_FACE_INDEX);
            const std::set corners{t.x, t.y, t.z};
            const bool beside = corners.contains(s.p) && corners.contains(s.q);
            const bool is_cut = cut.contains(s.p) || cut.contains(s.q);
            // A neighbouring face may stand for a sliver.
            EXPECT_TRUE(beside || has_slivers || is_cut || kind_of(s) == LineKind::intersection)
                << "not beside its face";
        }
        if (s.face_a == LA_NO_FACE) {
            EXPECT_EQ(s.face_b, LA_NO_FACE);
        }
        if (kind_of(s) == LineKind::silhouette) {
            EXPECT_NE(s.face_b, LA_NO_FACE);
        }
    }
    EXPECT_EQ(kinds, lines.kind_counts);
    for (const CutVertex& cut : lines.cut_vertices) ++touching[cut.vertex];
    for (const Segment& s : lines.segments) {
        EXPECT_EQ(is_lone(s), touching[s.p] == 1 && touching[s.q] == 1);
    }
    std::uint32_t path = 0;
    for (std::size_t i = 0; i < lines.segments.size(); ++path) {
        std::size_t end = i;
        while (end < lines.segments.size() && lines.segments[end].path == path) ++end;
        ASSERT_GT(end, i) << "paths are not one after the other";
        expect_sound_path({lines.segments.data() + i, end - i});
        i = end;
    }
    EXPECT_EQ(path, lines.path_count);
}

void add_random_polylines(Mesh& mesh, test::Random& random, int polylines) {
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    for (int i = 0; i < polylines; ++i) {
        auto& polyline = mesh.polylines.emplace_back();
        for (std::uint32_t n = 2 + random.below(12); n > 0; --n) {
            polyline.push_back(random.below(count));
        }
    }
}

TEST(ExtractLines, LineSetsAreSound) {
    test::Random random{51};
    for (const Mesh& mesh :
         {Mesh{}, test::cube(), test::with_own_corners(test::cube()), test::tetrahedron(),
          test::sphere(3), test::cylinder(24, true), test::cylinder(24, false),
          test::cylinder(100, true), test::open_strip(7), test::height_field(random, 20, 1),
          test::two_sided_quad(), test::bent_pair(1, true), test::moebius_band(16),
          test::faces_on_an_edge(5), test::split_edge(1)}) {
        expect_sound(
            extract_lines(mesh, {.silhouettes = Silhouettes::mesh})); // else see contours_test
    }
}

TEST(ExtractLines, LineSetsOfRandomSoupsAreSound) {
    test::Random random{52};
    for (int round = 0; round < 40; ++round) {
        Mesh mesh = test::random_soup(random, 5 + random.below(40), 1 + random.below(80));
        std::erase_if(mesh.triangles, [](const glm::uvec3& t) {
            return t.x == t.y || t.y == t.z || t.z == t.x; // see NothingIsKeptOfDroppedTriangles
        });
        mesh = test::with_random_groups(mesh, random, 3);
        add_random_polylines(mesh, random, round % 4);
        LineOptions options;
        options.crease = random.between(0, 3.1F);
        options.chain_angle = random.between(0, 3.1F);
        expect_sound(extract_lines(mesh, options));
    }
}

TEST(ExtractLines, NothingIsKeptOfDroppedTriangles) {
    Mesh mesh = test::cube();
    mesh.positions.emplace_back(100, 0, 0);
    mesh.positions.emplace_back(-100, 0, 0);
    // It has neither area nor length, so there is nothing to draw.
    mesh.triangles.emplace_back(8, 8, 9);
    mesh.polylines = {{9}};
    expect_sound(extract_lines(mesh));
    EXPECT_EQ(extract_lines(mesh).bounds.max, glm::vec3(1, 1, 1));
}

TEST(ExtractLines, TrianglesKeepTheColorsOfTheirGroups) {
    Mesh mesh = test::cube();
    EXPECT_TRUE(extract_lines(mesh).triangle_color.empty());
    const glm::vec3 red{1, 0, 0};
    const glm::vec3 blue{0, 0, 1};
    mesh.groups = {{.object = "a", .material = "m", .color = red},
                   {.object = "b", .material = "m", .color = std::nullopt},
                   {.object = "c", .material = "m", .color = blue},
                   {.object = "d", .material = "n", .color = red}};
    mesh.triangle_group = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    mesh.triangles[5] = {7, 7, 7}; // dropped
    const LineSet lines = extract_lines(mesh);
    EXPECT_EQ(lines.colors, (std::vector<glm::vec3>{red, blue}));
    constexpr std::uint16_t none = LineSet::no_color;
    EXPECT_EQ(lines.triangle_color,
              (std::vector<std::uint16_t>{0, none, 1, 0, 0, 1, 0, 0, none, 1, 0}));

    for (MeshGroup& group : mesh.groups) group.color.reset();
    EXPECT_TRUE(extract_lines(mesh).triangle_color.empty());
}

TEST(ExtractLines, KindsThatAreNotWantedAreNotThere) {
    test::Random random{53};
    Mesh mesh = test::with_random_groups(test::height_field(random, 6, 1), random, 2);
    add_random_polylines(mesh, random, 8);
    for (const PolylineKind kind :
         {PolylineKind::file, PolylineKind::section, PolylineKind::hatching, PolylineKind::trail})
        mesh.polyline_kind.insert(mesh.polyline_kind.end(), 2, kind);
    for (LineKindMask mask = 0; mask <= all_line_kinds; ++mask) {
        const LineSet lines = extract_lines(mesh, {.lines = mask, .crease = 0.5F});
        expect_sound(lines);
        for (std::uint32_t kind = 0; kind < LA_KIND_COUNT; ++kind) {
            // The mesh is one part without intersections, too coarse for ridges, and without
            // information from a file.
            constexpr LineKindMask others = LA_KINDS_WITHIN | mask_of(LineKind::tangent);
            const bool there = (mask & 1U << kind & ~others) != 0;
            EXPECT_EQ(lines.kind_counts[kind] > 0, there);
        }
    }
}

TEST(ExtractLines, ACubesEdgesAreTwelvePaths) {
    const LineSet lines = extract_lines(test::cube());
    EXPECT_EQ(lines.segments.size(), 12U);
    EXPECT_EQ(lines.path_count, 12U); // no path goes on around corners of 90 degrees
}

TEST(ExtractLines, TheRimsOfACylinderAreLoops) {
    for (const bool capped : {true, false}) {
        const LineSet lines = extract_lines(test::cylinder(32, capped));
        const LineKind rim = capped ? LineKind::crease : LineKind::boundary;
        EXPECT_EQ(count(lines, rim), 64U);
        EXPECT_EQ(count(lines, LineKind::silhouette), 32U);
        std::set<std::uint32_t> paths;
        for (const Segment& s : lines.segments) {
            if (kind_of(s) != rim) continue;
            EXPECT_TRUE(is_closed(s));
            EXPECT_EQ(s.from_start + s.to_end, 31U);
            paths.insert(s.path);
        }
        EXPECT_EQ(paths.size(), 2U);
    }
}

/// A turned prism with coordinates rounded to a grid.
Mesh rounded_prism(int corners, int turn, float grid) {
    const glm::mat3 matrix{glm::rotate(glm::mat4{1}, 0.37F * static_cast<float>(turn),
                                       glm::normalize(glm::vec3{1, 2, 3}))};
    Mesh mesh = test::cylinder(corners, true);
    for (glm::vec3& p : mesh.positions) {
        p = matrix * p;
        if (grid > 0) p = grid * glm::round(p / grid);
    }
    return mesh;
}

TEST(ExtractLines, EqualBendsAreAllCreasesOrNone) {
    // The sides of a prism with twelve corners bend by 30 degrees, and those of one with thirteen
    // by 27.7. Rounding to floats or to a grid changes the angles slightly. The file may name the
    // grid or not.
    for (int turn = 0; turn < 20; ++turn) {
        for (const float grid : {0.0F, 0.004F}) {
            for (const float told : {0.0F, grid / 2, 10 * grid}) {
                Mesh twelve = rounded_prism(12, turn, grid);
                Mesh thirteen = rounded_prism(13, turn, grid);
                twelve.precision = thirteen.precision = told;
                EXPECT_EQ(count(extract_lines(twelve), LineKind::crease), 36U) << turn << told;
                EXPECT_EQ(count(extract_lines(thirteen), LineKind::crease), 26U) << turn << told;
            }
        }
    }
}

TEST(ExtractLines, ALineThatTouchesNoOtherIsLone) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 3, 0}};
    mesh.polylines = {{0, 1}, {2, 3}, {4, 5, 6}};
    const LineSet lines = extract_lines(mesh);
    ASSERT_EQ(lines.segments.size(), 4U);
    EXPECT_EQ(std::ranges::count_if(lines.segments, is_lone), 2);
    mesh.polylines.push_back({1, 2}); // the first two now touch it
    EXPECT_EQ(std::ranges::count_if(extract_lines(mesh).segments, is_lone), 0);
}

TEST(ExtractLines, PolylinesOnMeshEdgesStandOnceWithTheirFaces) {
    Mesh mesh = test::with_own_corners(test::cube());
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& p : test::cube().positions) mesh.positions.push_back(p);
    const std::uint32_t far_away = first + 8;
    mesh.positions.emplace_back(5, 5, 5);
    // Two creases, of which one comes again backwards, a diagonal, which is no line by itself, and
    // a free line.
    mesh.polylines = {{first, first + 1, first + 3, first + 1},
                      {first + 1, first},
                      {first, first + 3},
                      {first + 7, far_away}};
    const LineSet lines = extract_lines(mesh);
    expect_sound(lines);
    EXPECT_EQ(count(lines, LineKind::file), 4U);
    EXPECT_EQ(count(lines, LineKind::crease), 10U);
    for (const Segment& s : lines.segments) {
        if (kind_of(s) != LineKind::file) continue;
        const bool free = lines.vertices[s.p].x == 5 || lines.vertices[s.q].x == 5;
        EXPECT_EQ(s.face_a == LA_NO_FACE, free);
        EXPECT_EQ(s.face_b == LA_NO_FACE, free);
    }
    const LineSet without =
        extract_lines(mesh, {.lines = all_line_kinds & ~mask_of(LineKind::file)});
    EXPECT_EQ(count(without, LineKind::crease), 12U);
}

TEST(ExtractLines, FileLinesKeepTheWindingOfFlippedFaces) {
    Mesh mesh = test::bent_pair(1, true);
    mesh.polylines = {{1, 0}};
    const LineSet lines = extract_lines(mesh);
    const auto line = std::ranges::find(lines.segments, LineKind::file, kind_of);
    ASSERT_NE(line, lines.segments.end());
    EXPECT_NE(line->face_b & LA_FACE_FLIPPED, 0U);
}

TEST(ExtractLines, BadMeshesAreRefused) {
    Mesh mesh = test::cube();
    mesh.triangles[3].y = 8;
    EXPECT_THROW(extract_lines(mesh), UsageError);
}

TEST(ExtractLines, AnglesOutOfRangeAreRefused) {
    const Mesh mesh = test::cube();
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float angle : {-0.001F, 3.15F, infinite, std::nanf(""), 1e38F}) {
        EXPECT_THROW(extract_lines(mesh, {.crease = angle}), UsageError) << angle;
        EXPECT_THROW(extract_lines(mesh, {.chain_angle = angle}), UsageError) << angle;
    }
    EXPECT_EQ(extract_lines(mesh, {.crease = 0}).kind_counts[LA_KIND_CREASE], 12U);
    EXPECT_NO_THROW(extract_lines(mesh, {.crease = 180 * 0.017453293F}));
}

TEST(ExtractLines, GroupsThatAreNotThereAreRefused) {
    Mesh mesh = test::cube();
    mesh.groups = {{.object = "a", .material = {}}, {.object = "b", .material = {}}};
    mesh.triangle_group.assign(12, 1);
    EXPECT_NO_THROW(extract_lines(mesh));
    mesh.triangle_group[7] = 2;
    for (const bool separate : {false, true}) {
        try {
            extract_lines(mesh, {.separate_objects = separate});
            ADD_FAILURE() << "no error";
        } catch (const UsageError& error) {
            EXPECT_STREQ(error.what(),
                         "mesh: triangle 7 is of group 2, but there are 2, counted from 0");
        }
    }
    mesh.triangle_group.resize(7);
    EXPECT_THROW(extract_lines(mesh), UsageError) << "too few";
    mesh.triangle_group.clear();
    EXPECT_THROW(extract_lines(mesh), UsageError) << "groups of no triangle";
    mesh.groups.clear();
    EXPECT_NO_THROW(extract_lines(mesh));
}

// Silhouettes, chosen by the rule of kernels/facing.cl and kernels/project_clip.cl.

std::vector<Segment> silhouettes_of(const LineSet& lines, glm::vec4 eye) {
    test::DeviceStages on{compute::make_cpp_device()};
    const auto vertices = test::to_device(*on.device, lines.vertices);
    const auto triangles = test::to_device(*on.device, lines.triangles);
    const auto none = on.device->allocate(16);
    const auto seen = on.device->allocate(lines.triangles.size());
    const auto count = static_cast<std::uint32_t>(lines.triangles.size());
    on.stages.facing({*vertices, *triangles, *none, count, 0}, eye, *seen);
    const auto front = test::read_back<std::uint8_t>(*on.device, *seen, count);
    std::vector<Segment> result;
    for (const Segment& s : lines.segments) {
        if (s.face_b == LA_NO_FACE) continue;
        const bool flipped = (s.face_b & LA_FACE_FLIPPED) != 0;
        const bool front_b = (front[s.face_b & LA_FACE_INDEX] != 0) != flipped;
        if ((front[s.face_a] != 0) != front_b) result.push_back(s);
    }
    return result;
}

bool all_loops_close(const std::vector<Segment>& segments) {
    std::map<std::uint32_t, int> ends;
    for (const Segment& s : segments) {
        ++ends[s.p];
        ++ends[s.q];
    }
    return std::ranges::all_of(ends, [](const auto& entry) { return entry.second % 2 == 0; });
}

constexpr LineOptions silhouettes_only{.lines = mask_of(LineKind::silhouette)};

TEST(Silhouettes, OfAClosedMeshFormClosedLoopsFromEverywhere) {
    test::Random random{54};
    for (const Mesh& shape :
         {test::cube(), test::tetrahedron(), test::sphere(3),
          test::with_random_radii(test::sphere(3), random, 0.5F), test::cylinder(40, true)}) {
        for (const bool wound_right : {true, false}) {
            const Mesh placed = test::moved(shape, random.placement(3));
            const LineSet lines =
                extract_lines(wound_right ? placed : test::with_random_windings(placed, random));
            for (int round = 0; round < 60; ++round) {
                const bool parallel = round % 3 == 0;
                const glm::vec4 eye{parallel ? random.direction() : random.point(8),
                                    parallel ? 0 : 1};
                const std::vector<Segment> silhouettes = silhouettes_of(lines, eye);
                EXPECT_TRUE(all_loops_close(silhouettes));
                if (parallel) {
                    EXPECT_GE(silhouettes.size(), 3U) << "no outline";
                }
            }
        }
    }
}

TEST(Silhouettes, OfACubeFromACornerAreAHexagon) {
    const LineSet lines = extract_lines(test::cube(), silhouettes_only);
    EXPECT_EQ(lines.segments.size(), 12U);
    EXPECT_EQ(silhouettes_of(lines, {5, 4, 3, 1}).size(), 6U);
    EXPECT_EQ(silhouettes_of(lines, {5, 0, 0, 1}).size(), 4U);
    EXPECT_EQ(silhouettes_of(lines, {5, 1, 0, 1}).size(), 4U); // the eye in a face's plane
    EXPECT_EQ(silhouettes_of(lines, {0, 0, 0, 1}).size(), 0U); // all are backs
    EXPECT_EQ(silhouettes_of(lines, {0, 1, 0, 0}).size(), 4U);
}

TEST(Silhouettes, OfASphereLieOnItsOutline) {
    const LineSet lines = extract_lines(test::sphere(4), silhouettes_only);
    test::Random random{55};
    for (int round = 0; round < 20; ++round) {
        const glm::vec3 back = random.direction();
        const std::vector<Segment> silhouettes = silhouettes_of(lines, {3.0F * back, 1});
        EXPECT_GT(silhouettes.size(), 40U);
        for (const Segment& s : silhouettes) {
            for (const std::uint32_t vertex : {s.p, s.q}) {
                EXPECT_NEAR(glm::dot(lines.vertices[vertex], back), 1.0F / 3, 0.12F);
            }
        }
    }
}

/// A sliver has no facing. Between two front faces it must not make a line.
TEST(Silhouettes, AreNotMadeBySlivers) {
    const Mesh mesh = test::split_edge(glm::radians(-10.0F)); // bent away from the eye
    const LineSet lines = extract_lines(mesh);
    EXPECT_GT(count(lines, LineKind::silhouette), 0U);
    EXPECT_EQ(silhouettes_of(lines, {0, 0.5F, 5, 1}).size(), 0U) << "both faces are fronts";
    EXPECT_EQ(silhouettes_of(lines, {0, 0.5F, -5, 1}).size(), 0U) << "both faces are backs";
    EXPECT_GE(silhouettes_of(lines, {5, 0.5F, -0.2F, 1}).size(), 1U) << "one front, one back";
}

TEST(Lines, OfAPartThatLooksInwardsAreThoseOfOneThatLooksOutwards) {
    const LineOptions along_edges{.silhouettes = Silhouettes::mesh};
    const LineSet right = extract_lines(test::sphere(3), along_edges);
    Mesh mesh = test::sphere(3);
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    const glm::uvec3 marked = mesh.triangles.front();
    mesh.known_edges = {{marked.y, marked.z, KnownEdge::Kind::marked}};
    const LineSet turned = extract_lines(mesh, along_edges);
    ASSERT_EQ(turned.segments.size(), right.segments.size());
    EXPECT_EQ(count(turned, LineKind::crease), count(right, LineKind::crease) + 1);
    const auto looks_outwards = [](const LineSet& lines, const glm::uvec3& t) {
        const glm::vec3 a = lines.vertices[t.x], b = lines.vertices[t.y], c = lines.vertices[t.z];
        return glm::dot(glm::cross(b - a, c - a), a) > 0;
    };
    for (const glm::uvec3& t : turned.triangles) EXPECT_TRUE(looks_outwards(turned, t));
    for (std::size_t i = 0; i < turned.segments.size(); ++i) {
        const Segment& segment = turned.segments[i];
        const LineSource& source = turned.sources[i];
        EXPECT_EQ(mesh.positions[source.from], turned.vertices[segment.p]);
        EXPECT_EQ(mesh.positions[source.to], turned.vertices[segment.q]);
        if (kind_of(segment) != LineKind::crease) continue;
        EXPECT_TRUE((source.from == marked.y && source.to == marked.z) ||
                    (source.from == marked.z && source.to == marked.y));
    }
    // An open mesh is not turned.
    mesh.triangles.pop_back();
    const LineSet open = extract_lines(mesh);
    for (const glm::uvec3& t : open.triangles) EXPECT_FALSE(looks_outwards(open, t));
}

} // namespace
} // namespace lineatlas
