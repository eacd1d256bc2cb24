#pragma once

#include <string>
#include <vector>

#include "command_line/cli_fwd.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::apps {

/// A command that draws the same again, without the camera: the name of the model or scene and
/// every given option of `draw` that changes the picture. One line. `sections`: the values for
/// --section. `deflection`: that with which exact surfaces were read; 0: there are none. `lines`:
/// the kinds drawn, to which a style may have added.
std::string describe_drawing(const CLI::App& app, const std::string& model,
                             const std::vector<std::string>& sections, double deflection,
                             LineKindMask lines);

} // namespace lineatlas::apps
