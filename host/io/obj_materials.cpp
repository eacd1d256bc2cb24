#include "obj_materials.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "obj_text.hpp"
#include "text_cursor.hpp"

namespace lineatlas {
namespace {

/// A colour of three numbers. A number that is missing, or is no number, is 0.
glm::vec3 color_of(std::string_view words) {
    glm::vec3 color{0};
    for (int i = 0; i < 3; ++i) {
        const auto value = static_cast<float>(parse_number(take_word(words)).value_or(0));
        color[i] = std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0.0F;
    }
    return color;
}

} // namespace

ObjMaterials::ObjMaterials(std::span<const std::string> files) {
    for (const std::string& file : files) add(file);
}

void ObjMaterials::add(std::string_view file) {
    constexpr glm::vec3 under_picture{0.6F}; // of a material with a picture and no colour
    std::optional<std::string> name;
    std::optional<glm::vec3> color;
    const auto keep = [&] {
        if (name && color) colors_.try_emplace(*name, *color);
        color.reset();
    };
    while (!file.empty()) {
        std::string_view line = take_line(file);
        const std::string_view keyword = take_word(line);
        if (keyword == "newmtl") {
            keep();
            name = trimmed(line);
        } else if (keyword == "Kd") {
            color = color_of(line);
        } else if (keyword == "map_Kd" && !color) {
            color = under_picture;
        }
    }
    keep();
}

std::optional<glm::vec3> ObjMaterials::color(const std::string& material) const {
    const auto found = colors_.find(material);
    if (found == colors_.end()) return std::nullopt;
    return found->second;
}

} // namespace lineatlas
