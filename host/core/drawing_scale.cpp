#include "drawing_scale.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "base/numbers.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

std::string whole(double number) {
    return std::to_string(std::llround(number));
}

} // namespace

double parse_scale(std::string_view option, const std::string& text) {
    const auto in_range = [](const std::optional<double>& part) {
        return part && *part >= 1e-6 && *part <= 1e10;
    };
    std::string_view rest = text;
    const std::optional<double> drawn = take_number(rest);
    const bool goes_on = rest.starts_with(':');
    if (goes_on) rest.remove_prefix(1);
    const std::optional<double> real = take_number(rest);
    if (!in_range(drawn) || !goes_on || !in_range(real) || !rest.empty())
        throw UsageError(std::string{option} + " \"" + text +
                         "\" must be two numbers with a colon, as in 1:50");
    return *drawn / *real;
}

std::string standard_scale(double largest) {
    constexpr std::array steps{1, 2, 5};
    for (int power = 6; power >= 0; --power) {
        for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
            const double larger = *step * std::pow(10, power);
            if (larger <= largest) return whole(larger) + ":1";
        }
    }
    for (int power = 0; power <= 9; ++power) {
        for (const int step : steps) {
            const double smaller = step * std::pow(10, power);
            if (1 / smaller <= largest) return "1:" + whole(smaller);
        }
    }
    return {};
}

std::string enlarging_scale(double smallest) {
    constexpr double rounding = 1 + 1e-9;
    const std::string inverse = standard_scale(rounding / smallest); // the series is its own
    const std::size_t colon = inverse.find(':');
    if (colon == std::string::npos) return {};
    return inverse.substr(colon + 1).append(":").append(inverse, 0, colon);
}

} // namespace lineatlas
