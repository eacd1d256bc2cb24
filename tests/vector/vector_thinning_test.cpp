// Paths are left out where lines are dense.
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "lineatlas/vector.hpp"
#include "vector/paths.hpp"
#include "vector/thin_out.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

constexpr glm::dvec2 picture{600, 400};

Style with_limit(float limit) {
    Style style;
    style.density.limit = limit;
    style.hidden_density = 0;
    return style;
}

VectorPath line(LineKind kind, glm::dvec2 from, glm::dvec2 to, std::uint32_t segment = 0) {
    VectorPath path = path_through(kind, true, {from, to});
    path.pieces.front().segment = segment;
    return path;
}

/// Lines from top to bottom, `apart` pixels from each other, from x = 200 to 400.
std::vector<VectorPath> lattice(double apart, LineKind kind = LineKind::crease) {
    std::vector<VectorPath> paths;
    for (double x = 200; x < 400; x += apart)
        paths.push_back(line(kind, {x, 0}, {x, 400}, static_cast<std::uint32_t>(paths.size())));
    return paths;
}

double length(const std::vector<VectorPath>& paths, bool thinned) {
    double sum = 0;
    for (const VectorPath& path : paths)
        if (path.thinned == thinned) sum += length_of(path);
    return sum;
}

TEST(Thinning, LeavesWhatIsNotDense) {
    for (const double apart : {4.0, 8.0, 50.0}) {
        const std::vector<VectorPath> before = lattice(apart);
        const std::vector<VectorPath> after = thin_out(before, with_limit(0.5F), picture);
        EXPECT_EQ(after.size(), before.size());
        EXPECT_EQ(length(after, true), 0);
    }
}

TEST(Thinning, LeavesAllWithoutALimit) {
    const std::vector<VectorPath> after = thin_out(lattice(0.5), with_limit(0), picture);
    EXPECT_EQ(length(after, true), 0);
}

TEST(Thinning, DrawsAsMuchAsTheLimitAllows) {
    for (const double apart : {0.5, 1.0, 2.0}) {
        for (const float limit : {0.1F, 0.25F}) {
            const std::vector<VectorPath> before = lattice(apart);
            const std::vector<VectorPath> after = thin_out(before, with_limit(limit), picture);
            // The borders of the heap, as wide as a tent, keep slightly more.
            const double most = double{limit} * 230 * 400;
            EXPECT_GT(length(after, false), 0.7 * most) << apart << " " << limit;
            EXPECT_LT(length(after, false), 1.3 * most) << apart << " " << limit;
            EXPECT_NEAR(length(after, false) + length(after, true), length(before, false), 1e-6)
                << "nothing is lost";
        }
    }
}

TEST(Thinning, KeepsKindsOfMorePriority) {
    std::vector<VectorPath> paths = lattice(1);
    for (VectorPath& path : lattice(10, LineKind::silhouette)) paths.push_back(std::move(path));
    for (const VectorPath& path : thin_out(paths, with_limit(0.15F), picture)) {
        EXPECT_FALSE(path.kind == LineKind::silhouette && path.thinned);
    }
}

TEST(Thinning, KeepsOutlinesFirst) {
    std::vector<VectorPath> paths = lattice(1, LineKind::silhouette);
    paths[100].outline = true;
    std::size_t outlines = 0;
    for (const VectorPath& path : thin_out(paths, with_limit(0.1F), picture)) {
        if (!path.outline) continue;
        EXPECT_FALSE(path.thinned);
        ++outlines;
    }
    EXPECT_EQ(outlines, 1U);
}

TEST(Thinning, CutsALongLineWhereItIsDenseAlone) {
    std::vector<VectorPath> paths = lattice(1, LineKind::silhouette);
    paths.push_back(line(LineKind::crease, {0, 200}, {600, 200}));
    std::vector<VectorPath> across;
    for (VectorPath& path : thin_out(paths, with_limit(0.4F), picture))
        if (path.kind == LineKind::crease) across.push_back(std::move(path));
    ASSERT_EQ(across.size(), 3U);
    EXPECT_FALSE(across[0].thinned);
    EXPECT_TRUE(across[1].thinned);
    EXPECT_FALSE(across[2].thinned);
    EXPECT_NEAR(across[1].points.front().at.x, 200, 25);
    EXPECT_NEAR(across[1].points.back().at.x, 400, 25);
    EXPECT_EQ(across[0].points.back().at, across[1].points.front().at);
    EXPECT_EQ(across[1].points.back().at, across[2].points.front().at);
}

TEST(Thinning, MakesNoCrumbs) {
    std::vector<VectorPath> paths;
    for (std::uint32_t i = 0; i < 2000; ++i) { // in all directions
        const double turn = 0.37 * i;
        const glm::dvec2 middle{std::fmod(37.0 * i, 600.0), std::fmod(91.0 * i, 400.0)};
        const glm::dvec2 way{60 * std::cos(turn), 60 * std::sin(turn)};
        paths.push_back(line(LineKind::crease, middle - way, middle + way, i));
    }
    const std::vector<VectorPath> after = thin_out(paths, with_limit(0.2F), picture);
    EXPECT_GT(after.size(), paths.size());
    for (const VectorPath& path : after) EXPECT_GT(length_of(path), 11.9);
}

TEST(Thinning, TakesHiddenLinesByTheirOwnLimit) {
    std::vector<VectorPath> paths = lattice(1);
    for (VectorPath& path : paths) path.visible = false;
    EXPECT_EQ(length(thin_out(paths, with_limit(0.1F), picture), true), 0);
    Style style = with_limit(0);
    style.hidden_density = 0.1F;
    EXPECT_GT(length(thin_out(paths, style, picture), true), 0.8 * 200 * 400);
}

/// The drawing of a model that is a lattice.
VectorDrawing drawing(float limit, bool plotter = false) {
    test::Lines lines;
    for (int x = 50; x < 150; ++x) lines.add(LineKind::crease, {{x, 0, 0.5F}, {x, 100, 0.5F}});
    const Camera camera = test::flat_camera();
    test::Cuts cuts{lines.set, camera};
    cuts.add_all();
    Style style;
    style.density.limit = limit;
    return make_vector_drawing(lines.set, camera, cuts.intervals, style, {.plotter = plotter});
}

TEST(Thinning, HasLayersThatAreNotShown) {
    const VectorDrawing dense = drawing(0.2F);
    EXPECT_GT(dense.thinned_share, 0.6);
    EXPECT_LT(dense.thinned_share, 0.9);
    pugi::xml_document svg;
    ASSERT_TRUE(svg.load_string(to_svg(dense).c_str()));
    const auto group = [&](const char* id) {
        return svg.document_element().find_child_by_attribute("g", "id", id);
    };
    EXPECT_STREQ(group("crease-thinned").attribute("style").value(), "display:none");
    EXPECT_STREQ(group("crease-thinned").attribute("class").value(), "crease thinned visible");
    ASSERT_TRUE(group("crease"));
    EXPECT_FALSE(group("crease").attribute("style"));

    const std::string dxf = to_dxf(dense);
    const auto color_of = [&](const std::string& layer) {
        const std::size_t name = dxf.find("  2\n" + layer + "\n"), at = dxf.find(" 62\n", name);
        return std::stoi(dxf.substr(at + 4));
    };
    EXPECT_GT(color_of("crease"), 0);
    EXPECT_LT(color_of("crease-thinned"), 0) << "the layer is off";

    const nlohmann::json json = nlohmann::json::parse(to_json(dense));
    std::size_t thinned = 0;
    for (const nlohmann::json& path : json.at("paths")) thinned += path.value("thinned", false);
    EXPECT_EQ(thinned, std::ranges::count_if(dense.paths, &VectorPath::thinned));
}

TEST(Thinning, PlottersDoNotDrawThinnedPaths) {
    const VectorDrawing dense = drawing(0.2F, true);
    EXPECT_GT(dense.thinned_share, 0.6);
    EXPECT_TRUE(std::ranges::none_of(dense.paths, &VectorPath::thinned));
    EXPECT_EQ(drawing(0).thinned_share, 0);
}

} // namespace
} // namespace lineatlas
