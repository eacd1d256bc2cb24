// lineatlas-view: the viewer. `lineatlas view` runs it.

#include <cstdio>
#include <cstdlib>
#include <optional>

#include <CLI/App.hpp>
#include <fmt/ranges.h> // fmt::join

#include "application.hpp"
#include "command_line/device_options.hpp"
#include "command_line/program.hpp"
#include "command_line/read_options.hpp"
#include "command_line/style_options.hpp"
#include "command_line/values.hpp"
#include "compute/opencl/devices.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/scenes.hpp"

namespace {

using namespace lineatlas;

struct Arguments {
    std::vector<std::filesystem::path> models;
    std::string scene, style, camera, up = "auto", theme = "auto";
    std::string size = "1280x800";
    viewer::ApplicationOptions options;
    ReadOptions read;
};

void declare(CLI::App& app, Arguments& a) {
    app.add_option("MODEL", a.models,
                   "Files that `draw` takes, sessions too; several stand side by side; default an "
                   "empty window");
    app.add_option(
        "--scene", a.scene,
        fmt::format("A built-in scene in place of MODEL: {}", fmt::join(scene_names(), ", ")));
    app.add_option("--style", a.style, "Name of a style, or a TOML file");
    app.add_option("--camera", a.camera, "A camera to begin with: JSON, as the viewer saves it");
    app.add_option("--up", a.up,
                   "Upward axis of the model: x, y, z or X,Y,Z; auto guesses from its shape");
    app.add_option("--size", a.size, "Size of the window")->capture_default_str();
    declare_device(app, a.options.device);
    app.add_option("--ui-scale", a.options.scale,
                   "Size of letters and panels, 1 to 4; default as the display wants it")
        ->check(CLI::Range(0.5, 4.0));
    app.add_option("--theme", a.theme,
                   "Colours of panels: light, dark, or auto as the desktop says")
        ->check(CLI::IsMember({"auto", "light", "dark"}));
    a.read.declare(app);
    app.footer("F1 shows the keys. Models, styles and cameras can be dropped onto the window.");
}

/// Returns the exit code.
int view(Arguments& arguments, ImageWriter& writer) {
    arguments.read.check();
    arguments.options.size = parse_size("--size", arguments.size);
    if (arguments.theme != "auto") {
        arguments.options.theme =
            arguments.theme == "dark" ? viewer::Theme::dark : viewer::Theme::light;
    }
    viewer::Application application{arguments.options, writer};
    viewer::Session& session = application.session();
    session.recent = viewer::RecentFiles{viewer::recent_files_store()};
    std::error_code failure; // then the panel says "."
    const std::filesystem::path here = std::filesystem::current_path(failure);
    if (!failure) application.ui().folder = here.string();
    session.read_limits = arguments.read.limits();
    if (arguments.up != "auto") session.up = parse_up("--up", arguments.up);
    if (!arguments.style.empty()) session.use_style(arguments.style);
    if (!arguments.camera.empty()) session.open_first_camera(arguments.camera);
    if (!arguments.models.empty())
        session.open(arguments.models);
    else if (!arguments.scene.empty())
        session.open_scene(arguments.scene);
    application.run();
    const std::vector<std::string> failures = session.finish_saving(); // nobody sees the window
    for (const std::string& failure : failures)
        print_error(fmt::format("lineatlas: {}\n", failure));
    return failures.empty() ? 0 : 1;
}

int run(int argc, char** argv) {
    CLI::App app{"lineatlas view: look at a model in a window", "lineatlas view"};
    Arguments arguments;
    declare(app, arguments);
    if (const std::optional<int> code = parse(app, argc, argv)) return *code;
    if (!arguments.models.empty() && !arguments.scene.empty()) {
        throw UsageError("name either a MODEL file or a --scene");
    }
    int code = 0;
    {
        ImageWriter writer; // made before anything starts a thread
        code = view(arguments, writer);
    }
    // A cancelled reader cannot be stopped. The program ends without waiting for it.
    if (viewer::Loader::any_thread()) {
        std::fflush(nullptr);
        std::_Exit(code);
    }
    return code;
}

} // namespace

int main(int argc, char** argv) {
    lineatlas::compute::mistrust_drivers();
    return lineatlas::run_program(argc, argv, run);
}
