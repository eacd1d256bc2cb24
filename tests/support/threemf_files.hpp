#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lineatlas::test {

/// A file in an archive.
struct ZipPart {
    std::string name;
    std::string bytes;
};

/// A ZIP archive whose files are stored as they are.
std::string to_zip(const std::vector<ZipPart>& parts);

/// The same with files packed by deflate.
std::string to_packed_zip(const std::vector<ZipPart>& parts);

/// The parts of a 3MF package other than its model: the list of types and the relation to the
/// model.
std::vector<ZipPart> package_parts();
/// A 3MF package of one model.
std::string to_3mf(const std::string& model);

/// A model of these resources and items. `attributes` are added to its first tag.
std::string threemf_model(std::string_view resources, std::string_view items,
                          std::string_view attributes = R"(unit="millimeter")");

/// An object: the mesh of a cube from 0 to 1, its 12 triangles outwards.
std::string cube_object(int id, std::string_view name, std::string_view attributes = {},
                        std::string_view triangle_attributes = {});

} // namespace lineatlas::test
