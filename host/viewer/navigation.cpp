#include "navigation.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

namespace lineatlas::viewer {
namespace {

constexpr double glide_seconds = 0.28;
constexpr double nearest_to_vertical = 1e-3; // radians; there the picture's up is not defined

/// Axes of the picture in the model.
struct Axes {
    glm::dvec3 ahead, right, above;
};

Axes axes_of(const View& view) {
    const glm::dvec3 ahead = glm::normalize(glm::dvec3{view.target} - glm::dvec3{view.eye});
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3{view.up}));
    return {ahead, right, glm::cross(right, ahead)};
}

double distance_of(const View& view) {
    return glm::distance(glm::dvec3{view.eye}, glm::dvec3{view.target});
}

/// Whether a view has a direction, as far as its numbers can tell. Eye and target are floats: too
/// near to each other they are one point, and too far away they are infinite.
bool has_direction(const View& view) {
    constexpr double nearest = 1e-5;  // of the distance to the origin
    constexpr double farthest = 1e18; // its square is a float, too
    const double reach =
        std::max(glm::length(glm::dvec3{view.eye}), glm::length(glm::dvec3{view.target}));
    return distance_of(view) > nearest * reach && reach < farthest;
}

/// Half the picture's height as a length in the model, at `depth` ahead of the eye.
double half_height(const View& view, double depth) {
    const double parallel = distance_of(view);
    return std::tan(0.5 * static_cast<double>(view.fov_y)) *
           (view.projection == Projection::orthographic ? parallel : depth);
}

/// A direction as angles: about the vertical and above the horizon.
struct Angles {
    double about, above;
};

/// Two axes of the horizon.
struct Horizon {
    glm::dvec3 vertical, first, second;

    explicit Horizon(glm::vec3 up) : vertical(glm::normalize(glm::dvec3{up})) {
        const glm::dvec3 other =
            std::abs(vertical.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
        first = glm::normalize(glm::cross(vertical, other));
        second = glm::cross(vertical, first);
    }
    Angles angles(glm::dvec3 direction) const {
        return {std::atan2(glm::dot(direction, second), glm::dot(direction, first)),
                std::asin(std::clamp(glm::dot(direction, vertical), -1.0, 1.0))};
    }
    glm::dvec3 direction(Angles angles) const {
        return std::cos(angles.above) *
                   (std::cos(angles.about) * first + std::sin(angles.about) * second) +
               std::sin(angles.above) * vertical;
    }
};

glm::dvec3 direction_of(const View& view) {
    return glm::normalize(glm::dvec3{view.eye} - glm::dvec3{view.target});
}

/// A point to go away from, moved at least as far as the target. Steps are shares of the distance,
/// so between near walls, as in a room, one could not get out otherwise.
glm::dvec3 no_nearer_than_target(const View& view, glm::dvec3 point) {
    const glm::dvec3 eye = view.eye, way = point - eye;
    const double distance = glm::length(way), least = distance_of(view);
    if (view.projection == Projection::orthographic || distance >= least) return point;
    return distance > 0 ? eye + way * (least / distance) : glm::dvec3{view.target};
}

/// A view between two views. The target goes straight, and the eye turns about it without rolling.
View between(const View& from, const View& to, double share) {
    const Horizon horizon{to.up};
    const Angles a = horizon.angles(direction_of(from)), b = horizon.angles(direction_of(to));
    const double turn = std::remainder(b.about - a.about, glm::two_pi<double>());
    const glm::dvec3 direction =
        horizon.direction({a.about + share * turn, glm::mix(a.above, b.above, share)});
    const glm::dvec3 target = glm::mix(glm::dvec3{from.target}, glm::dvec3{to.target}, share);
    const double distance =
        std::pow(distance_of(from), 1 - share) * std::pow(distance_of(to), share);
    View view = to;
    view.target = target;
    view.eye = target + distance * direction;
    view.fov_y = glm::mix(from.fov_y, to.fov_y, static_cast<float>(share));
    return view;
}

} // namespace

Ray ray_at(const View& view, glm::dvec2 point, glm::dvec2 size) {
    const Axes axes = axes_of(view);
    const double scale = 2 * half_height(view, 1) / size.y;
    const glm::dvec2 from_middle = (point - 0.5 * size) * scale;
    const glm::dvec3 aside = from_middle.x * axes.right - from_middle.y * axes.above;
    if (view.projection == Projection::perspective)
        return {view.eye, glm::normalize(axes.ahead + aside)};
    constexpr double behind = 1e4; // heights of the picture; things behind the eye are seen too
    return {glm::dvec3{view.eye} + aside - behind * half_height(view, 1) * axes.ahead, axes.ahead};
}

std::optional<glm::dvec2> seen_at(const View& view, glm::dvec3 point, glm::dvec2 size) {
    const Axes axes = axes_of(view);
    const glm::dvec3 offset = point - glm::dvec3{view.eye};
    const double depth = glm::dot(offset, axes.ahead);
    if (!(depth > 0) && view.projection == Projection::perspective) return {};
    const double scale = size.y / (2 * half_height(view, depth));
    return 0.5 * size +
           scale * glm::dvec2{glm::dot(offset, axes.right), -glm::dot(offset, axes.above)};
}

std::optional<glm::dvec3> pick(const LineSet& lines, const Ray& ray) {
    const auto hit = first_hit(ray, lines.vertices, lines.triangles);
    return hit ? std::optional{ray.at(hit->distance)} : std::nullopt;
}

std::optional<glm::dvec3> corner_or_point(const LineSet& lines, const View& view, glm::dvec2 point,
                                          glm::dvec2 size) {
    const Ray ray = ray_at(view, point, size);
    const auto hit = first_hit(ray, lines.vertices, lines.triangles);
    if (!hit) return {};
    glm::dvec3 result = ray.at(hit->distance);
    double reach = 10; // pixels
    for (int corner = 0; corner < 3; ++corner) {
        const glm::dvec3 place = lines.vertices[lines.triangles[hit->triangle][corner]];
        const std::optional<glm::dvec2> seen = seen_at(view, place, size);
        if (!seen || glm::distance(*seen, point) >= reach) continue;
        reach = glm::distance(*seen, point);
        result = place;
    }
    return result;
}

glm::vec3 direction_to(StandardView view, glm::vec3 up) {
    const glm::vec3 front = std::abs(up.z) > 0.5F ? glm::vec3{0, -1, 0} : glm::vec3{0, 0, 1};
    const glm::vec3 side = std::abs(glm::dot(up, front)) > 0.5F ? glm::vec3{1, 0, 0} : front;
    const glm::vec3 right = glm::normalize(glm::cross(up, side));
    constexpr auto lean = static_cast<float>(nearest_to_vertical);
    switch (view) {
    case StandardView::front:
        return side;
    case StandardView::back:
        return -side;
    case StandardView::right:
        return right;
    case StandardView::left:
        return -right;
    case StandardView::top:
        return glm::normalize(up + lean * side);
    case StandardView::bottom:
        return glm::normalize(-up + lean * side);
    case StandardView::corner:
        break;
    }
    return glm::normalize(0.75F * right + side + 0.6F * up);
}

void Navigation::set_view(const View& view) {
    view_ = view;
    view_.near = view_.far = 0; // fitted to the model, because the eye is going to move
    glide_.reset();
}

void Navigation::glide_to(const View& view) {
    glide_ = Glide{view_, view};
    glide_->to.near = glide_->to.far = 0;
}

void Navigation::set_projection(Projection projection) {
    view_.projection = projection;
    if (glide_) glide_->from.projection = glide_->to.projection = projection;
}

void Navigation::advance(double seconds) {
    if (!glide_) return;
    glide_->done += seconds / glide_seconds;
    if (glide_->done >= 1) return set_view(View{glide_->to});
    const double t = glide_->done;
    view_ = between(glide_->from, glide_->to, t * t * (3 - 2 * t));
}

/// Moves the camera, unless it would have no direction there.
void Navigation::place(glm::dvec3 eye, glm::dvec3 target) {
    View view = view_;
    view.eye = eye;
    view.target = target;
    if (has_direction(view)) view_ = view;
}

void Navigation::move(glm::dvec3 way) {
    place(glm::dvec3{view_.eye} + way, glm::dvec3{view_.target} + way);
}

void Navigation::turn_about(glm::dvec3 pivot, glm::dvec2 turn) {
    glide_.reset();
    const glm::dvec3 vertical = glm::normalize(glm::dvec3{view_.up});
    const Axes axes = axes_of(view_);
    // The angle from the vertical to the line of sight stays within (0, pi).
    const double angle = std::acos(std::clamp(glm::dot(vertical, axes.ahead), -1.0, 1.0));
    const double limit = nearest_to_vertical;
    const double wanted = std::clamp(angle - turn.y, limit, glm::pi<double>() - limit);
    const glm::dquat rotation =
        glm::angleAxis(turn.x, vertical) * glm::angleAxis(angle - wanted, axes.right);
    const glm::dvec3 eye = pivot + rotation * (glm::dvec3{view_.eye} - pivot);
    place(eye, eye + rotation * (glm::dvec3{view_.target} - glm::dvec3{view_.eye}));
}

void Navigation::orbit(glm::dvec3 pivot, glm::dvec2 turn) {
    turn_about(pivot, turn);
}

void Navigation::look(glm::dvec2 turn) {
    turn_about(view_.eye, turn);
}

void Navigation::pan(glm::dvec3 held, glm::dvec2 from, glm::dvec2 to, glm::dvec2 size) {
    glide_.reset();
    const Axes axes = axes_of(view_);
    const double depth = std::abs(glm::dot(held - glm::dvec3{view_.eye}, axes.ahead));
    const glm::dvec2 way = (to - from) * (2 * half_height(view_, depth) / size.y);
    move(-way.x * axes.right + way.y * axes.above);
}

void Navigation::dolly(glm::dvec3 to, double factor) {
    glide_.reset();
    if (factor > 1) to = no_nearer_than_target(view_, to);
    const glm::dvec3 sight = glm::dvec3{view_.target} - glm::dvec3{view_.eye};
    const glm::dvec3 eye = to + factor * (glm::dvec3{view_.eye} - to);
    place(eye, eye + factor * sight);
}

void Navigation::fly(glm::dvec3 way) {
    glide_.reset();
    const Axes axes = axes_of(view_);
    move(way.x * axes.right + way.y * glm::normalize(glm::dvec3{view_.up}) + way.z * axes.ahead);
}

} // namespace lineatlas::viewer
