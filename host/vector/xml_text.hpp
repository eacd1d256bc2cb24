#pragma once

#include <string>
#include <string_view>

namespace lineatlas {

/// Text from files and command lines as XML 1.0 may hold it: what is no UTF-8 becomes "?", control
/// characters become blanks.
std::string xml_text(std::string_view text);

} // namespace lineatlas
