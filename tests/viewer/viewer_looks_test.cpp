// The looks of the viewer's window. With any size, scale and colours nothing is cut off or covers
// something else. LINEATLAS_SCREENSHOTS names a folder for the pictures; docs/viewer.md shows some.

#include <fmt/format.h>
#include <glm/vector_relational.hpp>

#include "viewer_support.hpp"

namespace lineatlas::test {
namespace {

struct Look {
    glm::ivec2 size;
    float scale;
    viewer::Theme theme;

    std::string name() const {
        return fmt::format("{}x{}{}", size.x, size.y, theme == viewer::Theme::dark ? "_dark" : "");
    }
};

/// Boxes in rows.
std::string boxes(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 at{3.0F * static_cast<float>(i % 50), 3.0F * static_cast<float>(i / 50),
                           static_cast<float>(i % 7)};
        text += box(fmt::format("Bracket {:04}", i), at, 8 * i + 1);
    }
    return text;
}

class ViewerLooks : public testing::TestWithParam<Look> {
  protected:
    ViewerLooks()
        : app_{{.size = GetParam().size,
                .scale = GetParam().scale,
                .theme = GetParam().theme,
                .scripted = true},
               writer_} {
        app_.ui().folder = "drawings";
    }
    viewer::Session& session() { return app_.session(); }

    /// Saves a picture. Expects that items are within the window and apart.
    void look(const char* what) {
        SCOPED_TRACE(what);
        hand_.screenshot(fmt::format("{}_{}", what, GetParam().name()));
        const glm::vec2 window{app_.window().points()};
        const float border = window.x - viewer::sidebar_width(app_.ui());
        // The first item of the footer. Items that scroll are above it.
        const float footer = app_.ui().spots.find("export")->low.y;
        const auto in_sight = [&](const std::string& name, const viewer::Area& area) {
            const bool of_footer = name == "export" || name == "save.session";
            const bool row = name.starts_with("part:") || name.starts_with("show:"); // scrolls
            const float high = area.low.y + area.size.y;
            return of_footer || (!row && area.low.y >= 0 && high < footer - 30 * GetParam().scale);
        };
        std::vector<std::pair<std::string, viewer::Area>> seen;
        for (const auto& [name, area] : app_.ui().spots.all())
            if (!name.starts_with("axis.") && (area.low.x < border || in_sight(name, area)))
                seen.emplace_back(name, area);
        EXPECT_GT(seen.size(), 8U);
        for (const auto& [name, area] : seen) {
            const glm::vec2 high = area.low + area.size;
            EXPECT_GE(area.low.x, 0) << name;
            EXPECT_GE(area.low.y, 0) << name;
            EXPECT_LE(high.x, window.x) << name;
            EXPECT_LE(high.y, window.y) << name;
            EXPECT_TRUE(area.low.x >= border || high.x <= border) << name;
            for (const auto& [other, its] : seen) {
                const glm::vec2 end = its.low + its.size;
                const bool apart = high.x <= its.low.x + 0.5F || end.x <= area.low.x + 0.5F ||
                                   high.y <= its.low.y + 0.5F || end.y <= area.low.y + 0.5F;
                EXPECT_TRUE(apart || other == name) << name << " and " << other;
            }
        }
    }

    /// The same for the panel of exports, which covers the sidebar in small windows.
    void look_at_export() {
        hand_.key(GLFW_KEY_E, GLFW_MOD_CONTROL);
        hand_.click("export.print");
        hand_.click("export.sheet");
        hand_.move({1, 1}); // no tooltip shows
        hand_.screenshot(fmt::format("export_{}", GetParam().name()));
        const glm::vec2 window{app_.window().points()};
        std::vector<std::pair<std::string, viewer::Area>> seen;
        for (const auto& [name, area] : app_.ui().spots.all())
            if (name.starts_with("export.")) seen.emplace_back(name, area);
        EXPECT_GT(seen.size(), 20U);
        for (const auto& [name, area] : seen) {
            const glm::vec2 high = area.low + area.size;
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(area.low, glm::vec2{0}))) << name;
            EXPECT_TRUE(glm::all(glm::lessThanEqual(high, window))) << name;
            for (const auto& [other, its] : seen) {
                const glm::vec2 end = its.low + its.size;
                const bool apart = high.x <= its.low.x + 0.5F || end.x <= area.low.x + 0.5F ||
                                   high.y <= its.low.y + 0.5F || end.y <= area.low.y + 0.5F;
                EXPECT_TRUE(apart || other == name) << name << " and " << other;
            }
        }
        hand_.key(GLFW_KEY_ESCAPE);
    }

    TemporaryFolder folder_;
    ImageWriter writer_;
    viewer::Application app_;
    ViewerDriver hand_{app_};
};

TEST_P(ViewerLooks, NothingIsCutOffOrCovered) {
    hand_.panel_frames(3);
    look("empty");
    hand_.open_scene("house");
    hand_.key(GLFW_KEY_C);
    hand_.move(0.4 * glm::dvec2{session().size()});
    look("house");
    hand_.click("part:walls");
    hand_.move(0.4 * glm::dvec2{session().size()});
    look("picked");
    session().select({});
    look_at_export();
    hand_.reveal("lines.hatching");
    hand_.move(0.4 * glm::dvec2{session().size()});
    look("lines");
    hand_.reveal("record.frames");
    hand_.move(0.4 * glm::dvec2{session().size()});
    look("views");
    const std::filesystem::path bad = folder_.path() / "bracket.stl";
    std::ofstream{bad} << "solid";
    hand_.drop(bad);
    look("error");
    hand_.key(GLFW_KEY_ESCAPE);
    const std::filesystem::path many = folder_.path() / "brackets.obj";
    std::ofstream{many} << boxes(2000);
    hand_.drop(many);
    ASSERT_EQ(session().model()->parts.all().size(), 2000U);
    hand_.scroll(40, {app_.window().points().x - 100, 200});
    hand_.move(0.4 * glm::dvec2{session().size()});
    look("parts");
}

INSTANTIATE_TEST_SUITE_P(Sizes, ViewerLooks,
                         testing::Values(Look{{900, 600}, 1, viewer::Theme::light},
                                         Look{{900, 600}, 1, viewer::Theme::dark},
                                         Look{{1280, 800}, 1, viewer::Theme::light},
                                         Look{{1280, 800}, 1, viewer::Theme::dark},
                                         Look{{2560, 1440}, 2, viewer::Theme::light},
                                         Look{{2560, 1440}, 2, viewer::Theme::dark}),
                         [](const auto& look) { return look.param.name(); });

} // namespace
} // namespace lineatlas::test
