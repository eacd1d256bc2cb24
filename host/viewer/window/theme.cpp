#include "theme.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace lineatlas::viewer {
namespace {

struct FontFiles {
    const char* regular;
    const char* bold;
};
/// Fonts to choose from. The first that exists is used; without any, the font inside ImGui.
constexpr std::array<FontFiles, 4> font_files{
    {{"/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
      "/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf"},
     {"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
      "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf"},
     {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
     {"/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
      "/usr/share/fonts/truetype/liberation2/LiberationSans-Bold.ttf"}}};

/// Fonts for letters that the chosen font lacks.
constexpr std::array other_fonts{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                 "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                                 "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
                                 "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf",
                                 "/usr/share/fonts/truetype/wqy/wqy-zenhei.ttc",
                                 "/usr/share/fonts/truetype/noto/NotoSansArabic-Regular.ttf",
                                 "/usr/share/fonts/truetype/noto/NotoSansHebrew-Regular.ttf",
                                 "/usr/share/fonts/truetype/noto/NotoSansDevanagari-Regular.ttf",
                                 "/usr/share/fonts/truetype/noto/NotoSansThai-Regular.ttf"};

/// The ranges of the usual letters and of these.
ImVector<ImWchar> ranges_of(const Letters& letters) {
    ImFontGlyphRangesBuilder builder;
    builder.AddRanges(ImGui::GetIO().Fonts->GetGlyphRangesDefault());
    for (const unsigned letter : letters)
        if (letter <= IM_UNICODE_CODEPOINT_MAX) builder.AddChar(static_cast<ImWchar>(letter));
    ImVector<ImWchar> ranges;
    builder.BuildRanges(&ranges);
    return ranges;
}

ImFont* add_font(const char* file, float size, const Letters& letters, const ImWchar* ranges) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    ImFont* font = fonts.AddFontFromFileTTF(file, size, nullptr, ranges);
    ImFontConfig more;
    more.MergeMode = true; // letters that are there already do not change
    for (const char* other : other_fonts)
        if (!letters.empty() && std::filesystem::exists(other))
            fonts.AddFontFromFileTTF(other, size, &more, ranges);
    return font;
}

ImFont* load_fonts(float pixels_per_letter, const Letters& letters) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    const ImVector<ImWchar> ranges = ranges_of(letters); // must live until the fonts are built
    for (const FontFiles& files : font_files) {
        if (!std::filesystem::exists(files.regular) || !std::filesystem::exists(files.bold))
            continue;
        add_font(files.regular, measures::letters * pixels_per_letter, letters, ranges.Data);
        ImFont* bold =
            add_font(files.bold, measures::letters * pixels_per_letter, letters, ranges.Data);
        if (fonts.Build()) return bold;
        fonts.Clear(); // a file is broken
    }
    ImFontConfig config;
    config.SizePixels = measures::letters * pixels_per_letter;
    return fonts.AddFontDefault(&config);
}

constexpr theme::Colors light_colors{.ink = IM_COL32(38, 40, 44, 255),
                                     .quiet = IM_COL32(92, 94, 100, 255),
                                     .accent = IM_COL32(44, 98, 158, 255),
                                     .on_accent = IM_COL32(255, 255, 255, 255),
                                     .line = IM_COL32(222, 220, 214, 255),
                                     .panel = IM_COL32(248, 247, 244, 255),
                                     .alarm = IM_COL32(176, 48, 40, 255),
                                     .selection = IM_COL32(44, 98, 158, 255),
                                     .section = IM_COL32(196, 92, 20, 255),
                                     .measure = IM_COL32(120, 60, 150, 255)};
constexpr theme::Colors dark_colors{.ink = IM_COL32(226, 226, 222, 255),
                                    .quiet = IM_COL32(160, 162, 166, 255),
                                    .accent = IM_COL32(52, 108, 172, 255),
                                    .on_accent = IM_COL32(255, 255, 255, 255),
                                    .line = IM_COL32(64, 66, 70, 255),
                                    .panel = IM_COL32(36, 38, 41, 255),
                                    .alarm = IM_COL32(240, 120, 108, 255),
                                    .selection = IM_COL32(72, 134, 204, 255),
                                    .section = IM_COL32(216, 116, 36, 255),
                                    .measure = IM_COL32(168, 104, 200, 255)};

Theme& applied() {
    static Theme theme = Theme::light;
    return theme;
}

ImVec4 with_alpha(ImU32 color, float alpha) {
    ImVec4 value = ImGui::ColorConvertU32ToFloat4(color);
    value.w = alpha;
    return value;
}

void set_colors(ImGuiStyle& style) {
    const theme::Colors& now = theme::colors();
    const auto ink = [&](float alpha) { return with_alpha(now.ink, alpha); };
    const auto accent = [&](float alpha) { return with_alpha(now.accent, alpha); };
    if (applied() == Theme::dark)
        ImGui::StyleColorsDark(&style);
    else
        ImGui::StyleColorsLight(&style);
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = ink(1);
    c[ImGuiCol_TextDisabled] = with_alpha(now.quiet, 1);
    c[ImGuiCol_WindowBg] = with_alpha(now.panel, 1);
    c[ImGuiCol_PopupBg] = with_alpha(now.panel, 1);
    c[ImGuiCol_Border] = c[ImGuiCol_Separator] = with_alpha(now.line, 1);
    c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = ink(0.07F);
    c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = ink(0.12F);
    c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = ink(0.18F);
    c[ImGuiCol_Header] = accent(0.16F);
    c[ImGuiCol_HeaderHovered] = accent(0.24F);
    c[ImGuiCol_HeaderActive] = accent(0.32F);
    c[ImGuiCol_CheckMark] = accent(1);
    c[ImGuiCol_SliderGrab] = accent(0.75F);
    c[ImGuiCol_SliderGrabActive] = accent(1);
    c[ImGuiCol_TextSelectedBg] = accent(0.3F);
    c[ImGuiCol_ScrollbarBg] = ink(0.08F);
    c[ImGuiCol_ScrollbarGrab] = ink(0.42F);
    c[ImGuiCol_ScrollbarGrabHovered] = ink(0.55F);
    c[ImGuiCol_ScrollbarGrabActive] = ink(0.7F);
    c[ImGuiCol_NavHighlight] = accent(0.8F);
}

} // namespace

const theme::Colors& theme::colors() {
    return applied() == Theme::dark ? dark_colors : light_colors;
}

Theme theme_of_desktop() {
    const char* name = std::getenv("GTK_THEME");
    const bool dark = name != nullptr && std::string_view{name}.find("dark") != std::string::npos;
    return dark ? Theme::dark : Theme::light;
}

ImFont* apply_theme(Theme theme, float scale, float pixels_per_point, const Letters& letters) {
    applied() = theme;
    ImGuiIO& io = ImGui::GetIO();
    ImFont* bold = load_fonts(scale * pixels_per_point, letters);
    io.FontGlobalScale = 1 / pixels_per_point;
    ImGuiStyle style;
    set_colors(style);
    style.WindowPadding = {16, 14};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {measures::gap, 5};
    style.ItemInnerSpacing = {measures::gap, 4};
    style.ScrollbarSize = 12;
    style.GrabMinSize = 12;
    style.WindowRounding = 0;
    style.PopupRounding = style.FrameRounding = style.GrabRounding = measures::item_rounding;
    style.ScrollbarRounding = 6;
    style.WindowBorderSize = style.FrameBorderSize = style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
    return bold;
}

} // namespace lineatlas::viewer
