#include "path_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace lineatlas {
namespace {

using Place = glm::i64vec2; ///< in units of the last digit

double power_of_ten(int digits) {
    return std::pow(10.0, digits);
}

std::string fixed_text(std::int64_t value, int digits) {
    std::string text = std::to_string(value < 0 ? -value : value);
    const auto after = static_cast<std::size_t>(digits);
    if (text.size() < after) text.insert(0, after - text.size(), '0');
    if (after > 0) {
        text.insert(text.end() - digits, '.');
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    if (text.empty()) text = '0';
    if (value < 0) text.insert(text.begin(), '-');
    return text;
}

class PathData {
  public:
    PathData(int digits, bool relative) : digits_(digits), relative_(relative) {}

    void move_to(Place place) {
        text_ = relative_ ? 'm' : 'M';
        command_ = relative_ ? 'l' : 'L'; // numbers after a move are lines
        add(place.x);
        add(place.y);
        at_ = place;
    }

    void line_to(Place place) {
        const Place target = relative_ ? place - at_ : place;
        if (place.y == at_.y) {
            use(relative_ ? 'h' : 'H');
            add(target.x);
        } else if (place.x == at_.x) {
            use(relative_ ? 'v' : 'V');
            add(target.y);
        } else {
            use(relative_ ? 'l' : 'L');
            add(target.x);
            add(target.y);
        }
        at_ = place;
    }

    void arc_to(const VectorArc& arc, Place place) {
        const Place target = relative_ ? place - at_ : place;
        use(relative_ ? 'a' : 'A');
        // The radius has more digits than places have, because it moves the middle of a flat arc
        // much less.
        const double radius = glm::length(arc.major);
        add(number_text(radius, digits_ + 1));
        add(number_text(arc.ratio * radius, digits_ + 1));
        add(number_text(glm::degrees(std::atan2(arc.major.y, arc.major.x)), 4));
        add("0"); // never the larger of the two, see parts_of()
        add(arc.sweep > 0 ? "1" : "0");
        add(target.x);
        add(target.y);
        at_ = place;
    }

    void cubic_to(Place first_control, Place last_control, Place place) {
        use(relative_ ? 'c' : 'C');
        for (const Place each : {first_control, last_control, place}) {
            const Place target = relative_ ? each - at_ : each;
            add(target.x);
            add(target.y);
        }
        at_ = place;
    }

    std::string close(bool closed) { return std::move(text_) + (closed ? "z" : ""); }

  private:
    void use(char command) {
        if (command == command_) return;
        command_ = command;
        text_ += command;
    }

    void add(std::int64_t value) { add(fixed_text(value, digits_)); }

    void add(const std::string& number) {
        const char last = text_.back();
        const bool after_number = (last >= '0' && last <= '9') || last == '.';
        if (after_number && number.front() != '-') text_ += ' ';
        text_ += number;
    }

    int digits_;
    bool relative_;
    char command_ = 0;
    Place at_{0, 0};
    std::string text_;
};

/// The number of parts in which an arc is written. SVG finds an arc's centre from its ends. If the
/// ends of half a circle of 500 pixels are off by 0.005, its centre is off by 2. The centre of a
/// third of a circle is off by less than the ends.
int parts_of(const VectorArc& arc) {
    constexpr double longest = 2.1; // radians, a third of all around and a little
    return std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / longest)));
}

} // namespace

std::string number_text(double value, int digits) {
    return fixed_text(std::llround(value * power_of_ten(digits)), digits);
}

std::string path_data(const Outline& outline, int digits, bool relative) {
    const double scale = power_of_ten(digits);
    const auto rounded = [&](glm::dvec2 at) {
        return Place{std::llround(at.x * scale), std::llround(at.y * scale)};
    };
    std::vector<Place> places;
    std::vector<std::size_t> kept;
    const std::vector<OutlinePoint>& points = outline.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Place place = rounded(points[i].at);
        if (!places.empty() && places.back() == place) {
            kept.back() = i; // the way goes on from there
            continue;
        }
        places.push_back(place);
        kept.push_back(i);
    }
    if (outline.closed && places.size() > 1 && places.front() == places.back()) {
        places.pop_back();
        kept.pop_back();
    }
    if (places.size() < 2) return {};
    PathData data{digits, relative};
    data.move_to(places.front());
    for (std::size_t i = 1; i <= places.size(); ++i) {
        const bool back = i == places.size();
        const OutlinePoint& from = points[kept[i - 1]];
        if (back && (!outline.closed || from.is_straight())) break; // closing is a straight way
        const std::size_t to = back ? 0 : i;
        if (from.is_straight()) {
            data.line_to(places[to]);
        } else if (from.cubic) {
            data.cubic_to(rounded(from.cubic->first_control), rounded(from.cubic->last_control),
                          places[to]);
        } else {
            const VectorArc arc = arc_between(from, points[kept[to]].at);
            const int count = parts_of(arc);
            VectorArc part = arc;
            part.sweep /= count;
            for (int k = 1; k <= count; ++k) {
                const glm::dvec2 end = arc.at(arc.from + k * part.sweep);
                data.arc_to(part, k < count ? rounded(end) : places[to]);
            }
        }
    }
    return data.close(outline.closed);
}

} // namespace lineatlas
