#pragma once

#include <optional>

#include <CLI/App.hpp>

namespace lineatlas::apps {

/// Reads the command line. An exit code where the program has nothing more to do: after --help, or
/// after a mistake, which has been said then.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// What main() is for both programs: this process may be a reader of files (io/isolated.hpp), and
/// an exception of `run` becomes a line on stderr and an exit code.
int run_program(int argc, char** argv, int (*run)(int argc, char** argv));

} // namespace lineatlas::apps
