#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lineatlas {

// Text for people: messages and other output. Names in files may hold any bytes, and some bytes are
// commands to a terminal.

/// Longest message, in bytes.
inline constexpr std::size_t longest_message = 2000;

/// `text` as one line. Every control character (ESC, C1 and DEL among them), every mark that turns
/// the direction of writing and every byte that is no UTF-8 becomes "?". Text of more than `most`
/// bytes is cut between two letters and ends in "...".
std::string printable(std::string_view text, std::size_t most);

/// A word out of a file, short enough to stand in a message.
std::string printable(std::string_view word);

/// As printable(), for text of several lines: line feeds and tabulators stay.
std::string printable_lines(std::string_view text);

} // namespace lineatlas
