// Several files in one scene: they are dropped together, added, saved as a session and read again.

#include <numeric>

#include "command_line/joined_models.hpp"
#include "lineatlas/lines.hpp"
#include "viewer_support.hpp"

namespace lineatlas::test {
namespace {

class ViewerFiles : public Viewer {
  protected:
    ViewerFiles() {
        std::ofstream{path("left.obj")} << box("Base", {-2, 0, 0}, 1) + box("Lid", {-2, 3, 0}, 9);
        std::ofstream{path("right.obj")} << box("Bolt", {2, 0, 0}, 1);
    }
    void drop(const std::vector<std::string>& names) {
        std::vector<std::filesystem::path> files;
        for (const std::string& name : names) files.emplace_back(path(name));
        app_.input().on_drop(files);
        hand_.rest();
    }
    std::vector<std::string> parts() {
        std::vector<std::string> paths;
        const viewer::Parts& all = session().model()->parts;
        for (std::uint32_t part = 0; part < all.all().size(); ++part)
            paths.push_back(all.path_of(part));
        return paths;
    }
    std::size_t triangles() { return session().model()->mesh->triangles.size(); }
};

TEST_F(ViewerFiles, DroppedTogetherStandSideBySide) {
    drop({"left.obj", "right.obj"});
    EXPECT_EQ(error(), "");
    EXPECT_EQ(session().model()->source.name(), "left.obj + 1");
    EXPECT_EQ(parts(), (std::vector<std::string>{"left.obj", "left.obj/Base", "left.obj/Lid",
                                                 "right.obj", "right.obj/Bolt"}));
    EXPECT_EQ(session().whole_bounds().min, glm::vec3(-3, -1, -1)) << "where their files say";
    EXPECT_EQ(session().whole_bounds().max, glm::vec3(3, 4, 1));
    EXPECT_TRUE(hand_.has("part:right.obj"));
    hand_.screenshot("files");
    hand_.click("show:left.obj");
    EXPECT_EQ(triangles(), 12U) << "a file is hidden as a part";
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_EQ(triangles(), 36U);
}

TEST_F(ViewerFiles, AreAddedAndWhatIsHiddenStaysSo) {
    drop({"left.obj"});
    hand_.click("show:Lid");
    ASSERT_EQ(triangles(), 12U);
    hand_.click("adds");
    drop({"right.obj"});
    EXPECT_EQ(error(), "");
    EXPECT_EQ(triangles(), 24U);
    EXPECT_EQ(session().model()->shown.parts.hidden.size(), 1U);
    const glm::dvec2 size = session().size();
    const auto seen = viewer::seen_at(session().navigation.view(), {3, 1, 1}, session().size());
    ASSERT_TRUE(seen);
    EXPECT_LT(seen->x, size.x) << "what has come is in sight";
    drop({"right.obj"});
    EXPECT_EQ(parts().back(), "right.obj (2)/Bolt") << "a file may come twice";
    hand_.click("adds");
    drop({"right.obj"});
    EXPECT_EQ(session().model()->source.files.size(), 1U) << "it stands alone again";
}

/// In the file's coordinates, as in the tool.
TEST_F(ViewerFiles, AFocusFarFromZeroIsWhereItIsNearIt) {
    constexpr float away = 1e6F;
    std::ofstream{path("near.obj")} << box("Box", {0, 0, 0}, 1);
    std::ofstream{path("far.obj")} << box("Box", {away, away, away}, 1);
    const auto drawn = [&](const std::string& name, glm::dvec3 focus) {
        drop({name});
        session().settings.style.focus = {.on = true,
                                          .in_scene = true,
                                          .point = focus,
                                          .radius = 0.1F,
                                          .falloff = 0.1F,
                                          .width = 4,
                                          .opacity = 1};
        session().changed();
        hand_.rest();
        return picture();
    };
    const glm::dvec3 corner{1, 1, 1};
    const auto near = drawn("near.obj", corner);
    EXPECT_NE(drawn("near.obj", -corner), near) << "it is seen";
    EXPECT_EQ(drawn("far.obj", corner + double{away}), near);
    EXPECT_GT(glm::length(session().origin()), away) << "it has an origin of its own";
    hand_.screenshot("focus");
    hand_.save(viewer::SavedKind::png);
    hand_.save(viewer::SavedKind::style);
    hand_.save(viewer::SavedKind::camera);
    const std::string command = std::string{LINEATLAS_TOOL} + " draw " + path("far.obj") +
                                " --method atlas --size 968x760 --style " + path("far.toml") +
                                " --camera-path " + path("far.json") + " -o " + path("tool.%d.png");
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    EXPECT_EQ(read_image(path("far.png")).pixels, read_image(path("tool.0.png")).pixels);
}

TEST_F(ViewerFiles, ASessionOfThemIsDrawnByTheToolAndReadAgain) {
    drop({"left.obj", "right.obj"});
    hand_.click("show:Base");
    hand_.key(GLFW_KEY_S, GLFW_MOD_CONTROL);
    ASSERT_EQ(error(), "");
    EXPECT_NE(text_of(path("left.session.toml")).find("[\"left.obj\", \"right.obj\"]"),
              std::string::npos);
    hand_.save(viewer::SavedKind::svg);
    const std::string command = std::string{LINEATLAS_TOOL} + " draw " + path("left.session.toml") +
                                " -o " + path("tool.svg");
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const auto paths = [](const std::string& svg) { return svg.substr(svg.find("<path")); };
    EXPECT_EQ(paths(text_of(path("tool.svg"))), paths(text_of(path("left.svg"))));
    hand_.open_scene("clevis");
    hand_.drop(path("left.session.toml"));
    EXPECT_EQ(triangles(), 24U);
    std::ofstream{path("right.obj")} << box("Bolt", {2, 0, 0}, 1) + box("Nut", {2, 3, 0}, 9);
    hand_.key(GLFW_KEY_R, GLFW_MOD_CONTROL);
    EXPECT_EQ(triangles(), 36U);
    EXPECT_EQ(session().model()->shown.parts.hidden.size(), 1U);
}

TEST_F(ViewerFiles, StandUprightSideBySide) {
    // A post of height 6 along z, which is upwards in STL, beside a box in OBJ, where y is upwards.
    std::ofstream{path("post.stl")} << "solid post\n"
                                       "facet normal 0 0 0\nouter loop\nvertex 4 0 0\n"
                                       "vertex 5 0 0\nvertex 4 0 6\nendloop\nendfacet\n"
                                       "facet normal 0 0 0\nouter loop\nvertex 4 0 0\n"
                                       "vertex 4 1 0\nvertex 4 0 6\nendloop\nendfacet\n"
                                       "endsolid post\n";
    drop({"left.obj", "post.stl"});
    EXPECT_EQ(error(), "");
    EXPECT_EQ(session().model()->source.up, glm::vec3(0, 1, 0));
    EXPECT_EQ(session().whole_bounds().max, glm::vec3(5, 6, 1)) << "its z is up";
    hand_.screenshot("upright");
}

TEST_F(ViewerFiles, OneThatIsBrokenIsNamedAndNoneIsTaken) {
    std::ofstream{path("broken.stl")} << "solid";
    drop({"left.obj", "broken.stl"});
    EXPECT_NE(error().find("broken.stl"), std::string::npos) << error();
    EXPECT_EQ(session().model()->source.name(), "clevis");
}

/// A square of two triangles that is bent by 60 degrees along its diagonal. knows_edges: the file
/// tells the kind of the diagonal.
LoadedMesh folded(bool knows_edges) {
    LoadedMesh loaded;
    loaded.mesh = {.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}},
                   .triangles = {{0, 1, 2}, {0, 2, 3}},
                   .triangle_group = {},
                   .groups = {},
                   .polylines = {}};
    if (knows_edges) {
        loaded.mesh.known_edges = {{0, 1, KnownEdge::Kind::free},
                                   {1, 2, KnownEdge::Kind::free},
                                   {2, 3, KnownEdge::Kind::free},
                                   {3, 0, KnownEdge::Kind::free}};
    }
    return loaded;
}

TEST(JoinedModels, AreWhereTheirOwnOriginsAndUnitsPlaceThem) {
    LoadedMesh first = folded(false), second = folded(false);
    first.origin = {1000, 0, 0};
    first.unit = 1;
    second.unit = 1000;
    second.notes = {"odd"};
    const LoadedMesh joined = join_models({{"a", first}, {"b", second}});
    EXPECT_EQ(joined.origin, first.origin);
    EXPECT_EQ(joined.mesh.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(joined.mesh.positions[5], glm::vec3(0, 0, 0)) << "a metre from zero";
    ASSERT_EQ(joined.notes.size(), 2U);
    EXPECT_EQ(joined.notes[0], "b: odd");
    EXPECT_NE(joined.notes[1].find("1000"), std::string::npos) << joined.notes[1];
    EXPECT_EQ(joined.mesh.triangles[2], glm::uvec3(4, 5, 6));
}

TEST(JoinedModels, StandUpright) {
    LoadedMesh first = folded(false), second = folded(true);
    first.up = {0, 1, 0};
    second.up = {0, 0, 1};
    second.origin = {0, 0, 5};
    second.mesh.edge_curves.resize(4);
    second.mesh.edge_curves[1] = EdgeCurve{.center = {1, 2, 3}, .u = {0, 0, 1}, .v = {0, 1, 0}};
    const LoadedMesh joined = join_models({{"a", first}, {"b", second}});
    EXPECT_EQ(joined.up, glm::vec3(0, 1, 0));
    EXPECT_EQ(joined.mesh.positions[2], glm::vec3(1, 1, 1)) << "the first stays";
    EXPECT_EQ(joined.mesh.positions[6], glm::vec3(1, 6, -1)) << "up is up, the front is in front";
    const auto curve =
        std::ranges::find_if(joined.mesh.edge_curves, [](const auto& c) { return c.has_value(); });
    ASSERT_NE(curve, joined.mesh.edge_curves.end());
    EXPECT_EQ((*curve)->center, glm::dvec3(1, 8, -2));
    EXPECT_EQ((*curve)->u, glm::dvec3(0, 1, 0));
    ASSERT_EQ(joined.notes.size(), 1U);
    EXPECT_NE(joined.notes[0].find("upright"), std::string::npos);
}

TEST(JoinedModels, KeepTheLinesThatEachHasAlone) {
    const auto lines = [](const Mesh& mesh) { return extract_lines(mesh).kind_counts; };
    const auto known = lines(folded(true).mesh), by_angle = lines(folded(false).mesh);
    ASSERT_EQ(known[LA_KIND_CREASE], 0U);
    ASSERT_EQ(by_angle[LA_KIND_CREASE], 1U);
    LoadedMesh apart = folded(false);
    for (glm::vec3& p : apart.mesh.positions) p.x += 5;
    const auto both = lines(join_models({{"a", folded(true)}, {"b", apart}}).mesh);
    EXPECT_EQ(both[LA_KIND_CREASE], 1U);
    EXPECT_EQ(both[LA_KIND_BOUNDARY], known[LA_KIND_BOUNDARY] + by_angle[LA_KIND_BOUNDARY]);
}

} // namespace
} // namespace lineatlas::test
