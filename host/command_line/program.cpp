#include "program.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "io/isolated.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/error.hpp"
#include "stop_signal.hpp"
#include "style/member_names.hpp"

namespace lineatlas {
namespace {

constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

/// The program's name, which begins its lines on stderr.
std::string_view name = "lineatlas";

int fail(int code, const char* message) {
    print_error(fmt::format("{}: {}\n", name, in_words_of_the_tool(message)));
    return code;
}

/// Throws for empty values: they come from variables of scripts that were not set.
void refuse_empty_values(const CLI::App& app) {
    for (const CLI::App* command : app.get_subcommands()) refuse_empty_values(*command);
    for (const CLI::Option* option : app.get_options()) {
        const std::vector<std::string>& values = option->results();
        if (std::ranges::find(values, "") == values.end()) continue;
        throw CLI::ValidationError{option->get_name(),
                                   "has an empty value; give it one or leave it out"};
    }
}

} // namespace

std::optional<int> parse(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        refuse_empty_values(app);
        return {};
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help
        print_error(fmt::format("{}: {}\nRun with --help for more.\n", name, error.what()));
        return exit_usage;
    }
}

int run_program(int argc, char** argv, int (*run)(int argc, char** argv),
                std::string_view program_name) {
    name = program_name;
    open_standard_streams();
    if (const std::optional<int> code = serve_as_reader(argc, argv)) return *code;
    try {
        return run_with_output([&] { return run(argc, argv); });
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

} // namespace lineatlas
