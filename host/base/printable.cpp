#include "printable.hpp"

#include <cstdint>

namespace lineatlas {
namespace {

/// The letter that a text begins with.
struct Letter {
    std::size_t size = 1; ///< bytes
    bool plain = false;   ///< shows as itself and does nothing else
};

bool is_plain(std::uint32_t code) {
    if (code < 0x20 || (code >= 0x7F && code < 0xA0)) return false; // C0, DEL, C1
    const bool turns = code == 0x061C || code == 0x200E || code == 0x200F ||
                       (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
    const bool ends_line = code == 0x2028 || code == 0x2029;
    return !turns && !ends_line;
}

/// UTF-8 by RFC 3629: no letter in more bytes than it needs, no half of a surrogate pair.
Letter first_letter(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80) return {1, is_plain(lead)};
    const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return {};
    std::uint32_t code = lead & (0x7FU >> size);
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return {};
        code = code << 6U | (byte(i) & 0x3FU);
    }
    const bool too_long = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
    if (too_long || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {};
    return {size, is_plain(code)};
}

std::string masked(std::string_view text, std::string_view allowed, std::size_t most) {
    std::string result;
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        if (result.size() + letter.size > most) return result + "...";
        if (letter.plain || allowed.find(text.front()) != allowed.npos)
            result += text.substr(0, letter.size);
        else
            result += '?';
        text.remove_prefix(letter.size);
    }
    return result;
}

} // namespace

std::string printable(std::string_view text, std::size_t most) {
    return masked(text, "", most);
}

std::string printable(std::string_view word) {
    constexpr std::size_t longest_word = 40;
    return printable(word, longest_word);
}

std::string printable_lines(std::string_view text) {
    return masked(text, "\n\t", std::string_view::npos);
}

} // namespace lineatlas
