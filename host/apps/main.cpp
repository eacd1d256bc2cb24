#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/core.h>
#include <fmt/ranges.h> // fmt::join

#include "command_line/program.hpp"
#include "commands.hpp"
#include "compute/opencl/devices.hpp"
#include "lineatlas/error.hpp"
#include "version.hpp"

namespace {

int run(int argc, char** argv) {
    CLI::App app{"lineatlas: high-quality line drawings of 3D models"};
    app.require_subcommand(1);
    app.set_version_flag("--version", lineatlas::apps::version);
    app.footer("Examples:\n"
               "  lineatlas draw model.obj -o picture.png\n"
               "  lineatlas draw part.stl -o part.png --up z --lines crease,silhouette --width 3\n"
               "  lineatlas draw --scene ship -o ship.png --stats\n"
               "  lineatlas draw model.obj -o sketch.png --style pencil\n"
               "  lineatlas draw model.obj -o turn.%04d.png --turntable 120\n"
               "  lineatlas view model.obj\n"
               "  lineatlas check drawing.svg model.obj\n"
               "  lineatlas info assembly.step\n"
               "  lineatlas styles\n"
               "  lineatlas devices\n"
               "  lineatlas kernels project_clip\n"
               "  lineatlas bench frames --scenes clevis\n"
               "`lineatlas COMMAND --help` explains each command.");
    using lineatlas::apps::Command;
    std::vector<std::pair<CLI::App*, Command>> commands;
    const auto add = [&](const char* name, const char* description, Command (*setup)(CLI::App&)) {
        CLI::App* command = app.add_subcommand(name, description);
        commands.emplace_back(command, setup(*command));
    };
    add("draw", "Draw a model to a picture", lineatlas::apps::setup_draw);
    add("view", "Look at a model in a window", lineatlas::apps::setup_view);
    add("check", "Check a drawing as paths by rays", lineatlas::apps::setup_check);
    add("info", "Say what is in a model: parts, edges, unit, box", lineatlas::apps::setup_info);
    add("styles", "List styles and pens, or print a style", lineatlas::apps::setup_styles);
    add("devices", "List OpenCL devices and how they share buffers with GL",
        lineatlas::apps::setup_devices);
    add("kernels", "List kernels, or print one with its tables", lineatlas::apps::setup_kernels);
    add("scene", "Write a built-in scene as OBJ", lineatlas::apps::setup_scene);
    add("bench", "Measure frames, kernels, hand-overs or quality", lineatlas::apps::setup_bench);
    const std::string first = argc > 1 ? argv[1] : "";
    const auto is_first = [&](const auto& command) { return command.first->get_name() == first; };
    if (!first.empty() && first[0] != '-' && std::ranges::none_of(commands, is_first)) {
        std::vector<std::string> names;
        for (const auto& command : commands) names.push_back(command.first->get_name());
        throw lineatlas::UsageError(
            fmt::format("there is no command \"{}\"; there is {}", first, fmt::join(names, ", ")));
    }
    if (const std::optional<int> code = lineatlas::parse(app, argc, argv)) return *code;
    for (const auto& [command, run_command] : commands) {
        if (command->parsed()) run_command();
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    lineatlas::compute::mistrust_drivers();
    return lineatlas::run_program(argc, argv, run);
}
