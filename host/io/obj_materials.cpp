#include "obj_materials.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <system_error>

#include <tiny_obj_loader.h>

#include "source_file.hpp"

namespace lineatlas {

ObjMaterials::ObjMaterials(const std::filesystem::path& obj_path,
                           std::span<const std::string> names) {
    const std::filesystem::path folder = obj_path.parent_path();
    for (std::string name : names) {
        std::replace(name.begin(), name.end(), '\\', '/');
        // A name may hold blanks, or the line may name several files: the first that exists counts.
        if (load(folder / name)) continue;
        std::istringstream words(name);
        bool any = false;
        for (std::string word; words >> word;) any = load(folder / word) || any;
        if (!any)
            notes_.push_back("material file " + lineatlas::quoted(name) +
                             " cannot be read; its materials have no colour");
    }
}

bool ObjMaterials::load(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return false;

    std::map<std::string, int> places;
    std::vector<tinyobj::material_t> materials;
    std::string warnings;
    std::string errors;
    tinyobj::LoadMtl(&places, &materials, &stream, &warnings, &errors);
    for (const auto& [name, place] : places) {
        const auto& diffuse = materials[static_cast<std::size_t>(place)].diffuse;
        glm::vec3 color;
        for (int i = 0; i < 3; ++i)
            color[i] = std::isfinite(diffuse[i]) ? std::clamp(diffuse[i], 0.0F, 1.0F) : 0.0F;
        colors_.try_emplace(name, color);
    }
    return true;
}

std::optional<glm::vec3> ObjMaterials::color(const std::string& material) const {
    const auto found = colors_.find(material);
    if (found == colors_.end()) return std::nullopt;
    return found->second;
}

} // namespace lineatlas
