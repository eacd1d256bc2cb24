// Sections, sessions, pens of kinds, rest and commands of the viewer, by real events.

#include <cmath>
#include <cstdlib>

#include "planted_error.hpp"
#include "viewer/kind_pens.hpp"
#include "viewer_support.hpp"

namespace lineatlas::test {
namespace {

/// Two boxes side by side in the view from the front: "Base" on the left, "Bolt M8" on the right.
class ViewerSession : public Viewer {
  protected:
    ViewerSession() {
        std::ofstream{path("m.obj")} << box("Base", {-2, 0, 0}, 1) + box("Bolt M8", {2, 0, 0}, 9);
        hand_.drop(path("m.obj"));
        hand_.key(GLFW_KEY_1);
        EXPECT_EQ(error(), "");
    }
    const std::vector<viewer::Cut>& cuts() { return session().settings.shown.cuts; }
    std::size_t hatches() {
        return session().model()->lines.kind_counts.at(
            static_cast<std::size_t>(LineKind::hatching));
    }
    static std::string paths_of(const std::string& svg) {
        return svg.substr(std::min(svg.size(), svg.find("<path")));
    }
};

/// Kernels in a folder of one's own, as they are in the sources.
struct OwnKernels {
    PlantedError kernels{"pyramid.cl", "KERNEL(", "KERNEL("};
};
class ViewerOfOwnKernels : private OwnKernels, public Viewer {};

TEST_F(ViewerOfOwnKernels, KernelsAreBuiltAgainWhenTheyAreWritten) {
    const std::filesystem::path file =
        std::filesystem::path{std::getenv("LINEATLAS_KERNEL_DIR")} / "project_clip.cl";
    const std::string text = text_of(file);
    session().use_device({.compute = "opencl"});
    hand_.rest();
    const auto before = picture();
    const auto look = [&] {
        for (int looks = 0; looks < 2; ++looks) session().look_at_kernels();
        hand_.rest();
    };
    std::ofstream{file} << "no C\n" << text;
    look();
    EXPECT_NE(error().find("project_clip"), std::string::npos) << error();
    std::ofstream{file} << text;
    look();
    session().messages.dismiss(0);
    EXPECT_EQ(error(), "");
    EXPECT_EQ(picture(), before);
}

TEST_F(ViewerSession, SectionsAreAddedMovedFlippedAndUndone) {
    const auto whole = picture();
    const View before = session().navigation.view();
    hand_.key(GLFW_KEY_C);
    ASSERT_EQ(cuts().size(), 1U);
    EXPECT_EQ(viewer::text_of(cuts()[0]), "+z=0") << "what lies towards the eye is gone";
    EXPECT_GT(hatches(), 0U);
    EXPECT_EQ(session().model()->lines.bounds.max.z, 0);
    EXPECT_EQ(session().navigation.view().eye, before.eye);
    EXPECT_NE(picture(), whole);
    hand_.click("section.0.flip");
    EXPECT_EQ(session().model()->lines.bounds.min.z, 0);
    hand_.click("section.0.X");
    EXPECT_EQ(viewer::text_of(cuts()[0]), "-x=0");
    hand_.key(GLFW_KEY_RIGHT_BRACKET);
    EXPECT_EQ(viewer::text_of(cuts()[0]).substr(0, 4), "-x=-") << "along the normal";
    hand_.click("section.0.on");
    EXPECT_EQ(hatches(), 0U);
    EXPECT_EQ(picture(), whole);
    for (int step = 0; step < 5; ++step) hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_TRUE(cuts().empty());
    EXPECT_EQ(picture(), whole);
    hand_.key(GLFW_KEY_Y, GLFW_MOD_CONTROL);
    EXPECT_GT(hatches(), 0U);
    hand_.click("section.0.remove");
    EXPECT_EQ(picture(), whole);
}

TEST_F(ViewerSession, AHandleIsDraggedAlongTheNormal) {
    hand_.key(GLFW_KEY_C);
    hand_.click("section.0.X");
    ASSERT_EQ(viewer::text_of(cuts()[0]), "+x=0");
    const View before = session().navigation.view();
    const glm::dvec2 from = hand_.middle_of("section.0.handle");
    const double pixels_per_unit = viewer::seen_at(before, {1, 0, 0}, session().size())->x -
                                   viewer::seen_at(before, {0, 0, 0}, session().size())->x;
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, from, from + glm::dvec2{2 * pixels_per_unit, 40});
    EXPECT_NEAR(cuts()[0].at, 2, 0.05) << "as far as the mouse, whatever it does aside";
    EXPECT_NEAR(session().model()->lines.bounds.max.x, 2, 0.05);
    EXPECT_EQ(session().navigation.view().eye, before.eye) << "the camera stays";
    hand_.screenshot("section");
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_EQ(cuts()[0].at, 0) << "one drag is one step";
}

TEST_F(ViewerSession, NoMoreThanSixSectionsAndNoneThatTakesAll) {
    for (int i = 0; i < 8; ++i) hand_.key(GLFW_KEY_C);
    EXPECT_EQ(cuts().size(), most_sections);
    EXPECT_FALSE(session().model()->lines.triangles.empty());
    hand_.key(GLFW_KEY_P, GLFW_MOD_CONTROL);
    hand_.panel_frames(3);
    hand_.type("remove sections");
    hand_.press(GLFW_KEY_ENTER);
    hand_.panel_frames(2);
    hand_.release(GLFW_KEY_ENTER);
    hand_.rest();
    EXPECT_TRUE(cuts().empty());
    EXPECT_EQ(error(), "");
}

TEST_F(ViewerSession, ClicksPassThroughWhatIsCutAway) {
    hand_.key(GLFW_KEY_C);
    hand_.click("section.0.X"); // the parts right of the middle are gone
    const glm::dvec2 right = hand_.at_shares({0.65, 0.5});
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, right, right);
    EXPECT_TRUE(session().selected.empty());
}

TEST_F(ViewerSession, SessionsAreSavedOpenedAndDrawnByTheTool) {
    hand_.click("show:Bolt M8");
    hand_.key(GLFW_KEY_C);
    hand_.choose("style", "technical");
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, {100, 100}, {220, 150});
    hand_.key(GLFW_KEY_B);
    session().settings.exact_at_rest = true;
    hand_.key(GLFW_KEY_S, GLFW_MOD_CONTROL);
    hand_.save(viewer::SavedKind::svg);
    ASSERT_EQ(error(), "");
    const View saved = session().navigation.view();
    const viewer::Shown shown = session().settings.shown;
    const auto drawn = picture();

    const std::string command =
        std::string{LINEATLAS_TOOL} + " draw " + path("m.session.toml") + " -o " + path("tool.svg");
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    EXPECT_EQ(paths_of(text_of(path("tool.svg"))), paths_of(text_of(path("m.svg"))));

    hand_.open_scene("clevis");
    hand_.choose("style", "charcoal");
    EXPECT_TRUE(cuts().empty());
    hand_.drop(path("m.session.toml"));
    EXPECT_EQ(error(), "");
    EXPECT_EQ(session().settings.shown, shown);
    EXPECT_EQ(session().model()->shown, shown);
    EXPECT_EQ(session().navigation.view().eye, saved.eye);
    EXPECT_EQ(session().settings.style_name, "technical");
    EXPECT_EQ(session().settings.bookmarks.size(), 1U);
    EXPECT_EQ(picture(), drawn);
    hand_.key(GLFW_KEY_F);
    hand_.click("view:View 1");
    EXPECT_LT(glm::distance(session().navigation.view().eye, saved.eye), 1e-4F);
}

TEST_F(ViewerSession, ABadSessionIsToldAndNothingElse) {
    const auto drawn = picture();
    const auto refused = [&](const std::string& text, const char* words) {
        std::ofstream{path("bad.toml")} << text;
        hand_.drop(path("bad.toml"));
        EXPECT_NE(error().find(words), std::string::npos) << error();
        EXPECT_NE(error().find("bad.toml"), std::string::npos) << error();
        EXPECT_EQ(picture(), drawn);
        hand_.key(GLFW_KEY_ESCAPE);
    };
    refused("session = 2\nmodel = \"m.obj\"\n", "version 1");
    refused("session = 1\n", "\"model\" or a \"scene\"");
    refused("session = 1\nmodel = \"m.obj\"\nsection = \"q=3\"\n", "line 3");
    refused("session = 1\nmodel = \"m.obj\"\noutput = \"/tmp/x\"\n", "no such key");
    refused("session = 1\nmodel = \"m.obj\"\n[style]\nwidht = 3\n", "width");
    std::ofstream{path("lost.toml")} << "session = 1\nmodel = \"lost.obj\"\n";
    hand_.drop(path("lost.toml"));
    EXPECT_NE(error().find("lost.obj"), std::string::npos) << error();
    EXPECT_EQ(session().model()->source.name(), "m.obj");
}

TEST_F(ViewerSession, KindsHaveWidthAndColour) {
    const auto plain = picture();
    const Style before = session().settings.style;
    hand_.reveal("lines.crease.width");
    const glm::dvec2 place = hand_.middle_of("lines.crease.width");
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, place, place + glm::dvec2{20, 0});
    const Style& style = session().settings.style;
    EXPECT_GT(viewer::pen_of_kind(style, "crease").width, 4);
    EXPECT_EQ(viewer::pen_of_kind(style, "boundary").width,
              viewer::pen_of_kind(before, "boundary").width);
    EXPECT_EQ(viewer::pen_of_kind(style, "outline").width,
              viewer::pen_of_kind(before, "outline").width);
    EXPECT_EQ(style.pens.size(), before.pens.size() + 1) << "however far it is dragged";
    EXPECT_NE(picture(), plain);
    hand_.screenshot("kinds");
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_EQ(picture(), plain);
}

TEST(ViewerKindPens, AreRulesOfTheirKindThatTheOutlineOutweighs) {
    Style style = load_style("plain");
    viewer::set_width_of_kind(style, "silhouette", 7);
    viewer::set_color_of_kind(style, "silhouette", {1, 0, 0});
    ASSERT_EQ(style.pens.size(), 6U);
    EXPECT_EQ(viewer::pen_of_kind(style, "silhouette").width, 7);
    EXPECT_EQ(viewer::pen_of_kind(style, "silhouette").color, glm::vec3(1, 0, 0));
    EXPECT_EQ(viewer::pen_of_kind(style, "crease").width, 1.5F);
    EXPECT_EQ(style.pens.back().match.kinds, (std::vector<std::string>{"outline", "section"}));
    viewer::set_width_of_kind(style, "section", 2);
    EXPECT_EQ(viewer::pen_of_kind(style, "section").width, 2);
    EXPECT_EQ(viewer::pen_of_kind(style, "outline").width, 3);
}

TEST_F(ViewerSession, CreasesFollowTheirAngle) {
    const auto creases = [&] {
        return session().model()->lines.kind_counts.at(static_cast<std::size_t>(LineKind::crease));
    };
    const auto before = creases();
    ASSERT_GT(before, 0U);
    hand_.reveal("crease");
    const glm::dvec2 place = hand_.middle_of("crease");
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, place, place + glm::dvec2{75, 0});
    EXPECT_GT(*session().settings.shown.crease, 90);
    EXPECT_EQ(creases(), 0U) << "edges of a cube bend by less";
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_EQ(creases(), before);
}

/// An upright tube of 16 sides that bends by 22.5 degrees at each edge, as the mesh of a smooth
/// surface.
Mesh tube(bool with_normals) {
    constexpr std::uint32_t sides = 16;
    Mesh mesh;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const float angle = 6.2831853F * static_cast<float>(i) / sides;
        for (const float y : {-1.0F, 1.0F})
            mesh.positions.emplace_back(std::cos(angle), y, std::sin(angle));
        const std::uint32_t low = 2 * i, next = 2 * ((i + 1) % sides);
        mesh.triangles.emplace_back(low, low + 1, next);
        mesh.triangles.emplace_back(next, low + 1, next + 1);
    }
    if (!with_normals) return mesh;
    for (const glm::uvec3& corners : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 place = mesh.positions[corners[k]];
            mesh.corner_normals.push_back(glm::normalize(glm::vec3{place.x, 0, place.z}));
        }
    }
    return mesh;
}

/// A reader that gives the tube for every file.
viewer::Loader::Reader reader_of_tube(bool with_normals) {
    return [with_normals](const viewer::ModelSource& source) {
        auto model = std::make_shared<viewer::Model>();
        model->source = source;
        model->source.up = glm::vec3{0, 1, 0};
        model->mesh = model->whole = std::make_shared<const Mesh>(tube(with_normals));
        return model;
    };
}

TEST_F(ViewerSession, SilhouettesFollowTheMeshOrTheSurface) {
    const auto smooth = [&] { return !session().model()->lines.contours.empty(); };
    session().loader.set_reader(reader_of_tube(false));
    hand_.key(GLFW_KEY_R, GLFW_MOD_CONTROL);
    EXPECT_FALSE(smooth());
    hand_.click("silhouettes.smooth");
    EXPECT_TRUE(smooth());
    hand_.screenshot("silhouettes");
    hand_.key(GLFW_KEY_S, GLFW_MOD_CONTROL);
    EXPECT_NE(text_of(path("m.session.toml")).find("silhouettes = \"smooth\""), std::string::npos);
    hand_.save(viewer::SavedKind::svg);
    EXPECT_NE(text_of(path("m.svg")).find("--silhouettes smooth"), std::string::npos);
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_FALSE(smooth());
    hand_.drop(path("m.session.toml"));
    EXPECT_TRUE(smooth());
    EXPECT_EQ(error(), "");
    hand_.click("silhouettes.mesh");
    EXPECT_FALSE(smooth());
    hand_.click("silhouettes.auto");
    EXPECT_FALSE(session().settings.shown.silhouettes) << "what is usual needs no word";
}

TEST_F(ViewerSession, SurfacesWithNormalsHaveSmoothSilhouettesAsTheToolDrawsThem) {
    session().loader.set_reader(reader_of_tube(true));
    hand_.key(GLFW_KEY_R, GLFW_MOD_CONTROL);
    EXPECT_FALSE(session().model()->lines.contours.empty());
    hand_.click("silhouettes.mesh");
    EXPECT_TRUE(session().model()->lines.contours.empty());
    EXPECT_EQ(session().settings.shown.silhouettes, Silhouettes::mesh);
    hand_.click("silhouettes.auto");
    EXPECT_FALSE(session().model()->lines.contours.empty());
    EXPECT_FALSE(session().settings.shown.silhouettes);
}

TEST_F(ViewerSession, ThePictureIsExactAtRestAlone) {
    hand_.open_scene("house");
    hand_.choose("method", "Exact");
    const auto exact = picture();
    hand_.choose("method", "Quick");
    const auto sampled = picture();
    ASSERT_NE(sampled, exact);
    hand_.click("exact-at-rest");
    EXPECT_TRUE(session().refined());
    EXPECT_EQ(picture(), exact);
    const std::uint64_t drawn = session().frames_drawn();
    for (int i = 0; i < 20; ++i) app_.step(0);
    EXPECT_EQ(session().frames_drawn(), drawn) << "nothing runs at rest";
    session().navigation.orbit({0, 0, 0}, {0.02, 0});
    hand_.panel_frames(1);
    EXPECT_FALSE(session().refined()) << "while it moves";
    session().navigation.orbit({0, 0, 0}, {-0.02, 0});
    hand_.rest();
    EXPECT_TRUE(session().refined());
    hand_.click("split");
    EXPECT_EQ(picture(), sampled) << "two methods side by side are those that are named";
}

TEST_F(ViewerSession, ThePictureIsSaidToBecomeExactUntilItIs) {
    hand_.open_scene("house");
    session().settings.exact_at_rest = true;
    session().changed();
    hand_.rest();
    EXPECT_TRUE(session().refined());
    EXPECT_TRUE(hand_.has("status:Exact"));
    for (const auto& [spot, area] : app_.ui().spots.all())
        EXPECT_EQ(spot.find("becoming"), std::string::npos) << spot;
}

TEST_F(ViewerSession, DistancesAreMeasuredFromCornerToCorner) {
    const auto click = [&](glm::dvec3 corner) {
        // A place a few pixels within the face.
        const glm::dvec2 at = hand_.in_window(
            *viewer::seen_at(session().navigation.view(), 0.99 * corner, session().size()));
        hand_.drag(GLFW_MOUSE_BUTTON_LEFT, at, at);
    };
    hand_.key(GLFW_KEY_R);
    click({-3, 1, 1});
    EXPECT_TRUE(session().measured_from());
    EXPECT_TRUE(session().selected.empty()) << "no part is selected meanwhile";
    click({3, -1, 1});
    const auto& distances = session().settings.distances;
    ASSERT_EQ(distances.size(), 1U);
    EXPECT_EQ(distances[0][0], glm::dvec3(-3, 1, 1)) << "the corner itself";
    EXPECT_EQ(distances[0][1], glm::dvec3(3, -1, 1));
    EXPECT_EQ(session().length_text(std::sqrt(40)), "6.3246") << "this file says no unit";
    hand_.screenshot("measured");
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_TRUE(session().settings.distances.empty());
    hand_.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(session().measuring());
}

TEST_F(ViewerSession, ATurnIsRecordedAsPictures) {
    app_.ui().record_frames = 3;
    hand_.click("record.turntable");
    EXPECT_EQ(error(), "");
    EXPECT_FALSE(session().recording());
    std::vector<std::vector<std::uint8_t>> pictures;
    for (int i = 0; i < 3; ++i) {
        const Image image = read_image(path("m-pictures/000" + std::to_string(i) + ".png"));
        EXPECT_EQ(image.size, session().size());
        for (const auto& before : pictures) EXPECT_NE(image.pixels, before) << i;
        pictures.push_back(image.pixels);
    }
    EXPECT_FALSE(std::filesystem::exists(path("m-pictures/0003.png")));
    hand_.click("record.views");
    EXPECT_FALSE(std::filesystem::exists(path("m-pictures-2"))) << "there is no way yet";
    hand_.key(GLFW_KEY_B);
    hand_.key(GLFW_KEY_2);
    hand_.key(GLFW_KEY_B);
    hand_.click("record.views");
    EXPECT_NE(read_image(path("m-pictures-2/0000.png")).pixels,
              read_image(path("m-pictures-2/0003.png")).pixels)
        << "from the first kept view to the last";
    EXPECT_EQ(error(), "");
}

TEST_F(ViewerSession, ATurnIsAVideoWhereThereIsFfmpeg) {
    if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "needs ffmpeg";
    app_.ui().record_frames = 3;
    hand_.click("record.turntable");
    EXPECT_EQ(error(), "");
    EXPECT_GT(std::filesystem::file_size(path("m-pictures.mp4")), 1000U);
}

TEST_F(ViewerSession, CommandsAreFoundByTyping) {
    hand_.key(GLFW_KEY_P, GLFW_MOD_CONTROL);
    hand_.panel_frames(3);
    hand_.type("screen spl");
    EXPECT_TRUE(hand_.has("command:Split screen"));
    EXPECT_FALSE(hand_.has("command:Quit"));
    hand_.screenshot("palette");
    hand_.press(GLFW_KEY_ENTER);
    hand_.panel_frames(2);
    hand_.release(GLFW_KEY_ENTER);
    hand_.rest();
    EXPECT_TRUE(session().settings.split);
    EXPECT_FALSE(hand_.has("palette.search"));
    hand_.key(GLFW_KEY_P, GLFW_MOD_CONTROL);
    EXPECT_TRUE(hand_.has("palette.search"));
    hand_.key(GLFW_KEY_ESCAPE);
    hand_.rest();
    EXPECT_FALSE(hand_.has("palette.search"));
}

/// A picture in docs/viewer.md.
TEST_F(ViewerSession, IsWhatTheDocsShow) {
    hand_.open_scene("house");
    hand_.key(GLFW_KEY_C);
    hand_.click("section.0.Z");
    app_.ui().folder = ".";
    hand_.move({300, 300});
    hand_.screenshot("viewer_section");
    EXPECT_EQ(error(), "");
}

} // namespace
} // namespace lineatlas::test
