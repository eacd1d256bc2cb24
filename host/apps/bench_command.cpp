#include "commands.hpp"

#include <utility>

#include <CLI/App.hpp>

#include "command_line/sibling_program.hpp"

namespace lineatlas::apps {

Command setup_bench(CLI::App& app) {
    app.require_subcommand(1);
    app.footer("Each takes --help for its own options.");
    for (const auto& [name, description] :
         {std::pair{"frames", "Frame times of every method beside the paper's Table 1"},
          std::pair{"kernels", "Every kernel as a share of a copy's speed"},
          std::pair{"interop", "Handing buffers over between GL and OpenCL in each mode"},
          std::pair{"quality", "Visibility against exact ray casting"},
          std::pair{"compare", "Two builds by the figures of frames and kernels"},
          std::pair{"tune", "Measure launch parameters and print a row for kernels/tuning.toml"}}) {
        app.add_subcommand(name, description)->prefix_command()->set_help_flag();
    }
    return [&app] {
        const CLI::App* chosen = app.get_subcommands().front();
        run_sibling(
            "lineatlas-bench-" + chosen->get_name(), chosen->remaining(),
            "install the package lineatlas-bench; in a build of your own set LINEATLAS_BENCH");
    };
}

} // namespace lineatlas::apps
