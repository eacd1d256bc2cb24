#include "theme.hpp"

#include <array>
#include <filesystem>

namespace lineatlas::viewer {
namespace {

constexpr float letter_size = 15; // points
constexpr float heading_size = 15;

struct FontFiles {
    const char* regular;
    const char* bold;
};
/// The first that is there is taken; without any, the font inside ImGui.
constexpr std::array<FontFiles, 4> font_files{
    {{"/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
      "/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf"},
     {"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
      "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf"},
     {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
     {"/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
      "/usr/share/fonts/truetype/liberation2/LiberationSans-Bold.ttf"}}};

ImFont* load_fonts(float pixels_per_letter) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    for (const FontFiles& files : font_files) {
        if (!std::filesystem::exists(files.regular) || !std::filesystem::exists(files.bold))
            continue;
        fonts.AddFontFromFileTTF(files.regular, letter_size * pixels_per_letter);
        return fonts.AddFontFromFileTTF(files.bold, heading_size * pixels_per_letter);
    }
    ImFontConfig config;
    config.SizePixels = letter_size * pixels_per_letter;
    return fonts.AddFontDefault(&config);
}

void set_colors(ImGuiStyle& style) {
    const auto color = [](int r, int g, int b, float a = 1) {
        constexpr float full = 255;
        return ImVec4{static_cast<float>(r) / full, static_cast<float>(g) / full,
                      static_cast<float>(b) / full, a};
    };
    const auto ink = [&](float a) { return color(38, 40, 44, a); };
    const auto blue = [&](float a) { return color(44, 98, 158, a); };
    ImGui::StyleColorsLight(&style);
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = ink(1);
    c[ImGuiCol_TextDisabled] = color(120, 122, 128);
    c[ImGuiCol_WindowBg] = color(248, 247, 244);
    c[ImGuiCol_PopupBg] = color(255, 255, 254);
    c[ImGuiCol_Border] = color(222, 220, 214);
    c[ImGuiCol_FrameBg] = color(236, 234, 229);
    c[ImGuiCol_FrameBgHovered] = color(228, 226, 220);
    c[ImGuiCol_FrameBgActive] = color(220, 217, 210);
    c[ImGuiCol_Button] = color(236, 234, 229);
    c[ImGuiCol_ButtonHovered] = color(225, 222, 215);
    c[ImGuiCol_ButtonActive] = color(212, 209, 201);
    c[ImGuiCol_Header] = blue(0.12F);
    c[ImGuiCol_HeaderHovered] = blue(0.18F);
    c[ImGuiCol_HeaderActive] = blue(0.26F);
    c[ImGuiCol_CheckMark] = blue(1);
    c[ImGuiCol_SliderGrab] = blue(0.75F);
    c[ImGuiCol_SliderGrabActive] = blue(1);
    c[ImGuiCol_TextSelectedBg] = blue(0.25F);
    c[ImGuiCol_ScrollbarBg] = color(0, 0, 0, 0);
    c[ImGuiCol_ScrollbarGrab] = ink(0.16F);
    c[ImGuiCol_ScrollbarGrabHovered] = ink(0.28F);
    c[ImGuiCol_ScrollbarGrabActive] = ink(0.4F);
    c[ImGuiCol_Separator] = color(222, 220, 214);
    c[ImGuiCol_NavHighlight] = blue(0.8F);
}

} // namespace

ImFont* apply_theme(float scale, float pixels_per_point) {
    ImGuiIO& io = ImGui::GetIO();
    ImFont* bold = load_fonts(scale * pixels_per_point);
    io.FontGlobalScale = 1 / pixels_per_point;
    ImGuiStyle style;
    set_colors(style);
    style.WindowPadding = {16, 14};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 5};
    style.ItemInnerSpacing = {8, 4};
    style.ScrollbarSize = 8;
    style.GrabMinSize = 12;
    style.WindowRounding = 0;
    style.PopupRounding = style.FrameRounding = style.GrabRounding = 4;
    style.ScrollbarRounding = 4;
    style.WindowBorderSize = style.FrameBorderSize = style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
    return bold;
}

} // namespace lineatlas::viewer
