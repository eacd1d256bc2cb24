#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas::test {

/// The bytes of numbers one after the other, as in a buffer.
class GltfBytes {
  public:
    template <class T>
    GltfBytes& add(const std::vector<T>& values) {
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        return *this;
    }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

/// A GLB file.
std::string to_glb(std::string json, std::string binary);

/// "data:application/octet-stream;base64,..."
std::string to_data_uri(std::string_view bytes);

/// The eight corners and twelve outward triangles of a cube from 0 to 1.
std::vector<float> cube_corners();
std::vector<std::uint16_t> cube_triangles();

/// The JSON of a cube (accessor 0 positions, 1 indices) under `nodes`, `members` of the file added.
/// Its buffer of 168 bytes is `uri`, or the GLB's own if `uri` is empty.
std::string cube_json(const std::string& nodes, const std::string& uri = {},
                      const std::string& members = {});
std::string cube_bytes();

} // namespace lineatlas::test
