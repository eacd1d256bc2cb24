#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "commands.hpp"
#include "io/isolated.hpp"
#include "lineatlas/error.hpp"
#include "stop_signal.hpp"

namespace {

constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

int run(int argc, char** argv) {
    CLI::App app{"lineatlas: high-quality line drawings of 3D models"};
    app.require_subcommand(1);
    app.footer("Examples:\n"
               "  lineatlas draw model.obj -o picture.png\n"
               "  lineatlas draw part.stl -o part.png --up z --lines crease,silhouette --width 3\n"
               "  lineatlas draw --scene ship -o ship.png --stats\n"
               "  lineatlas draw model.obj -o sketch.png --style pencil\n"
               "  lineatlas draw model.obj -o turn.%04d.png --turntable 120\n"
               "  lineatlas view model.obj\n"
               "  lineatlas styles\n"
               "  lineatlas devices\n"
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
    add("styles", "List styles and pens, or print a style", lineatlas::apps::setup_styles);
    add("devices", "List OpenCL devices and how they share buffers with GL",
        lineatlas::apps::setup_devices);
    add("bench", "Measure frames, kernels, hand-overs or quality", lineatlas::apps::setup_bench);
    const std::string first = argc > 1 ? argv[1] : "";
    const auto is_first = [&](const auto& command) { return command.first->get_name() == first; };
    if (!first.empty() && first[0] != '-' && std::ranges::none_of(commands, is_first)) {
        throw lineatlas::UsageError(fmt::format(
            "there is no command \"{}\"; there is draw, view, styles, devices, bench", first));
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help
        fmt::print(stderr, "lineatlas: {}\nRun with --help for more.\n", error.what());
        return exit_usage;
    }
    for (const auto& [command, run_command] : commands) {
        if (command->parsed()) run_command();
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    if (const std::optional<int> code = lineatlas::serve_as_reader(argc, argv)) return *code;
    try {
        return run(argc, argv);
    } catch (const lineatlas::UsageError& error) {
        fmt::print(stderr, "lineatlas: {}\n", error.what());
        return exit_usage;
    } catch (const lineatlas::apps::Stopped& stopped) {
        fmt::print(stderr, "lineatlas: {}\n", stopped.what());
        return stopped.exit_code();
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "lineatlas: the host has not enough memory for this model or picture\n");
        return exit_failed;
    } catch (const std::exception& error) {
        fmt::print(stderr, "lineatlas: {}\n", error.what());
        return exit_failed;
    }
}
