#pragma once

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace lineatlas::test {

/// The words of the line that begins with `first`.
inline std::vector<std::string> words_of(const std::string& text, const std::string& first) {
    std::istringstream lines{text};
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(first)) continue;
        std::istringstream words{line};
        return {std::istream_iterator<std::string>{words}, {}};
    }
    return {};
}

} // namespace lineatlas::test
