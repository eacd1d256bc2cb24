#include "lineatlas/camera_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_frames = 1e6;

/// The cubic from a to b over `length` with these slopes at its ends.
template <class T>
T cubic(T a, T b, T slope_a, T slope_b, double length, double s) {
    const double rest = 1 - s;
    return a * (rest * rest * (1 + 2 * s)) + b * (s * s * (3 - 2 * s)) +
           slope_a * (length * s * rest * rest) - slope_b * (length * s * s * rest);
}

/// The slope at a key: that of the parabola through the key and its two neighbours. `before` and
/// `after` are the slopes to the neighbours. A camera that rests on one side comes to rest at the
/// key.
glm::dvec3 slope_at(glm::dvec3 before, glm::dvec3 after, double from, double to) {
    if (before == glm::dvec3{0} || after == glm::dvec3{0}) return glm::dvec3{0};
    return (before * to + after * from) / (from + to);
}

/// The slope for a single number. The number never leaves the range of its keys (Fritsch and
/// Butland).
double slope_at(double before, double after, double from, double to) {
    if (before * after <= 0) return 0;
    return 3 * (from + to) / ((2 * to + from) / before + (to + 2 * from) / after);
}

/// The value between keys i and i + 1. `value(k)`: that of key k; `time(k)`: its frame.
template <class Value, class Time>
auto interpolate(const Value& value, const Time& time, std::size_t count, std::size_t i, double s) {
    const auto length = [&](std::size_t k) { return time(k + 1) - time(k); };
    const auto secant = [&](std::size_t k) { return (value(k + 1) - value(k)) / length(k); };
    const auto slope = [&](std::size_t k) {
        if (k == 0) return secant(0);
        if (k + 1 == count) return secant(count - 2);
        return slope_at(secant(k - 1), secant(k), length(k - 1), length(k));
    };
    return cubic(value(i), value(i + 1), slope(i), slope(i + 1), length(i), s);
}

} // namespace

CameraPath::CameraPath(std::vector<Key> keys) : keys_(std::move(keys)) {
    if (keys_.empty()) throw UsageError("a camera path needs at least one key");
    double before = -infinity;
    for (const Key& key : keys_) {
        if (!(std::abs(key.frame) <= most_frames))
            throw UsageError("frames of a camera path must be from -1000000 to 1000000");
        if (key.frame <= before)
            throw UsageError("each key of a camera path must come later than the one before it");
        before = key.frame;
    }
}

int CameraPath::first_frame() const {
    return static_cast<int>(std::ceil(keys_.front().frame));
}

int CameraPath::last_frame() const {
    return static_cast<int>(std::floor(keys_.back().frame));
}

View CameraPath::view(double frame) const {
    if (!(frame > keys_.front().frame)) return keys_.front().view; // NaN, too
    if (frame >= keys_.back().frame) return keys_.back().view;
    const auto after = std::ranges::upper_bound(keys_, frame, {}, &Key::frame);
    const auto i = static_cast<std::size_t>(after - keys_.begin()) - 1;
    const double s = (frame - keys_[i].frame) / (keys_[i + 1].frame - keys_[i].frame);
    const auto time = [&](std::size_t k) { return keys_[k].frame; };
    const auto vector = [&](glm::vec3 View::*member) {
        const auto value = [&](std::size_t k) { return glm::dvec3{keys_[k].view.*member}; };
        return glm::vec3{interpolate(value, time, keys_.size(), i, s)};
    };
    const auto fov = [&](std::size_t k) { return static_cast<double>(keys_[k].view.fov_y); };
    View result = keys_[i].view;
    result.eye = vector(&View::eye);
    result.target = vector(&View::target);
    result.up = vector(&View::up);
    result.fov_y = static_cast<float>(interpolate(fov, time, keys_.size(), i, s));
    return result;
}

} // namespace lineatlas
