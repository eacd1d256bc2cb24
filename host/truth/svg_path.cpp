#include "svg_path.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/numbers.hpp"
#include "flatten.hpp"

namespace lineatlas {
namespace {

class PathParser {
  public:
    explicit PathParser(std::string_view data) : rest_(data) {}

    /// Parses the data. Returns whether all of it was understood.
    bool parse() {
        while (skip_spaces(), !rest_.empty()) {
            if (std::isalpha(static_cast<unsigned char>(rest_.front())) != 0) {
                command_ = rest_.front();
                rest_.remove_prefix(1);
                if (command_ == 'z' || command_ == 'Z') {
                    line_to(start_);
                    continue;
                }
            }
            if (!step()) return false;
        }
        return true;
    }

    std::vector<std::pair<glm::dvec2, glm::dvec2>> lines;

  private:
    void skip_spaces() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" ,\t\r\n"), rest_.size()));
    }

    bool number(double& value) {
        skip_spaces();
        const std::optional<double> found = take_number(rest_);
        constexpr double largest = 1e9; // larger than in any drawing; its square is finite
        if (!found || !(std::abs(*found) <= largest)) return false;
        value = *found;
        return true;
    }

    void line_to(glm::dvec2 to) {
        lines.emplace_back(here_, to);
        here_ = to;
    }

    /// An arc of an ellipse to a point (SVG 1.1 appendix F.6).
    bool arc_to(glm::dvec2 base) {
        glm::dvec2 radii{0}, to{0};
        double turned = 0, large = 0, sweep = 0;
        for (double* value : {&radii.x, &radii.y, &turned, &large, &sweep, &to.x, &to.y})
            if (!number(*value)) return false;
        if (!(radii.x > 0) || !(radii.y > 0)) return false;
        to += base;
        const double angle_of_axis = glm::radians(turned);
        const glm::dvec2 axis{std::cos(angle_of_axis), std::sin(angle_of_axis)};
        // Coordinates in which the ellipse is a circle of radius 1.
        const auto unrolled = [&](glm::dvec2 at) {
            return glm::dvec2{glm::dot(at, axis), axis.x * at.y - axis.y * at.x} / radii;
        };
        const auto rolled = [&](glm::dvec2 at) {
            const glm::dvec2 along = at * radii;
            return glm::dvec2{along.x * axis.x - along.y * axis.y,
                              along.x * axis.y + along.y * axis.x};
        };
        const glm::dvec2 from = unrolled(here_), end = unrolled(to);
        const glm::dvec2 half = 0.5 * (end - from);
        const double squared = glm::dot(half, half);
        if (squared == 0) return true;
        // Radii that are too small to reach grow until they do.
        const double height = std::sqrt(std::max(0.0, 1 - squared));
        const glm::dvec2 across = glm::dvec2{-half.y, half.x} / std::sqrt(squared);
        const double side = (large != 0) == (sweep != 0) ? -1 : 1;
        const glm::dvec2 center = from + half + side * height * across;
        const auto angle = [&](glm::dvec2 at) {
            return std::atan2(at.y - center.y, at.x - center.x);
        };
        constexpr double turn = 2 * std::numbers::pi;
        double angles = angle(end) - angle(from);
        if (sweep != 0 && angles < 0) angles += turn;
        if (sweep == 0 && angles > 0) angles -= turn;
        const double radius = glm::length(from - center);
        const int chords = chords_of_arc(radius * std::max(radii.x, radii.y), angles);
        for (int i = 1; i < chords; ++i) {
            const double at = angle(from) + angles * i / chords;
            line_to(rolled(center + radius * glm::dvec2{std::cos(at), std::sin(at)}));
        }
        line_to(to);
        return true;
    }

    bool cubic_to(glm::dvec2 base) {
        glm::dvec2 a{0}, b{0}, to{0};
        for (double* value : {&a.x, &a.y, &b.x, &b.y, &to.x, &to.y})
            if (!number(*value)) return false;
        a += base;
        b += base;
        to += base;
        std::vector<glm::dvec2> points;
        append_cubic(here_, {a, b}, to, points);
        for (const glm::dvec2 point : points) line_to(point);
        return true;
    }

    /// Takes the numbers of a command once.
    bool step() {
        const bool relative = std::islower(static_cast<unsigned char>(command_)) != 0;
        const glm::dvec2 base = relative ? here_ : glm::dvec2{0};
        glm::dvec2 to{0};
        switch (std::tolower(static_cast<unsigned char>(command_))) {
        case 'm':
            if (!number(to.x) || !number(to.y)) return false;
            here_ = start_ = base + to;
            command_ = relative ? 'l' : 'L'; // more numbers are lines
            return true;
        case 'l':
            if (!number(to.x) || !number(to.y)) return false;
            line_to(base + to);
            return true;
        case 'h':
            if (!number(to.x)) return false;
            line_to({base.x + to.x, here_.y});
            return true;
        case 'v':
            if (!number(to.y)) return false;
            line_to({here_.x, base.y + to.y});
            return true;
        case 'a':
            return arc_to(base);
        case 'c':
            return cubic_to(base);
        default:
            return false;
        }
    }

    std::string_view rest_;
    char command_ = 0;
    glm::dvec2 here_{0}, start_{0};
};

} // namespace

std::optional<std::vector<std::pair<glm::dvec2, glm::dvec2>>> parse_path(std::string_view data) {
    PathParser parser{data};
    if (!parser.parse()) return std::nullopt;
    return std::move(parser.lines);
}

} // namespace lineatlas
