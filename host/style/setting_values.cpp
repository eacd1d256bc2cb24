#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "base/numbers.hpp"
#include "setting.hpp"

namespace lineatlas {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::optional<double> number_from_text(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return number_from(text);
}

std::string toml_string(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            result += c;
        }
    }
    return result + '"';
}

} // namespace

UsageError wrong_key(std::string_view key, const std::vector<std::string>& keys,
                     std::string_view listed_by) {
    std::string near = suggestion(key, keys);
    if (near.empty()) near = fmt::format("; {} lists what there is", listed_by);
    return UsageError(fmt::format("there is no setting {}{}", toml_string(key), near));
}

UsageError wrong_value(std::string_view called, std::string_view values,
                       const std::vector<std::string>& names, const SettingValue& value) {
    const auto* word = std::get_if<std::string>(&value);
    return UsageError(fmt::format("{} must be {}, not {}{}", called, values, value_to_toml(value),
                                  word != nullptr ? suggestion(*word, names) : ""));
}

SettingValue value_from_text(std::string_view text) {
    if (text == "true" || text == "false") return text == "true";
    const auto enclosed = [&](char open, char close) {
        return text.size() >= 2 && text.front() == open && text.back() == close;
    };
    if (enclosed('"', '"')) return std::string{text.substr(1, text.size() - 2)};
    const bool list = enclosed('[', ']');
    if (list) text = text.substr(1, text.size() - 2);
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto value = number_from_text(text.substr(begin, end - begin));
        if (!value) return std::string{text};
        numbers.push_back(*value);
        begin = end + 1;
    }
    if (numbers.size() == 1 && !list) return numbers[0];
    return numbers;
}

std::string value_to_toml(const SettingValue& value) {
    // Most members are floats: 0.1, not 0.10000000149011612.
    const auto number = [](double v) {
        const auto narrowed = static_cast<float>(v);
        const bool is_float = static_cast<double>(narrowed) == v;
        return is_float ? fmt::format("{}", narrowed) : fmt::format("{}", v);
    };
    if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const double* one = std::get_if<double>(&value)) return number(*one);
    if (const auto* text = std::get_if<std::string>(&value)) return toml_string(*text);
    std::vector<std::string> numbers;
    for (const double v : std::get<std::vector<double>>(value)) numbers.push_back(number(v));
    return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string settings_table_row(std::string_view key, std::string_view help,
                               const SettingValue& value, std::string_view values) {
    return fmt::format("| `{}` | {} | `{}` | {} |\n", key, help, value_to_toml(value), values);
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
    if (known.empty()) return {};
    const auto distance = [&](const std::string& name) { return edit_distance(word, name); };
    const std::string& nearest = *std::ranges::min_element(known, {}, distance);
    // A word farther away is another word.
    if (distance(nearest) > std::max<std::size_t>(2, nearest.size() / 2)) return {};
    return fmt::format("; did you mean \"{}\"?", nearest);
}

} // namespace lineatlas
