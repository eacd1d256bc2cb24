#pragma once

#include <charconv>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/numbers.hpp"

namespace lineatlas {

/// The whole token as a number. `nan` and `inf` count as numbers, and a number that is too large
/// becomes infinite.
inline std::optional<double> parse_number(std::string_view token) {
    if (token.starts_with('+')) token.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (end != token.data() + token.size() || error == std::errc::invalid_argument) return {};
    if (error == std::errc::result_out_of_range) {
        const bool tiny = token.find("e-") != token.npos || token.find("E-") != token.npos;
        return tiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    return value;
}

inline std::optional<long long> parse_integer(std::string_view token) {
    return number_from<long long>(token);
}

/// Walks the tokens of a text with LF, CRLF or CR line ends, and knows the current line.
class TextCursor {
  public:
    /// `comment` starts a comment that reaches to the end of its line; 0 for none.
    explicit TextCursor(std::string_view text, char comment = 0, std::size_t first_line = 1)
        : text_(text), line_(first_line), comment_(comment) {}

    /// The next token on this line or a later one; empty at the end of the text.
    std::string_view next() {
        while (at_ < text_.size()) {
            if (const std::string_view token = next_on_line(); !token.empty()) return token;
            skip_line();
        }
        return {};
    }

    /// The next token on this line; empty when the line has no more.
    std::string_view next_on_line() {
        while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
        const std::size_t begin = at_;
        while (at_ < text_.size() && !is_gap(text_[at_]) && text_[at_] != comment_) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    void skip_line() {
        while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
        if (at_ == text_.size()) return;
        if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
        ++at_;
        ++line_;
    }

    std::size_t line() const { return line_; }
    std::size_t bytes_left() const { return text_.size() - at_; }

  private:
    // A NUL never starts a comment, although `comment` is 0 if there is no comment sign.
    static bool is_blank(char c) {
        return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0';
    }
    static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
    static bool is_gap(char c) {
        return static_cast<unsigned char>(c) <= ' ' && (is_blank(c) || is_line_end(c));
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_;
    char comment_;
};

} // namespace lineatlas
