#pragma once

#include <string_view>

namespace lineatlas {

// Lines and words of OBJ and MTL files.

/// Cuts a line off `text` with its end, which may be LF, CRLF or CR, and returns it without.
std::string_view take_line(std::string_view& text);

/// Cuts the next word off `line` with the blanks before it; empty where there is none.
std::string_view take_word(std::string_view& line);

/// Without blanks at either end.
std::string_view trimmed(std::string_view text);

} // namespace lineatlas
