#pragma once

#include <functional>
#include <string_view>

// Standard output and error of a program, which may be closed, full, or a pipe without a reader.
namespace lineatlas {

/// First of all in main(): opens what is closed of standard input, output and error, so that no
/// file of the program's own takes its number; what is written there still fails. Writing to a pipe
/// that nobody reads fails, too, and does not end the program.
void open_standard_streams();

/// Writes lines to standard output as printable_lines() has them. Throws std::system_error.
void print_output(std::string_view text);

/// Writes to standard error, as printable_lines() has it, what can be written there: nothing else
/// depends on it.
void print_error(std::string_view text) noexcept;

/// Empties the line of a terminal that standard error stands in.
void clear_error_line() noexcept;

/// Runs a program and writes out what it printed on standard output, which is part of what was
/// asked for. Returns what `run` returns; throws what it throws, and FileError unless all of its
/// output went there. Only a pipe that nobody reads ends this process as it ends every other, by
/// SIGPIPE.
int run_with_output(const std::function<int()>& run);

} // namespace lineatlas
