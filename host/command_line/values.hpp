#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "lineatlas/lines.hpp"

// Values on the command line. Each parser throws UsageError that names `option`.
namespace lineatlas {

glm::ivec2 parse_size(std::string_view option, const std::string& text);  ///< "1024x768"
glm::vec3 parse_vector(std::string_view option, const std::string& text); ///< "1,-2.5,3"
glm::dvec3 parse_point(std::string_view option, const std::string& text); ///< in double precision
glm::vec3 parse_up(std::string_view option, const std::string& text); ///< "x", "y", "z" or a vector
/// Numbers of frames from `first` to `last`: "7", "0-99", "0-99x5", "3-" and "3-x5" (to the end;
/// numbers that the sequence lacks are left out), or several of these separated by commas. Each
/// once, in the order written.
std::vector<int> parse_frames(std::string_view option, const std::string& text, int first,
                              int last);

/// LineOptions::crease, from degrees or "auto".
std::optional<float> parse_crease(std::string_view option, const std::string& text);

/// The parts of `text` between separators.
std::vector<std::string> split(const std::string& text, char separator);

} // namespace lineatlas
