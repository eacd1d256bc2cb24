#include "path_data.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

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

    std::string close(bool closed) { return std::move(text_) + (closed ? "z" : ""); }

  private:
    void use(char command) {
        if (command == command_) return;
        command_ = command;
        text_ += command;
    }

    void add(std::int64_t value) {
        const std::string number = fixed_text(value, digits_);
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

} // namespace

std::string number_text(double value, int digits) {
    return fixed_text(std::llround(value * power_of_ten(digits)), digits);
}

std::string path_data(std::span<const glm::dvec2> points, bool closed, int digits, bool relative) {
    const double scale = power_of_ten(digits);
    std::vector<Place> places;
    places.reserve(points.size());
    for (const glm::dvec2 point : points) {
        const Place place{std::llround(point.x * scale), std::llround(point.y * scale)};
        if (places.empty() || places.back() != place) places.push_back(place);
    }
    if (closed && places.size() > 1 && places.front() == places.back()) places.pop_back();
    if (places.size() < 2) return {};
    PathData data{digits, relative};
    data.move_to(places.front());
    for (std::size_t i = 1; i < places.size(); ++i) data.line_to(places[i]);
    return data.close(closed);
}

} // namespace lineatlas
