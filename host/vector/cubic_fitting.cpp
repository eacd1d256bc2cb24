#include "cubic_fitting.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "core/plane_vectors.hpp"

namespace lineatlas {
namespace {

/// Distance of a cubic from the chord between two points, pixels.
constexpr double most_off_chord = 0.1;
constexpr double sharpest = 0.7;  ///< radians by which chords of a smooth line turn
constexpr double straight = 1e-3; ///< radians between a tangent and its chord
/// A chord that is this many times as long as its neighbour is straight; the neighbour is short.
constexpr double much_longer = 8;

glm::dvec2 unit(glm::dvec2 v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : v;
}

/// A cubic by its four points.
struct Cubic {
    glm::dvec2 p, a, b, q;

    glm::dvec2 at(double t) const {
        const double s = 1 - t;
        return s * s * s * p + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * q;
    }
    glm::dvec2 slope(double t) const {
        const double s = 1 - t;
        return 3.0 * (s * s * (a - p) + 2 * s * t * (b - a) + t * t * (q - b));
    }
    glm::dvec2 bend(double t) const {
        return 6.0 * ((1 - t) * (b - 2.0 * a + p) + t * (q - 2.0 * b + a));
    }
};

/// A smooth part of a line.
class Fitter {
  public:
    Fitter(std::span<const glm::dvec2> points, std::uint32_t offset, bool closed, double most_off)
        : points_(points), offset_(offset), most_off_(most_off), tangents_(points.size()) {
        const std::size_t n = points.size() - 1;
        for (std::size_t i = 1; i < n; ++i)
            tangents_[i] = tangent(points[i] - points[i - 1], points[i + 1] - points[i]);
        if (closed) {
            tangents_[0] = tangents_[n] = tangent(points[n] - points[n - 1], points[1] - points[0]);
        } else {
            tangents_[0] = beyond(tangents_[1], points[1] - points[0]);
            tangents_[n] = beyond(tangents_[n - 1], points[n] - points[n - 1]);
        }
    }

    void fit(std::vector<FittedCubic>& result) const {
        const std::size_t n = points_.size() - 1;
        for (std::size_t first = 0; first < n;) {
            std::size_t last = first + 1, step = 1;
            std::optional<Cubic> best = between(first, last);
            // In growing strides, then back in shrinking ones.
            while (step > 0) {
                const std::size_t farther = std::min(last + step, n);
                const std::optional<Cubic> found =
                    farther > last ? between(first, farther) : std::nullopt;
                if (found) {
                    best = found;
                    last = farther;
                    step *= 2;
                } else {
                    step /= 2;
                }
            }
            if (best && !is_straight(*best))
                result.push_back({static_cast<std::uint32_t>(first) + offset_,
                                  static_cast<std::uint32_t>(last) + offset_,
                                  {best->a, best->b}});
            first = last;
        }
    }

  private:
    /// The tangent of the circle through three points, at the middle one.
    static glm::dvec2 tangent(glm::dvec2 before, glm::dvec2 after) {
        const double a = glm::length(before), b = glm::length(after);
        if (a > much_longer * b) return unit(before);
        if (b > much_longer * a) return unit(after);
        return unit(before * (b / a) + after * (a / b));
    }

    /// The tangent at the other end of a circle's chord.
    static glm::dvec2 beyond(glm::dvec2 tangent, glm::dvec2 chord) {
        const glm::dvec2 along = unit(chord);
        return 2 * glm::dot(tangent, along) * along - tangent;
    }

    bool is_straight(const Cubic& cubic) const {
        const glm::dvec2 chord = cubic.q - cubic.p;
        const double most = straight * glm::dot(chord, chord);
        return std::abs(cross(chord, cubic.a - cubic.p)) < most &&
               std::abs(cross(chord, cubic.q - cubic.b)) < most;
    }

    std::optional<Cubic> between(std::size_t first, std::size_t last) const {
        const std::size_t count = last - first;
        std::vector<double> at(count + 1, 0);
        for (std::size_t i = 1; i <= count; ++i)
            at[i] = at[i - 1] + glm::distance(points_[first + i], points_[first + i - 1]);
        const double length = at[count];
        if (!(length > 0)) return {};
        for (double& t : at) t /= length;
        Cubic cubic = solve(first, last, at, length);
        for (int round = 0; round < 4 && count > 1; ++round) {
            for (std::size_t i = 1; i < count; ++i)
                at[i] = nearer(cubic, points_[first + i], at[i]);
            if (!std::ranges::is_sorted(at)) return {};
            cubic = solve(first, last, at, length);
        }
        return is_along(cubic, first, at) ? std::optional{cubic} : std::nullopt;
    }

    /// The two lengths along the tangents that fit best.
    Cubic solve(std::size_t first, std::size_t last, const std::vector<double>& at,
                double length) const {
        const glm::dvec2 p = points_[first], q = points_[last];
        const glm::dvec2 from = tangents_[first], to = -tangents_[last];
        double ff = 0, ft = 0, tt = 0, f = 0, t_sum = 0;
        for (std::size_t i = 1; i + 1 < at.size(); ++i) {
            const double t = at[i], s = 1 - t;
            const glm::dvec2 a = from * (3 * s * s * t), b = to * (3 * s * t * t);
            const glm::dvec2 left = points_[first + i] - (s * s * s + 3 * s * s * t) * p -
                                    (t * t * t + 3 * s * t * t) * q;
            ff += glm::dot(a, a);
            ft += glm::dot(a, b);
            tt += glm::dot(b, b);
            f += glm::dot(left, a);
            t_sum += glm::dot(left, b);
        }
        const double area = ff * tt - ft * ft;
        double along_from = length / 3, along_to = length / 3;
        if (area > 1e-12 * ff * tt) {
            const double one = (f * tt - t_sum * ft) / area, other = (t_sum * ff - f * ft) / area;
            const auto is_sound = [&](double along) {
                return along > 0.05 * length && along < length;
            };
            if (is_sound(one) && is_sound(other)) {
                along_from = one;
                along_to = other;
            }
        }
        return {p, p + along_from * from, q + along_to * to, q};
    }

    /// One step of Newton's method to the parameter of the nearest point.
    static double nearer(const Cubic& cubic, glm::dvec2 point, double t) {
        const glm::dvec2 off = cubic.at(t) - point, slope = cubic.slope(t);
        const double change = glm::dot(slope, slope) + glm::dot(off, cubic.bend(t));
        return change > 0 ? std::clamp(t - glm::dot(off, slope) / change, 0.0, 1.0) : t;
    }

    bool is_along(const Cubic& cubic, std::size_t first, const std::vector<double>& at) const {
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            const glm::dvec2 p = points_[first + i], q = points_[first + i + 1];
            if (i > 0 && !(glm::distance(cubic.at(at[i]), p) < most_off_)) return false;
            const glm::dvec2 way = q - p;
            for (const double share : {0.25, 0.5, 0.75}) {
                const glm::dvec2 to = cubic.at(std::lerp(at[i], at[i + 1], share)) - p;
                if (!(std::abs(cross(way, to)) < most_off_chord * glm::length(way))) return false;
            }
        }
        return true;
    }

    std::span<const glm::dvec2> points_;
    std::uint32_t offset_;
    double most_off_;
    std::vector<glm::dvec2> tangents_;
};

} // namespace

std::vector<FittedCubic> fit_cubics(std::span<const glm::dvec2> points, bool closed,
                                    double most_off) {
    std::vector<FittedCubic> result;
    if (points.size() < 3) return result;
    const std::size_t n = points.size() - 1;
    const auto is_corner = [&](std::size_t i) {
        const glm::dvec2 before = points[i] - points[i == 0 ? n - 1 : i - 1];
        const glm::dvec2 after = points[i == n ? 1 : i + 1] - points[i];
        return std::abs(std::atan2(cross(before, after), glm::dot(before, after))) > sharpest;
    };
    std::size_t first = 0;
    for (std::size_t i = 1; i <= n; ++i) {
        if (i < n && !is_corner(i)) continue;
        const bool whole = closed && first == 0 && i == n && !is_corner(0);
        if (i - first > 1)
            Fitter{points.subspan(first, i - first + 1), static_cast<std::uint32_t>(first), whole,
                   most_off}
                .fit(result);
        first = i;
    }
    return result;
}

} // namespace lineatlas
