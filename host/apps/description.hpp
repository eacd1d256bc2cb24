#pragma once

#include <string>

#include <CLI/App.hpp>

namespace lineatlas::apps {

/// What was drawn, as a command that draws it again but for the camera: the name of the model or
/// scene and every option of `draw` that was given and changes the picture. One line.
std::string describe_drawing(const CLI::App& app, const std::string& model);

} // namespace lineatlas::apps
