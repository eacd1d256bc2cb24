#include "circle_crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>

namespace lineatlas {
namespace {

/// A coefficient of a rational Bézier curve, relative to the circle's centre.
struct Homogeneous {
    glm::dvec2 at;
    double weight;
};

double binomial(std::size_t n, std::size_t k) {
    double result = 1;
    for (std::size_t i = 0; i < k; ++i)
        result *= static_cast<double>(n - i) / static_cast<double>(i + 1);
    return result;
}

/// The Bernstein coefficients of |at|^2 - radius^2 weight^2 along a curve, a polynomial that is
/// below 0 where the curve lies within the circle.
std::vector<double> depth_along(std::span<const Homogeneous> curve, double radius) {
    const std::size_t degree = curve.size() - 1;
    std::vector<double> depth(2 * degree + 1, 0.0);
    for (std::size_t i = 0; i <= degree; ++i)
        for (std::size_t k = 0; k <= degree; ++k)
            depth[i + k] += binomial(degree, i) * binomial(degree, k) /
                            binomial(2 * degree, i + k) *
                            (glm::dot(curve[i].at, curve[k].at) -
                             radius * radius * curve[i].weight * curve[k].weight);
    return depth;
}

/// Finds the roots of a polynomial from 0 to 1 by halving its Bernstein form: no change of sign
/// among the coefficients means no root, one change means one (Lane & Riesenfeld 1981).
class Roots {
  public:
    /// The only root between two places; `rises` says that the polynomial is below 0 before it.
    using Refine = std::function<double(double low, double high, bool rises)>;

    Roots(std::span<const double> polynomial, Refine refine) : refine_(std::move(refine)) {
        double largest = 0;
        for (const double one : polynomial) largest = std::max(largest, std::abs(one));
        noise_ = 1e-14 * largest;
        if (is_zero(polynomial.front())) roots_.push_back(0);
        add({polynomial.begin(), polynomial.end()}, 0, 1);
        if (is_zero(polynomial.back())) roots_.push_back(1);
    }

    const std::vector<double>& all() const { return roots_; }

  private:
    bool is_zero(double value) const { return std::abs(value) <= noise_; }

    std::size_t changes_of_sign(std::span<const double> polynomial) const {
        std::size_t changes = 0;
        double before = 0;
        for (const double one : polynomial) {
            if (is_zero(one)) continue;
            if (before != 0 && std::signbit(one) != std::signbit(before)) ++changes;
            before = one;
        }
        return changes;
    }

    /// Leaves the second half of a polynomial, and returns the first one (de Casteljau).
    static std::vector<double> split(std::vector<double>& polynomial) {
        std::vector<double> first;
        for (std::size_t left = polynomial.size(); left > 0; --left) {
            first.push_back(polynomial.front());
            for (std::size_t i = 0; i + 1 < left; ++i)
                polynomial[i] = 0.5 * (polynomial[i] + polynomial[i + 1]);
        }
        return first;
    }

    void add(std::vector<double> polynomial, double low, double high) {
        constexpr double narrowest = 1e-14;
        const std::size_t changes = changes_of_sign(polynomial);
        if (changes == 0 || high - low < narrowest) return;
        if (changes == 1) {
            const auto first =
                std::ranges::find_if(polynomial, [&](const double one) { return !is_zero(one); });
            roots_.push_back(refine_(low, high, *first < 0));
            return;
        }
        const double middle = 0.5 * (low + high);
        std::vector<double> first_half = split(polynomial);
        add(std::move(first_half), low, middle);
        if (is_zero(polynomial.front())) roots_.push_back(middle);
        add(std::move(polynomial), middle, high);
    }

    Refine refine_;
    double noise_ = 0;
    std::vector<double> roots_;
};

/// Bisects. `at`: the curve's point at a place.
template <class At>
Roots::Refine bisection(const Circle& circle, const At& at) {
    return [&circle, &at](double low, double high, bool rises) {
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            ((circle.beyond(at(middle)) < 0) == rises ? low : high) = middle;
        }
        return 0.5 * (low + high);
    };
}

constexpr double quarter = 0.5 * std::numbers::pi;

/// Adds the crossings of a part of an arc, at most a quarter, as a rational quadratic curve.
void add_crossings(const VectorArc& arc, double from, double to, const Circle& circle,
                   std::vector<double>& angles) {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    const glm::dvec2 center = arc.center - circle.center;
    const auto coefficient = [&](double angle, double weight) {
        return Homogeneous{weight * center + arc.at(angle) - arc.center, weight};
    };
    const std::array curve{coefficient(from, 1), coefficient(middle, std::cos(half)),
                           coefficient(to, 1)};
    const auto angle_at = [&](double place) {
        return middle + 2 * std::atan((2 * place - 1) * std::tan(0.5 * half));
    };
    const auto at = [&](double place) { return arc.at(angle_at(place)); };
    const Roots roots{depth_along(curve, circle.radius), bisection(circle, at)};
    std::ranges::transform(roots.all(), std::back_inserter(angles), angle_at);
}

} // namespace

glm::dvec2 point_of(const VectorCubic& cubic, glm::dvec2 start, glm::dvec2 end, double share) {
    const double t = share, s = 1 - t;
    return s * s * s * start + 3 * s * s * t * cubic.first_control +
           3 * s * t * t * cubic.last_control + t * t * t * end;
}

std::vector<double> crossings(const VectorArc& arc, const Circle& circle) {
    const double reach = glm::length(arc.major); // no point is farther from the arc's centre
    if (std::abs(circle.beyond(arc.center)) > reach + circle.rounding()) return {};
    const int parts = arc.sweep == 0 ? 0 : 1 + static_cast<int>(std::abs(arc.sweep) / quarter);
    const auto angle = [&](int part) { return arc.from + arc.sweep * part / parts; };
    std::vector<double> angles;
    for (int i = 0; i < parts; ++i) add_crossings(arc, angle(i), angle(i + 1), circle, angles);
    return angles;
}

std::vector<double> crossings(const VectorCubic& cubic, glm::dvec2 start, glm::dvec2 end,
                              const Circle& circle) {
    const auto coefficient = [&](glm::dvec2 at) { return Homogeneous{at - circle.center, 1}; };
    const std::array curve{coefficient(start), coefficient(cubic.first_control),
                           coefficient(cubic.last_control), coefficient(end)};
    const auto at = [&](double share) { return point_of(cubic, start, end, share); };
    return Roots{depth_along(curve, circle.radius), bisection(circle, at)}.all();
}

} // namespace lineatlas
