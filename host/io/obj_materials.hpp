#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace lineatlas {

/// The diffuse colours of material files (MTL).
class ObjMaterials {
  public:
    /// `files`: the contents of the files. If several define a material, the first definition
    /// counts.
    explicit ObjMaterials(std::span<const std::string> files);

    /// The colour of a material; nothing if no file defines it.
    std::optional<glm::vec3> color(const std::string& material) const;

  private:
    void add(std::string_view file);

    std::map<std::string, glm::vec3> colors_;
};

} // namespace lineatlas
