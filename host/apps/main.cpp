#include <cstdio>
#include <exception>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "commands.hpp"
#include "lineatlas/error.hpp"

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
               "  lineatlas devices\n"
               "`lineatlas COMMAND --help` explains each command.");
    CLI::App* draw = app.add_subcommand("draw", "Draw a model to a picture");
    CLI::App* devices =
        app.add_subcommand("devices", "List OpenCL devices and how they share buffers with GL");
    const auto run_draw = lineatlas::apps::setup_draw(*draw);
    const auto run_devices = lineatlas::apps::setup_devices(*devices);
    const std::string first = argc > 1 ? argv[1] : "";
    if (!first.empty() && first[0] != '-' && first != draw->get_name() &&
        first != devices->get_name()) {
        throw lineatlas::UsageError(fmt::format("there is no command \"{}\"; there is {}, {}",
                                                first, draw->get_name(), devices->get_name()));
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help
        fmt::print(stderr, "lineatlas: {}\nRun with --help for more.\n", error.what());
        return exit_usage;
    }
    if (draw->parsed()) run_draw();
    if (devices->parsed()) run_devices();
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const lineatlas::UsageError& error) {
        fmt::print(stderr, "lineatlas: {}\n", error.what());
        return exit_usage;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "lineatlas: the host has not enough memory for this model or picture\n");
        return exit_failed;
    } catch (const std::exception& error) {
        fmt::print(stderr, "lineatlas: {}\n", error.what());
        return exit_failed;
    }
}
