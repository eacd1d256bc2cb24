#include "description.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

namespace lineatlas::apps {
namespace {

/// They say where the picture goes and which of many it is; the camera stands for itself.
constexpr std::array<std::string_view, 14> not_of_the_picture{
    "MODEL",       "--output",      "--eye",    "--target", "--up",    "--fov",    "--at",
    "--turntable", "--camera-path", "--frames", "--resume", "--stats", "--repeat", "--tile"};

std::string one_word(const std::string& text) {
    const bool plain = text.find_first_of(" \t\r\n'\"") == std::string::npos;
    std::string safe = text;
    std::ranges::replace_if(
        safe, [](unsigned char c) { return c < 0x20 || c == '\''; }, '?');
    return plain ? safe : fmt::format("'{}'", safe);
}

std::string written(glm::vec3 v) {
    return fmt::format("{:.7g},{:.7g},{:.7g}", v.x, v.y, v.z);
}

} // namespace

std::string describe_drawing(const CLI::App& app, const std::string& model) {
    std::string text = "draw";
    // Without its folders, which are nobody's business.
    if (!model.empty()) text += " " + one_word(std::filesystem::path{model}.filename().string());
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 ||
            std::ranges::find(not_of_the_picture, name) != not_of_the_picture.end()) {
            continue;
        }
        for (const std::string& value : option->results()) {
            text += fmt::format(" {}={}", name, one_word(value));
        }
    }
    return text;
}

std::string describe_camera(const Camera& camera) {
    const glm::mat4& v = camera.view;
    const glm::vec3 eye{camera.eye()};
    const glm::vec3 forward{-v[0][2], -v[1][2], -v[2][2]};
    const glm::vec3 up{v[0][1], v[1][1], v[2][1]};
    const float fov = 2 * std::atan(1 / camera.projection[1][1]) * 180 / std::numbers::pi_v<float>;
    return fmt::format("--eye {} --target {} --up {} --fov {:.6g}", written(eye),
                       written(eye + forward), written(up), fov);
}

} // namespace lineatlas::apps
