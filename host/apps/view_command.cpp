#include "commands.hpp"

#include "lineatlas/error.hpp"
#include "neighbour.hpp"

namespace lineatlas::apps {

Command setup_view(CLI::App& app) {
    app.prefix_command()->set_help_flag();
    return [&app] {
        run_neighbour(
            "lineatlas-view", app.remaining(),
            "the viewer is built where GLFW and Dear ImGui are found: install libglfw3-dev "
            "and libimgui-dev, and build again");
    };
}

} // namespace lineatlas::apps
