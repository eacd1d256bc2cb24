#include "program.hpp"

#include <cstdio>
#include <exception>
#include <new>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "io/isolated.hpp"
#include "lineatlas/error.hpp"
#include "stop_signal.hpp"

namespace lineatlas::apps {
namespace {

constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

int fail(int code, const char* message) {
    fmt::print(stderr, "lineatlas: {}\n", message);
    return code;
}

} // namespace

std::optional<int> parse(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        return {};
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help
        fmt::print(stderr, "lineatlas: {}\nRun with --help for more.\n", error.what());
        return exit_usage;
    }
}

int run_program(int argc, char** argv, int (*run)(int argc, char** argv)) {
    if (const std::optional<int> code = serve_as_reader(argc, argv)) return *code;
    try {
        return run(argc, argv);
    } catch (const UsageError& error) {
        return fail(exit_usage, error.what());
    } catch (const Stopped& stopped) {
        return fail(stopped.exit_code(), stopped.what());
    } catch (const std::bad_alloc&) {
        return fail(exit_failed, "the host has not enough memory for this model or picture");
    } catch (const std::exception& error) {
        return fail(exit_failed, error.what());
    }
}

} // namespace lineatlas::apps
