#include "values.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

struct FrameRange {
    int first;
    std::optional<int> last; ///< nothing: to the end of the sequence
    int step;
};

/// "7", "0-99", "0-99x5", "3-" or "3-x5"; nothing if it is none of them.
std::optional<FrameRange> parse_frame_range(const std::string& text) {
    const std::size_t dash = text.find('-');
    const std::size_t cross = text.find('x');
    const auto number = [&](std::size_t begin, std::size_t end) {
        return number_from<int>(std::string_view{text}.substr(begin, end - begin));
    };
    const std::optional<int> first = number(0, dash);
    if (!first || *first < 0) return std::nullopt;
    if (dash == std::string::npos) return FrameRange{*first, *first, 1};
    const std::optional<int> step = cross == std::string::npos ? 1 : number(cross + 1, text.size());
    if (!step || *step < 1) return std::nullopt;
    const bool open = dash + 1 == std::min(cross, text.size());
    if (open) return FrameRange{*first, std::nullopt, *step};
    const std::optional<int> last = number(dash + 1, cross);
    if (!last || *last < *first) return std::nullopt;
    return FrameRange{*first, last, *step};
}

} // namespace

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (;;) {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end - begin));
        if (end == std::string::npos) return parts;
        begin = end + 1;
    }
}

glm::ivec2 parse_size(std::string_view option, const std::string& text) {
    const std::vector<std::string> parts = split(text, 'x');
    if (parts.size() == 2) {
        const std::optional<int> width = number_from<int>(parts[0]);
        const std::optional<int> height = number_from<int>(parts[1]);
        if (width && height && *width > 0 && *height > 0) return {*width, *height};
    }
    throw UsageError(fmt::format(
        "{} \"{}\" is not a picture size; write it as 1024x768, both at least 1", option, text));
}

std::optional<float> parse_crease(std::string_view option, const std::string& text) {
    if (text == "auto") return std::nullopt;
    const std::optional<float> degrees = number_from<float>(text);
    if (degrees && *degrees >= 0 && *degrees <= 180) // false for NaN
        return *degrees * std::numbers::pi_v<float> / 180;
    throw UsageError(fmt::format("{} must be auto or from 0 to 180 degrees, not {}", option, text));
}

glm::vec3 parse_vector(std::string_view option, const std::string& text) {
    return parse_point(option, text);
}

glm::dvec3 parse_point(std::string_view option, const std::string& text) {
    const std::vector<std::string> parts = split(text, ',');
    glm::dvec3 result{0};
    bool good = parts.size() == 3;
    for (int i = 0; good && i < 3; ++i) {
        const std::optional<double> value = number_from<double>(parts[static_cast<std::size_t>(i)]);
        good = value && std::isfinite(static_cast<float>(*value));
        if (good) result[i] = *value;
    }
    if (good) return result;
    throw UsageError(
        fmt::format("{} \"{}\" is not three finite numbers, as in 1,2.5,-3", option, text));
}

glm::vec3 parse_up(std::string_view option, const std::string& text) {
    if (text == "x") return {1, 0, 0};
    if (text == "y") return {0, 1, 0};
    if (text == "z") return {0, 0, 1};
    const glm::vec3 up = parse_vector(option, text);
    if (up == glm::vec3{0}) throw UsageError(fmt::format("{} must not be the zero vector", option));
    return up;
}

std::vector<int> parse_frames(std::string_view option, const std::string& text, int first,
                              int last) {
    std::vector<int> numbers;
    std::set<int> known;
    for (const std::string& part : split(text, ',')) {
        const std::optional<FrameRange> range = parse_frame_range(part);
        if (!range) {
            throw UsageError(fmt::format("{} \"{}\" names no frames; write 7, 0-99, 0-99x5, 3-x5 "
                                         "or a list of these with commas",
                                         option, part));
        }
        if (!range->last) {
            // Every N-th from 0, from 1, ... to the end: shares of a sequence, whatever its
            // frames are. A share may be empty.
            for (std::int64_t number = range->first; number <= last; number += range->step) {
                const auto frame = static_cast<int>(number);
                if (frame >= first && known.insert(frame).second) numbers.push_back(frame);
            }
            continue;
        }
        if (range->first < first || *range->last > last) {
            throw UsageError(fmt::format("{} \"{}\": the sequence has the frames {} to {}", option,
                                         part, first, last));
        }
        for (int number = range->first; number <= *range->last; number += range->step) {
            if (known.insert(number).second) numbers.push_back(number);
            if (*range->last - number < range->step) break; // avoids an overflow
        }
    }
    return numbers;
}

} // namespace lineatlas
