#include "obj_materials.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include <tiny_obj_loader.h>

namespace lineatlas {
namespace {

/// A material as the file has it. tinyobjloader makes a material without a colour black, and from
/// version 2rc13 on cuts names at the first space.
struct Named {
    std::string name;
    bool has_color = false;
};

std::vector<Named> named_in(const std::string& file) {
    constexpr const char* spaces = " \t\r";
    std::vector<Named> result;
    std::istringstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        std::string keyword;
        std::istringstream words{line};
        words >> keyword;
        if (keyword == "newmtl") {
            std::string name;
            std::getline(words >> std::ws, name);
            name.erase(name.find_last_not_of(spaces) + 1);
            result.push_back({name});
        }
        if (!result.empty() && (keyword == "Kd" || keyword == "map_Kd"))
            result.back().has_color = true;
    }
    return result;
}

} // namespace

ObjMaterials::ObjMaterials(std::span<const std::string> files) {
    for (const std::string& file : files) add(file);
}

void ObjMaterials::add(const std::string& file) {
    std::istringstream stream(file);
    std::map<std::string, int> places;
    std::vector<tinyobj::material_t> materials;
    std::string warnings;
    std::string errors;
    tinyobj::LoadMtl(&places, &materials, &stream, &warnings, &errors);
    const std::vector<Named> named = named_in(file);
    const bool known = named.size() == materials.size();
    for (std::size_t index = 0; index < materials.size(); ++index) {
        if (known && !named[index].has_color) continue;
        const auto& diffuse = materials[index].diffuse;
        glm::vec3 color;
        for (int i = 0; i < 3; ++i)
            color[i] = std::isfinite(diffuse[i]) ? std::clamp(diffuse[i], 0.0F, 1.0F) : 0.0F;
        colors_.try_emplace(known ? named[index].name : materials[index].name, color);
    }
}

std::optional<glm::vec3> ObjMaterials::color(const std::string& material) const {
    const auto found = colors_.find(material);
    if (found == colors_.end()) return std::nullopt;
    return found->second;
}

} // namespace lineatlas
