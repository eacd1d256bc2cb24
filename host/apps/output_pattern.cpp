#include "output_pattern.hpp"

#include <cctype>

#include <fmt/format.h>

#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

UsageError pattern_error(const std::string& text, const std::string& cause) {
    return UsageError(fmt::format("--output \"{}\" {}; write the frame's number as %d or, with "
                                  "leading zeros, as in frame.%04d.png",
                                  text, cause));
}

} // namespace

OutputPattern::OutputPattern(const std::string& text) {
    bool found = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            (found ? after_ : before_) += text[i];
            continue;
        }
        ++i;
        if (i < text.size() && text[i] == '%') {
            (found ? after_ : before_) += '%';
            continue;
        }
        const bool filled =
            i + 1 < text.size() && text[i] == '0' && text[i + 1] >= '1' && text[i + 1] <= '9';
        const std::size_t letter = filled ? i + 2 : i;
        if (letter >= text.size() || text[letter] != 'd') {
            throw pattern_error(text, fmt::format("has \"{}\"", text.substr(i - 1, 4)));
        }
        if (found) throw pattern_error(text, "has more than one place for a number");
        found = true;
        if (filled) digits_ = text[i + 1] - '0';
        i = letter;
    }
    if (!found) throw pattern_error(text, "is one file, and a sequence has many");
}

std::filesystem::path OutputPattern::path(int frame) const {
    return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

} // namespace lineatlas::apps
