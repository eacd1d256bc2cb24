#pragma once

#include <optional>
#include <string_view>

#include "cli_fwd.hpp"

namespace lineatlas {

/// Reads the command line. Returns an exit code if the program should end now: 0 after --help, 2
/// after a mistake, which has been printed.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// The body of main() for every program; `name` begins its lines on stderr. A process that was
/// started as a reader of files (io/isolated.hpp) reads. Any other calls `run`, whose result is the
/// exit code. An exception becomes a line on stderr and exit code 1 or 2, and so does output that
/// could not be written.
int run_program(int argc, char** argv, int (*run)(int argc, char** argv),
                std::string_view name = "lineatlas");

} // namespace lineatlas
