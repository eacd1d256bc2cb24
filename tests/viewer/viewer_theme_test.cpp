// Readable text: its contrast, and letters of any language.

#include <cmath>

#include "viewer_support.hpp"
// After imgui.h.
#include <imgui_internal.h>

namespace lineatlas::test {
namespace {

/// Relative luminance (WCAG 2.2).
double luminance(const ImVec4& color) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(static_cast<double>(color.x)) +
           0.7152 * linear(static_cast<double>(color.y)) +
           0.0722 * linear(static_cast<double>(color.z));
}

double contrast(const ImVec4& a, const ImVec4& b) {
    const double high = std::max(luminance(a), luminance(b));
    return (high + 0.05) / (std::min(luminance(a), luminance(b)) + 0.05);
}

ImVec4 over(const ImVec4& color, const ImVec4& ground) {
    const auto mix = [&](float a, float b) { return color.w * a + (1 - color.w) * b; };
    return {mix(color.x, ground.x), mix(color.y, ground.y), mix(color.z, ground.z), 1};
}

class ViewerTheme : public Viewer {
  protected:
    static constexpr double least = 4.5;

    static ImVec4 of(ImGuiCol color) { return ImGui::GetStyle().Colors[color]; }
    static ImVec4 of(ImU32 color) { return ImGui::ColorConvertU32ToFloat4(color); }
};

TEST_F(ViewerTheme, TextsOfPanelsCanBeRead) {
    for (const viewer::Theme theme : {viewer::Theme::light, viewer::Theme::dark}) {
        app_.ui().theme = theme;
        hand_.panel_frames(2);
        const viewer::theme::Colors& colors = viewer::theme::colors();
        const ImVec4 panel = of(ImGuiCol_WindowBg);
        for (const ImU32 text : {colors.ink, colors.quiet, colors.alarm})
            EXPECT_GE(contrast(of(text), panel), least);
        EXPECT_GE(contrast(of(colors.on_accent), of(colors.accent)), least);
        for (const ImGuiCol ground :
             {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive, ImGuiCol_FrameBg,
              ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_Header,
              ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive})
            EXPECT_GE(contrast(of(ImGuiCol_Text), over(of(ground), panel)), least) << ground;
        EXPECT_GE(contrast(of(ImGuiCol_TextDisabled), over(of(ImGuiCol_FrameBg), panel)), least);
    }
}

TEST_F(ViewerTheme, TextsOverThePictureCanBeReadOnAnyPaper) {
    for (const viewer::Theme theme : {viewer::Theme::light, viewer::Theme::dark}) {
        app_.ui().theme = theme;
        for (const glm::vec3 paper : {glm::vec3{0}, glm::vec3{0.45F}, glm::vec3{1},
                                      glm::vec3{0.1F, 0.2F, 0.5F}, glm::vec3{0.93F, 0.88F, 0.7F}}) {
            session().settings.style.paper.color = paper;
            session().changed();
            hand_.rest();
            const Image image = app_.screenshot();
            const viewer::Area area = *app_.ui().spots.find("status:Quick");
            double low = 1, high = 0;
            for (float y = area.low.y; y < area.low.y + area.size.y; ++y)
                for (float x = area.low.x; x < area.low.x + area.size.x; ++x) {
                    const auto at =
                        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.x) +
                             static_cast<std::size_t>(x));
                    const auto value = [&](std::size_t c) {
                        return static_cast<float>(image.pixels[at + c]) / 255;
                    };
                    const double l = luminance({value(0), value(1), value(2), 1});
                    low = std::min(low, l);
                    high = std::max(high, l);
                }
            EXPECT_GE((high + 0.05) / (low + 0.05), least);
            EXPECT_LT((high + 0.05) / (low + 0.05), 21) << "paper and ink of a panel, not black";
        }
    }
}

TEST_F(ViewerTheme, NamesHaveAnyLetters) {
    const std::string name = "K\u00f6rper \u2013 \u010d\u03a9\u0416 \u6f22\u5b57";
    std::ofstream{path(name + ".obj")} << box(name, {-2, 0, 0}, 1) + box("Bolt", {2, 0, 0}, 9);
    hand_.drop(path(name + ".obj"));
    EXPECT_EQ(error(), "");
    const ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    const auto has = [&](unsigned letter) {
        return std::ranges::all_of(fonts.Fonts, [&](const ImFont* font) {
            return font->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr;
        });
    };
    hand_.screenshot("letters");
    for (const unsigned letter : {0xF6U, 0x2013U, 0x10DU, 0x3A9U, 0x416U})
        EXPECT_TRUE(has(letter)) << letter;
    EXPECT_FALSE(has(0x2192)) << "only those that are needed";
    app_.input().on_character(0x2192);
    hand_.rest();
    EXPECT_TRUE(has(0x2192)) << "one that is typed";
    ImGui::SetClipboardText("\u2211");
    hand_.click("parts.search");
    hand_.press(GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL);
    hand_.key(GLFW_KEY_V, GLFW_MOD_CONTROL);
    hand_.release(GLFW_KEY_LEFT_CONTROL);
    EXPECT_EQ(app_.ui().part_search, "\u2211");
    EXPECT_TRUE(has(0x2211)) << "one that is pasted";
    if (std::system("fc-list :lang=zh | grep -q .") != 0) GTEST_SKIP() << "needs a Chinese font";
    for (const unsigned letter : {0x6F22U, 0x5B57U}) EXPECT_TRUE(has(letter)) << letter;
}

} // namespace
} // namespace lineatlas::test
