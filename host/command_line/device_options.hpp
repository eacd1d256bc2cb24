#pragma once

#include <string>

#include "cli_fwd.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// Declares --compute, --device and --interop. `options` must outlive `app`.
void declare_device(CLI::App& app, DeviceOptions& options, const std::string& group = "Device");

} // namespace lineatlas
