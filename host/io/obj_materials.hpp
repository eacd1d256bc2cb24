#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas {

/// The diffuse colours of the material files that an OBJ file names.
class ObjMaterials {
  public:
    /// `names` are what follows each `mtllib`; they are looked for beside the OBJ file at
    /// `obj_path`.
    ObjMaterials(const std::filesystem::path& obj_path, std::span<const std::string> names);

    /// Nothing for a material that no file defines.
    std::optional<glm::vec3> color(const std::string& material) const;

    /// One line for each file that could not be read.
    const std::vector<std::string>& notes() const { return notes_; }

  private:
    bool load(const std::filesystem::path& path);

    std::map<std::string, glm::vec3> colors_;
    std::vector<std::string> notes_;
};

} // namespace lineatlas
