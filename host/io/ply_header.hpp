#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "source_file.hpp"

namespace lineatlas {

enum class PlyEncoding { ascii, little_endian, big_endian };
enum class PlyKind { without_sign, with_sign, floating };

struct PlyType {
    PlyKind kind = PlyKind::floating;
    std::size_t size = 4; ///< bytes
};

struct PlyProperty {
    std::string name;
    PlyType type;                      ///< type of the value, or of each value of a list
    std::optional<PlyType> count_type; ///< set for lists

    bool is_corners() const { return name == "vertex_indices" || name == "vertex_index"; }
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements; ///< in the order of the data
    std::size_t size = 0;             ///< bytes, up to the first value
    std::size_t lines = 0;
};

/// Reads a header. Throws FileError unless it is complete and has vertices with x, y and z.
PlyHeader read_ply_header(const SourceFile& source);

} // namespace lineatlas
