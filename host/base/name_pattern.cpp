#include "name_pattern.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace lineatlas {

namespace {

/// The first letter of a text, as its bytes.
std::string_view first_letter(std::string_view text) {
    const auto continues = [&](std::size_t i) {
        return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
    };
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t size = lead >= 0xF0U ? 4 : lead >= 0xE0U ? 3 : lead >= 0xC0U ? 2 : 1;
    for (std::size_t i = 1; i < size; ++i)
        if (!continues(i)) return text.substr(0, 1);
    return text.substr(0, size);
}

std::string_view take_letter(std::string_view& text) {
    const std::string_view letter = first_letter(text);
    text.remove_prefix(letter.size());
    return letter;
}

/// Takes a letter off a pattern, without the `\` before it.
std::string_view take_literal(std::string_view& pattern) {
    if (pattern.size() > 1 && pattern.front() == '\\') pattern.remove_prefix(1);
    return take_letter(pattern);
}

/// Takes `[...]` off the pattern and says whether the letter is in it. Returns nothing if there is
/// no `]`; then `[` is a letter as any other. Letters of UTF-8 are in the order of their bytes.
std::optional<bool> take_set(std::string_view& pattern, std::string_view letter) {
    std::string_view rest = pattern.substr(1);
    const bool others = rest.starts_with('!') || rest.starts_with('^');
    if (others) rest.remove_prefix(1);
    bool found = false, first = true;
    while (!rest.empty() && (first || rest.front() != ']')) {
        first = false;
        const std::string_view low = take_literal(rest);
        std::string_view high = low;
        if (rest.size() > 1 && rest[0] == '-' && rest[1] != ']') {
            rest.remove_prefix(1);
            high = take_literal(rest);
        }
        found = found || (low <= letter && letter <= high);
    }
    if (rest.empty()) return std::nullopt;
    pattern = rest.substr(1);
    return found != others;
}

/// Takes one letter off the name, and the part of the pattern that stands for it off the pattern.
/// False if they do not match.
bool take_match(std::string_view& pattern, std::string_view& name) {
    if (pattern.empty() || name.empty()) return false;
    const std::string_view letter = take_letter(name);
    if (pattern.front() == '?') {
        pattern.remove_prefix(1);
        return true;
    }
    if (pattern.front() == '[')
        if (const std::optional<bool> in_set = take_set(pattern, letter)) return *in_set;
    return take_literal(pattern) == letter;
}

} // namespace

bool matches(std::string_view pattern, std::string_view name) {
    // Only the last star has to be tried with more letters. Stars before it may stand for as few
    // letters as were found.
    std::optional<std::string_view> behind_star;
    std::string_view name_at_star;
    while (true) {
        if (pattern.starts_with('*')) {
            pattern.remove_prefix(1);
            behind_star = pattern;
            name_at_star = name;
        } else if (pattern.empty() && name.empty()) {
            return true;
        } else if (!take_match(pattern, name)) {
            if (!behind_star || name_at_star.empty()) return false;
            take_letter(name_at_star);
            pattern = *behind_star;
            name = name_at_star;
        }
    }
}

bool names_part(std::string_view pattern, std::string_view path) {
    for (std::size_t begin = 0; begin <= path.size();) {
        for (std::size_t end = begin; end <= path.size(); ++end) {
            end = std::min(path.find('/', end), path.size());
            if (matches(pattern, path.substr(begin, end - begin))) return true;
        }
        begin = std::min(path.find('/', begin), path.size()) + 1;
    }
    return false;
}

} // namespace lineatlas
