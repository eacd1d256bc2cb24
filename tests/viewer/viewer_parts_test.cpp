// Parts are hidden, found and framed in the viewer, and these actions are undone.

#include <chrono>

#include "viewer/kind_pens.hpp"
#include "viewer_support.hpp"

namespace lineatlas::test {
namespace {

/// Two boxes side by side in the view from the front: "Base" on the left, "Bolt M8" on the right.
class ViewerParts : public Viewer {
  protected:
    ViewerParts() {
        write(box("Base", {-2, 0, 0}, 1) + box("Bolt M8", {2, 0, 0}, 9));
        hand_.drop(path("m.obj"));
        hand_.key(GLFW_KEY_1);
        EXPECT_EQ(error(), "");
    }
    void write(const std::string& model) const { std::ofstream{path("m.obj")} << model; }
    std::size_t lines() { return session().model()->lines.segments.size(); }
    void click_at(double share_of_width, const char* why) {
        SCOPED_TRACE(why);
        const glm::dvec2 place = hand_.at_shares({share_of_width, 0.5});
        hand_.drag(GLFW_MOUSE_BUTTON_LEFT, place, place);
    }
    std::string selected() {
        std::string names;
        for (const std::uint32_t part : session().selected)
            names += (names.empty() ? "" : ", ") + session().model()->parts.path_of(part);
        return names;
    }
};

TEST_F(ViewerParts, AreHiddenAndTheCameraStays) {
    const std::size_t all = lines();
    const View before = session().navigation.view();
    const auto picture_of_all = picture();
    hand_.click("show:Bolt M8");
    EXPECT_EQ(lines(), all / 2);
    EXPECT_EQ(session().navigation.view().eye, before.eye);
    EXPECT_NE(picture(), picture_of_all);
    hand_.screenshot("parts");
    hand_.click("show:Base");
    EXPECT_EQ(lines(), all / 2) << "nothing would be left";
    hand_.click("parts.all");
    EXPECT_EQ(lines(), all);
    EXPECT_EQ(picture(), picture_of_all);
}

TEST_F(ViewerParts, HaveAPenOfTheirOwn) {
    const auto plain = picture();
    const Style before = session().settings.style;
    click_at(0.65, "right");
    hand_.reveal("part.width");
    const glm::dvec2 place = hand_.middle_of("part.width");
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, place, place + glm::dvec2{20, 0});
    const Style& style = session().settings.style;
    ASSERT_EQ(style.pens.size(), before.pens.size() + 1) << "however far it is dragged";
    EXPECT_EQ(style.pens.back().match.object, "Bolt M8");
    EXPECT_GT(*style.pens.back().width, 5);
    EXPECT_EQ(viewer::pen_of_object(style, "Base").width,
              viewer::pen_of_object(before, "Base").width);
    EXPECT_NE(picture(), plain);
    app_.ui().folder = "drawings"; // docs/viewer.md shows this
    hand_.move({300, 650});
    hand_.screenshot("part_pen");
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_EQ(picture(), plain);
}

TEST_F(ViewerParts, AreSelectedByAClickAndNotByADrag) {
    click_at(0.35, "left");
    EXPECT_EQ(selected(), "Base");
    click_at(0.65, "right");
    EXPECT_EQ(selected(), "Bolt M8");
    hand_.screenshot("part_selected");
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, {300, 400}, {400, 420});
    EXPECT_EQ(selected(), "Bolt M8");
    hand_.key(GLFW_KEY_1);
    hand_.key(GLFW_KEY_I);
    EXPECT_EQ(session().settings.shown.parts.only.size(), 1U);
    click_at(0.35, "where nothing is any more");
    EXPECT_EQ(selected(), "");
    hand_.key(GLFW_KEY_U);
    click_at(0.65, "right");
    hand_.key(GLFW_KEY_DELETE);
    click_at(0.65, "hidden");
    EXPECT_EQ(selected(), "");
}

/// An arm that has a mesh and contains a hand; each has four triangles.
std::string arm_with_hand() {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"name": "Arm", "mesh": 0, "children": [1]},
          {"name": "Hand", "mesh": 0, "translation": [3, 0, 0]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
               "min": [0, 0, 0], "max": [1, 1, 1]},
              {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
"buffers": [{"byteLength": 72, "uri": "data:application/octet-stream;base64,)"
           "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
           "AAACAAEAAAABAAMAAAADAAIA"
           "AQACAAMA\"}]}";
}

TEST_F(ViewerParts, AreShownAloneWithoutWhatTheyAreIn) {
    std::ofstream{path("arm.gltf")} << arm_with_hand();
    hand_.drop(path("arm.gltf"));
    ASSERT_EQ(error(), "");
    ASSERT_EQ(session().model()->mesh->triangles.size(), 8U);
    hand_.click("part:Hand");
    hand_.key(GLFW_KEY_I);
    EXPECT_EQ(session().model()->mesh->triangles.size(), 4U) << "the arm is hidden, too";
    EXPECT_EQ(session().model()->lines.bounds.min.x, 3);
    hand_.save(viewer::SavedKind::svg);
    hand_.save(viewer::SavedKind::camera);
    const std::string saved = text_of(path("arm.svg"));
    EXPECT_NE(saved.find("--only Arm/Hand"), std::string::npos);
    const std::string command = std::string{LINEATLAS_TOOL} + " draw " + path("arm.gltf") +
                                " --only Arm/Hand --size 968x760 --camera-path " +
                                path("arm.json") + " -o " + path("tool.%d.svg");
    ASSERT_EQ(std::system(command.c_str()), 0);
    const auto paths = [](const std::string& svg) { return svg.substr(svg.find("<path")); };
    EXPECT_EQ(paths(saved), paths(text_of(path("tool.0.svg"))));

    hand_.key(GLFW_KEY_S, GLFW_MOD_CONTROL);
    hand_.key(GLFW_KEY_U);
    EXPECT_EQ(session().model()->mesh->triangles.size(), 8U);
    hand_.drop(path("arm.session.toml"));
    EXPECT_EQ(error(), "");
    EXPECT_EQ(session().model()->mesh->triangles.size(), 4U) << "sessions keep it";
    hand_.click("show:Arm");
    EXPECT_EQ(session().model()->mesh->triangles.size(), 8U) << "it comes to what is shown";
}

TEST_F(ViewerParts, SeveralAreSelected) {
    click_at(0.35, "left");
    const glm::dvec2 right = hand_.at_shares({0.65, 0.5});
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, right, right, GLFW_MOD_CONTROL);
    EXPECT_EQ(selected(), "Base, Bolt M8");
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, right, right, GLFW_MOD_SHIFT);
    EXPECT_EQ(selected(), "Base") << "once more is one less";
    write(box("A", {0, 0, 0}, 1) + box("B", {3, 0, 0}, 9) + box("C", {6, 0, 0}, 17) +
          box("D", {9, 0, 0}, 25));
    hand_.drop(path("m.obj"));
    hand_.click("part:B");
    hand_.press(GLFW_KEY_LEFT_SHIFT, GLFW_MOD_SHIFT);
    hand_.click("part:D");
    hand_.release(GLFW_KEY_LEFT_SHIFT);
    EXPECT_EQ(selected(), "B, C, D");
    hand_.screenshot("several_selected");
    hand_.key(GLFW_KEY_DELETE);
    EXPECT_EQ(session().model()->mesh->triangles.size(), 12U);
}

TEST_F(ViewerParts, HaveAMenu) {
    const glm::dvec2 left = hand_.at_shares({0.35, 0.5});
    hand_.drag(GLFW_MOUSE_BUTTON_RIGHT, left, left);
    EXPECT_EQ(selected(), "Base");
    hand_.screenshot("menu");
    hand_.click("menu:Hide");
    EXPECT_EQ(session().settings.shown.parts.hidden.size(), 1U);
    EXPECT_FALSE(hand_.has("menu:Hide")) << "it is gone";
    hand_.drag(GLFW_MOUSE_BUTTON_RIGHT, left, left);
    EXPECT_FALSE(hand_.has("menu:Hide")) << "there is nothing";
    hand_.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(hand_.has("menu:Show all"));
    hand_.drag(GLFW_MOUSE_BUTTON_RIGHT, left, left);
    hand_.click("menu:Show all");
    EXPECT_TRUE(session().settings.shown.parts.hidden.empty());
    const View before = session().navigation.view();
    hand_.drag(GLFW_MOUSE_BUTTON_RIGHT, left, left + glm::dvec2{40, 0});
    EXPECT_FALSE(hand_.has("menu:Show all")) << "a drag looks around";
    EXPECT_FALSE(viewer::same(session().navigation.view(), before));
}

TEST_F(ViewerParts, AreFramed) {
    hand_.click("part:Bolt M8");
    EXPECT_EQ(selected(), "Bolt M8");
    hand_.click("parts.frame");
    EXPECT_NEAR(session().navigation.view().target.x, 2, 0.01);
    hand_.key(GLFW_KEY_LEFT, GLFW_MOD_ALT);
    EXPECT_NEAR(session().navigation.view().target.x, 0, 0.01);
    hand_.key(GLFW_KEY_RIGHT, GLFW_MOD_ALT);
    EXPECT_NEAR(session().navigation.view().target.x, 2, 0.01);
}

TEST_F(ViewerParts, AreSearched) {
    session();
    app_.ui().part_search = "bolt";
    hand_.panel_frames(2);
    EXPECT_TRUE(hand_.has("part:Bolt M8"));
    EXPECT_FALSE(hand_.has("part:Base"));
}

TEST_F(ViewerParts, StepsAreUndoneAndDoneAgain) {
    const std::size_t all = lines();
    const auto plain = picture();
    hand_.click("show:Base");
    const auto without_base = picture();
    hand_.choose("style", "technical");
    const auto technical = picture();
    EXPECT_NE(technical, without_base);
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_EQ(picture(), without_base);
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_EQ(lines(), all);
    EXPECT_EQ(picture(), plain);
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_EQ(picture(), plain) << "there is no step before";
    hand_.key(GLFW_KEY_Y, GLFW_MOD_CONTROL);
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT);
    EXPECT_EQ(picture(), technical);
    EXPECT_EQ(lines(), all / 2);
}

TEST_F(ViewerParts, OneDragOfASliderIsOneStep) {
    const float width = session().settings.style.pen.width;
    const glm::dvec2 middle = hand_.middle_of("width");
    hand_.reveal("width");
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, hand_.middle_of("width"), middle + glm::dvec2{30, 0});
    EXPECT_NE(session().settings.style.pen.width, width);
    hand_.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    EXPECT_EQ(session().settings.style.pen.width, width);
}

TEST_F(ViewerParts, AFileIsReadAgain) {
    const std::size_t all = lines();
    const View before = session().navigation.view();
    write(box("Base", {-2, 0, 0}, 1) + box("Bolt M8", {2, 0, 0}, 9) + box("Nut", {0, 5, 0}, 17));
    hand_.key(GLFW_KEY_R, GLFW_MOD_CONTROL);
    EXPECT_EQ(lines(), all * 3 / 2);
    write(box("Base", {-2, 0, 0}, 1));
    std::filesystem::last_write_time(path("m.obj"),
                                     std::filesystem::file_time_type::clock::now() +
                                         std::chrono::seconds{10}); // with any step of the clock
    for (int looks = 0; looks < 2; ++looks) session().look_at_file();
    hand_.rest();
    EXPECT_EQ(lines(), all / 2) << "by itself";
    EXPECT_EQ(session().navigation.view().eye, before.eye);
}

TEST_F(ViewerParts, SavedPathsAreThoseOfTheToolThatHidesThem) {
    hand_.click("show:Bolt M8");
    hand_.save(viewer::SavedKind::svg);
    hand_.save(viewer::SavedKind::camera);
    EXPECT_EQ(error(), "");
    const std::string saved = text_of(path("m.svg"));
    EXPECT_NE(saved.find("--hide 'Bolt M8'"), std::string::npos);
    const std::string command = std::string{LINEATLAS_TOOL} + " draw " + path("m.obj") +
                                " --hide 'Bolt M8' --size 968x760 --camera-path " + path("m.json") +
                                " -o " + path("tool.%d.svg");
    ASSERT_EQ(std::system(command.c_str()), 0);
    const auto paths = [](const std::string& svg) {
        return svg.substr(std::min(svg.size(), svg.find("<path")));
    };
    EXPECT_EQ(paths(saved), paths(text_of(path("tool.0.svg"))));
}

TEST_F(ViewerParts, FilesAreOpenedFromAPanelAndRemembered) {
    session().recent = viewer::RecentFiles{path("state/recent")};
    std::filesystem::create_directory(path("deeper"));
    std::ofstream{path("deeper/nut.obj")} << box("Nut", {0, 0, 0}, 1);
    std::ofstream{path("deeper/notes.txt")} << "no model\n";
    hand_.key(GLFW_KEY_O, GLFW_MOD_CONTROL);
    hand_.click("entry:deeper/");
    EXPECT_FALSE(hand_.has("entry:notes.txt"));
    hand_.click("entry:nut.obj");
    EXPECT_EQ(session().model()->source.name(), "nut.obj");
    EXPECT_FALSE(hand_.has("open.close"));
    hand_.drop(path("m.obj"));
    EXPECT_EQ(viewer::RecentFiles{path("state/recent")}.all(),
              (std::vector<std::filesystem::path>{path("m.obj"), path("deeper/nut.obj")}));
    hand_.click("open.panel");
    hand_.screenshot("open");
    hand_.click("recent:nut.obj");
    EXPECT_EQ(session().model()->source.name(), "nut.obj");
    hand_.drop(path("deeper/../m.obj"));
    EXPECT_EQ(session().recent.all().size(), 2U) << "the same file by another name";
    std::filesystem::remove(path("deeper/nut.obj"));
    hand_.key(GLFW_KEY_O, GLFW_MOD_CONTROL);
    EXPECT_TRUE(hand_.has("recent:m.obj"));
    EXPECT_FALSE(hand_.has("recent:nut.obj")) << "it is not there any more";
    hand_.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(hand_.has("open.close"));
    EXPECT_EQ(error(), "");
}

} // namespace
} // namespace lineatlas::test
