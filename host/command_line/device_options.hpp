#pragma once

#include <string>

#include <CLI/App.hpp>

#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// --compute, --device and --interop. `options` lives as long as `app`.
void declare_device(CLI::App& app, DeviceOptions& options, const std::string& group = "Device");

} // namespace lineatlas
