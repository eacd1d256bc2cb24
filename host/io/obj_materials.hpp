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
    /// `files` are their contents; of a material that several define, the first counts.
    explicit ObjMaterials(std::span<const std::string> files);

    /// Nothing for a material that no file defines.
    std::optional<glm::vec3> color(const std::string& material) const;

  private:
    void add(std::string_view file);

    std::map<std::string, glm::vec3> colors_;
};

} // namespace lineatlas
