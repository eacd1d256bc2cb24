#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "lineatlas/io.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::apps {

/// The output of `lineatlas info` for a model as a JSON object; docs/input.md has its members.
/// `lines`: the lines of its mesh.
nlohmann::ordered_json describe_model(const std::string& file, const LoadedMesh& loaded,
                                      const LineSet& lines);

/// Per triangle of the mesh the number that its part has in the parts list, and on balloons: from 1
/// on in the order of the parts, one for all instances of a shape.
std::vector<std::uint32_t> item_numbers(const LoadedMesh& loaded);

/// What describe_model() says as text for people: a line for the file, and one for each part of its
/// tree.
std::string to_text(const nlohmann::ordered_json& info);

} // namespace lineatlas::apps
