#pragma once

#include <string_view>

namespace lineatlas {

/// True if a name matches a pattern: `*` stands for any letters, `?` for one, `[a-c_]` for one of
/// these, `[!a-c_]` for any other, and a letter behind `\` for itself. Both are UTF-8. A byte that
/// is no UTF-8 counts as a letter.
bool matches(std::string_view pattern, std::string_view name);

/// Whether a pattern stands for a part or for something that it is in: for one name or several
/// that follow each other in its path, as "Bolt*" and "arm/Bolt" do in "robot/arm/Bolt 2".
bool names_part(std::string_view pattern, std::string_view path);

} // namespace lineatlas
