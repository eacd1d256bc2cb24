#include "hatch_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr double most_lines = 100000; ///< most lines of a face; a face with more would be black
/// The shortest line, as a share of the spacing. Shorter ones, at corners, would be specks.
constexpr double shortest = 0.02;

} // namespace

std::vector<std::pair<glm::dvec2, glm::dvec2>> hatch_lines(const CutFace& face, double spacing,
                                                           double angle) {
    const double radians = angle * std::numbers::pi / 180;
    const glm::dvec2 along{std::cos(radians), std::sin(radians)};
    const glm::dvec2 across{-along.y, along.x};
    double low = INFINITY, high = -INFINITY;
    for (const CutLoop& loop : face.loops) {
        for (const glm::dvec2 point : loop.flat) {
            low = std::min(low, glm::dot(point, across));
            high = std::max(high, glm::dot(point, across));
        }
    }
    if (!((high - low) / spacing < most_lines))
        throw UsageError("hatching: its lines are too near to each other for the model's size");
    // Lines of all faces lie at multiples of the spacing, so they continue each other.
    const auto first = static_cast<long long>(std::ceil(low / spacing));
    const auto last = static_cast<long long>(std::floor(high / spacing));
    std::vector<std::vector<double>> crossings(
        static_cast<std::size_t>(std::max(0LL, last - first + 1)));
    for (const CutLoop& loop : face.loops) {
        for (std::size_t i = 0; i < loop.flat.size(); ++i) {
            glm::dvec2 a = loop.flat[i], b = loop.flat[(i + 1) % loop.flat.size()];
            if (glm::dot(a, across) > glm::dot(b, across)) std::swap(a, b);
            const double from = glm::dot(a, across), to = glm::dot(b, across);
            // A corner on a line belongs to the edge that begins there.
            for (auto k = static_cast<long long>(std::ceil(from / spacing));
                 static_cast<double>(k) * spacing < to; ++k) {
                const double share = (static_cast<double>(k) * spacing - from) / (to - from);
                if (k < first || k > last) continue;
                crossings[static_cast<std::size_t>(k - first)].push_back(
                    glm::dot(a + share * (b - a), along));
            }
        }
    }
    std::vector<std::pair<glm::dvec2, glm::dvec2>> lines;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        std::vector<double>& at = crossings[i];
        std::ranges::sort(at);
        const glm::dvec2 base =
            static_cast<double>(first + static_cast<long long>(i)) * spacing * across;
        for (std::size_t k = 0; k + 1 < at.size(); k += 2) {
            if (at[k + 1] - at[k] > shortest * spacing)
                lines.emplace_back(base + at[k] * along, base + at[k + 1] * along);
        }
    }
    return lines;
}

double hatch_angle(double first, std::size_t number) {
    constexpr std::array turned{0.0, 90.0, -15.0, 75.0, 15.0, 105.0};
    return first + turned[number % turned.size()];
}

} // namespace lineatlas
