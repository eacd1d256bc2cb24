#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "temporary_folder.hpp"

// Mesh files of a few lines, and the messages about them.
namespace lineatlas::test {

namespace fs = std::filesystem;

class MeshIo : public testing::Test {
  protected:
    fs::path file(const std::string& name, std::string_view content) const {
        const fs::path path = folder_.path() / name;
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }

    LoadedMesh load(const std::string& name, std::string_view content) const {
        return load_mesh(file(name, content));
    }

    /// The message about a file. Expects that it is one line that names the file.
    static std::string error_of(const fs::path& path) {
        try {
            load_mesh(path);
        } catch (const FileError& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            EXPECT_EQ(message.find("cannot read \"" + path.string() + "\": "), 0U) << message;
            return message;
        }
        ADD_FAILURE() << path << " was accepted";
        return {};
    }

    std::string error_of(const std::string& name, std::string_view content) const {
        return error_of(file(name, content));
    }

    TemporaryFolder folder_;
};

inline testing::AssertionResult has(std::string_view text, std::string_view part) {
    if (text.find(part) != std::string_view::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << '"' << text << "\" lacks \"" << part << '"';
}

inline double area(const Mesh& mesh) {
    double sum = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]);
        sum += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.positions[t.y]) - a,
                                            glm::dvec3(mesh.positions[t.z]) - a));
    }
    return sum;
}

inline void put_u32(std::string& bytes, std::uint32_t value, bool big_endian = false) {
    for (unsigned i = 0; i < 4; ++i)
        bytes += static_cast<char>(value >> (big_endian ? 24 - 8 * i : 8 * i));
}

inline void put_f32(std::string& bytes, float value, bool big_endian = false) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    put_u32(bytes, bits, big_endian);
}

inline std::string binary_stl(std::uint32_t promised,
                              const std::vector<std::array<float, 9>>& facets,
                              const std::string& title = "made by a test") {
    std::string bytes = title + std::string(80 - title.size(), '\0');
    put_u32(bytes, promised);
    for (const auto& facet : facets) {
        bytes.append(12, '\0');
        for (const float value : facet) put_f32(bytes, value);
        bytes.append(2, '\0');
    }
    return bytes;
}

inline const std::vector<std::array<float, 9>> two_facets{{0, 0, 0, 1, 0, 0, 0, 1, 0},
                                                          {1, 0, 0, 1, 1, 0, 0, 1, 0}};
inline const std::string square_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

inline const std::string ply_square =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

} // namespace lineatlas::test
