#include "obj_materials.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include <tiny_obj_loader.h>

namespace lineatlas {
namespace {

/// Whether each material of a file says anything of its colour: tinyobjloader takes one that
/// doesn't for black.
std::vector<bool> have_color(const std::string& file) {
    std::vector<bool> result;
    std::istringstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        std::string keyword;
        std::istringstream{line} >> keyword;
        if (keyword == "newmtl") result.push_back(false);
        if (!result.empty() && (keyword == "Kd" || keyword == "map_Kd")) result.back() = true;
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
    const std::vector<bool> colored = have_color(file);
    for (const auto& [name, place] : places) {
        const auto index = static_cast<std::size_t>(place);
        if (colored.size() == materials.size() && !colored[index]) continue;
        const auto& diffuse = materials[index].diffuse;
        glm::vec3 color;
        for (int i = 0; i < 3; ++i)
            color[i] = std::isfinite(diffuse[i]) ? std::clamp(diffuse[i], 0.0F, 1.0F) : 0.0F;
        colors_.try_emplace(name, color);
    }
}

std::optional<glm::vec3> ObjMaterials::color(const std::string& material) const {
    const auto found = colors_.find(material);
    if (found == colors_.end()) return std::nullopt;
    return found->second;
}

} // namespace lineatlas
