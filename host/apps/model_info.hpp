#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "lineatlas/io.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::apps {

/// The output of `lineatlas info` for a model as a JSON object; docs/input.md has its members.
/// `lines`: the lines of its mesh.
nlohmann::ordered_json describe_model(const std::string& file, const LoadedMesh& loaded,
                                      const LineSet& lines);

/// Per triangle of the mesh the number of its part in the parts list and on balloons. Numbers count
/// from 1 in the order of the parts. All instances of a shape have one number.
std::vector<std::uint32_t> item_numbers(const LoadedMesh& loaded);

/// The result of describe_model() as text for people: a line for the file, and a line for each part
/// of its tree.
std::string to_text(const nlohmann::ordered_json& info);

} // namespace lineatlas::apps
