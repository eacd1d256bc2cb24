#pragma once

#include <string>
#include <string_view>

namespace lineatlas {

/// Text from files and command lines in the characters of XML 1.0: bytes that are no UTF-8 become
/// "?", control characters become blanks.
std::string xml_text(std::string_view text);

} // namespace lineatlas
