#pragma once

#include <string>
#include <string_view>

namespace lineatlas::models {

/// A name from a file as one line of text; `otherwise` if nothing of the name can be shown.
inline std::string part_name(std::string_view name, std::string_view otherwise) {
    std::string text(name);
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = ' ';
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string::npos) return std::string(otherwise);
    return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

} // namespace lineatlas::models
