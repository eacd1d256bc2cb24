#pragma once

#include <string_view>

namespace lineatlas {

/// True if a name matches a pattern: `*` stands for any letters, `?` for one, `[a-c_]` for one of
/// these, `[!a-c_]` for any other, and a letter behind `\` for itself. Both are UTF-8. A byte that
/// is no UTF-8 counts as a letter.
bool matches(std::string_view pattern, std::string_view name);

/// True if a pattern matches one name of a part's path, or several names that follow each other in
/// it. So it may name the part or something that the part is in. In "robot/arm/Bolt 2" both "Bolt*"
/// and "arm/Bolt*" match.
bool names_part(std::string_view pattern, std::string_view path);

} // namespace lineatlas
