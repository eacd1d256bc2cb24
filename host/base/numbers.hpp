#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace lineatlas {

// Numbers in text, in C's notation whatever the locale is.

/// Cuts the number off that a text starts with, and returns it. Returns nothing if the text starts
/// with no number, or with one that the type does not hold.
template <class Number = double>
std::optional<Number> take_number(std::string_view& text) {
    Number value{};
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
    return value;
}

/// A whole text as a number, perhaps with a plus before it; nothing if anything else stands in it.
template <class Number = double>
std::optional<Number> number_from(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const std::optional<Number> value = take_number<Number>(text);
    return text.empty() ? value : std::nullopt;
}

} // namespace lineatlas
