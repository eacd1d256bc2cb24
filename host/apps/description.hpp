#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "lineatlas/lines.hpp"

namespace lineatlas::apps {

/// What was drawn, as a command that draws it again but for the camera: the name of the model or
/// scene and every option of `draw` that was given and changes the picture. One line. `sections`:
/// what stands for --section. `deflection`: that exact surfaces were read with; 0: there are none.
/// `lines`: the kinds drawn; a style may add to the usual ones.
std::string describe_drawing(const CLI::App& app, const std::string& model,
                             const std::vector<std::string>& sections, double deflection,
                             LineKindMask lines);

} // namespace lineatlas::apps
