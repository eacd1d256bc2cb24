// Any number of threads finds the same lines, bit by bit.

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "lineatlas/lines.hpp"
#include "lineatlas/scenes.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

LineSet lines_by(int threads, const Mesh& mesh, const LineOptions& options) {
    const tbb::global_control most{tbb::global_control::max_allowed_parallelism,
                                   static_cast<std::size_t>(threads)};
    tbb::task_arena arena{threads};
    return arena.execute([&] { return extract_lines(mesh, options); });
}

template <class T>
bool are_same(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// The first table of the two that differs; empty if none does.
std::string difference(const LineSet& a, const LineSet& b) {
    if (!are_same(a.vertices, b.vertices)) return "vertices";
    if (!are_same(a.triangles, b.triangles)) return "triangles";
    if (!are_same(a.segments, b.segments)) return "segments";
    if (!are_same(a.sources, b.sources)) return "sources";
    if (!are_same(a.vertex_sources, b.vertex_sources)) return "vertex_sources";
    if (!are_same(a.triangle_sources, b.triangle_sources)) return "triangle_sources";
    if (!are_same(a.triangle_group, b.triangle_group)) return "triangle_group";
    if (!are_same(a.triangle_color, b.triangle_color)) return "triangle_color";
    if (!are_same(a.cut_vertices, b.cut_vertices)) return "cut_vertices";
    if (!are_same(a.contours.corners, b.contours.corners)) return "corners of contours";
    if (!are_same(a.contours.edges, b.contours.edges)) return "edges of contours";
    if (!are_same(a.contours.faces, b.contours.faces)) return "faces of contours";
    if (a.path_count != b.path_count || a.kind_counts != b.kind_counts) return "counts";
    if (a.odd.collapsed != b.odd.collapsed || a.odd.repeated != b.odd.repeated) return "odd";
    return "";
}

void expect_same_by_any_threads(const Mesh& mesh, const LineOptions& options) {
    const LineSet expected = lines_by(1, mesh, options);
    EXPECT_FALSE(expected.segments.empty());
    for (const int threads : {2, 3, 8})
        EXPECT_EQ(difference(expected, lines_by(threads, mesh, options)), "") << threads;
}

TEST(Threads, DontChangeTheLinesOfScenes) {
    for (const std::string_view name : scene_names()) {
        SCOPED_TRACE(name);
        const Mesh mesh = make_scene(name).mesh;
        expect_same_by_any_threads(mesh, {});
        expect_same_by_any_threads(mesh, {.separate_objects = true});
    }
}

TEST(Threads, DontChangeTheLinesOfARoughSurface) {
    test::Random random{17};
    const Mesh field = test::height_field(random, 150, 0.4F);
    expect_same_by_any_threads(field, {});
    expect_same_by_any_threads(test::with_own_corners(field), {});
}

TEST(Threads, DontChangeTheLinesOfASoup) {
    test::Random random{18};
    expect_same_by_any_threads(test::random_soup(random, 1000, 4000), {});
    const Mesh apart = test::with_own_corners(test::random_soup(random, 600, 600));
    expect_same_by_any_threads(test::with_random_groups(apart, random, 5), {});
}

TEST(Threads, DontChangeSmoothSilhouettes) {
    expect_same_by_any_threads(test::sphere(6), {.silhouettes = Silhouettes::smooth});
}

TEST(Threads, DifferencesAreSeen) {
    const LineSet lines = lines_by(2, test::cube(), {});
    LineSet other = lines;
    other.segments.back().tag ^= 1U;
    EXPECT_EQ(difference(lines, lines), "");
    EXPECT_EQ(difference(lines, other), "segments");
}

} // namespace
} // namespace lineatlas
