#include "commands.hpp"

#include <CLI/App.hpp>

#include "command_line/sibling_program.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {

Command setup_view(CLI::App& app) {
    app.prefix_command()->set_help_flag();
    return [&app] {
        run_sibling("lineatlas-view", app.remaining(),
                    "install the package lineatlas-viewer; in a build of your own libglfw3-dev and "
                    "libimgui-dev, and build again");
    };
}

} // namespace lineatlas::apps
