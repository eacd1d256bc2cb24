#pragma once

#include <functional>
#include <string_view>

// Standard output and error of a program, which may be closed, full, or a pipe without a reader.
namespace lineatlas {

/// Call first in main(). Opens standard input, output and error if they are closed, so that no
/// other file takes their numbers. Writing there still fails. Writing to a pipe that nobody reads
/// fails too, and does not end the program.
void open_standard_streams();

/// Writes lines to standard output, as printable_lines() returns them. Throws std::system_error.
void print_output(std::string_view text);

/// Writes lines to standard error, as printable_lines() returns them. Ignores errors, because
/// nothing depends on that output.
void print_error(std::string_view text) noexcept;

/// Clears the current line if standard error is a terminal.
void clear_error_line() noexcept;

/// Runs a program and flushes standard output, which is part of its result. Returns what `run`
/// returns and throws what it throws. Throws FileError unless all output was written. A pipe that
/// nobody reads ends this process by SIGPIPE, as it ends others.
int run_with_output(const std::function<int()>& run);

} // namespace lineatlas
