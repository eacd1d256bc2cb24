#include "description.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "command_line/session_file.hpp"
#include "style/frame_settings.hpp"

namespace lineatlas::apps {
namespace {

/// Options that do not change the picture: its file, its number in a sequence, and the device. The
/// camera is described elsewhere.
constexpr std::array<std::string_view, 21> not_of_the_picture{
    "MODEL",        "--output",     "--eye",   "--target",    "--up",          "--fov",
    "--view",       "--projection", "--at",    "--turntable", "--camera-path", "--frames",
    "--unit",       "--resume",     "--stats", "--repeat",    "--tile",        "--certify",
    "--deflection", "--compute",    "--device"};

std::string one_word(const std::string& text) {
    const bool plain = text.find_first_of(" \t\r\n'\"") == std::string::npos;
    std::string safe = text;
    std::ranges::replace_if(
        safe, [](unsigned char c) { return c < 0x20 || c == '\''; }, '?');
    return plain ? safe : fmt::format("'{}'", safe);
}

} // namespace

std::string describe_drawing(const CLI::App& app, const std::string& model,
                             const std::vector<std::string>& sections, double deflection,
                             LineKindMask lines) {
    std::string text = "draw";
    // Without its folders, which are private.
    if (!model.empty()) text += " " + one_word(std::filesystem::path{model}.filename().string());
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 ||
            std::ranges::find(not_of_the_picture, name) != not_of_the_picture.end()) {
            continue;
        }
        for (const std::string& value : name == "--section" ? sections : option->results()) {
            text += fmt::format(" {}={}", name, one_word(value));
        }
    }
    if (lines != usual_line_kinds && app.count("--lines") == 0)
        text += " --lines=" + line_kinds_to_text(lines);
    if (deflection > 0) text += fmt::format(" --deflection={}", shortest(deflection));
    return text;
}

} // namespace lineatlas::apps
