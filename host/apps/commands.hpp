#pragma once

#include <functional>
#include <memory>

#include "command_line/cli_fwd.hpp"

namespace lineatlas::apps {

/// A subcommand of the tool. setup_NAME() declares its options on `app` and returns the function
/// that runs it, which throws Error.
using Command = std::function<void()>;

Command setup_draw(CLI::App& app);    ///< lineatlas draw
Command setup_styles(CLI::App& app);  ///< lineatlas styles
Command setup_devices(CLI::App& app); ///< lineatlas devices
Command setup_kernels(CLI::App& app); ///< lineatlas kernels
Command setup_bench(CLI::App& app);   ///< lineatlas bench
Command setup_view(CLI::App& app);    ///< lineatlas view
Command setup_check(CLI::App& app);   ///< lineatlas check
Command setup_info(CLI::App& app);    ///< lineatlas info
Command setup_scene(CLI::App& app);   ///< lineatlas scene

} // namespace lineatlas::apps
