#include "vector_support.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace lineatlas::test {

Camera flat_camera(glm::ivec2 size) {
    return {.view = glm::mat4{1},
            .projection = glm::ortho(0.0F, static_cast<float>(size.x), 0.0F,
                                     static_cast<float>(size.y), 0.0F, -1.0F),
            .size = size};
}

std::uint32_t Lines::vertex(glm::vec3 point) {
    const auto found = std::ranges::find(set.vertices, point);
    if (found == set.vertices.end()) set.vertices.push_back(point);
    return static_cast<std::uint32_t>(
        std::ranges::distance(set.vertices.begin(), std::ranges::find(set.vertices, point)));
}

void Lines::add(LineKind kind, const std::vector<glm::vec3>& points, bool closed) {
    const auto count = static_cast<std::uint32_t>(closed ? points.size() : points.size() - 1);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t p = vertex(points[i]);
        const std::uint32_t q = vertex(points[(i + 1) % points.size()]);
        set.segments.push_back(
            {.p = p,
             .q = q,
             .face_a = LA_NO_FACE,
             .face_b = LA_NO_FACE,
             .from_start = i,
             .to_end = count - 1 - i,
             .path = set.path_count,
             .tag = static_cast<std::uint32_t>(kind) | (closed ? LA_TAG_CLOSED : 0)});
        set.sources.push_back({.from = 1000 + p, .to = 1000 + q, .triangle = LineSource::none});
    }
    ++set.path_count;
}

Cuts::Cuts(const LineSet& lines, const Camera& camera) : lines_(lines), camera_(camera) {
    start_arcs_.resize(lines.segments.size());
    lengths_.resize(lines.segments.size());
    for (std::size_t i = 0; i < lines.segments.size(); ++i) {
        lengths_[i] =
            glm::distance(place(lines.segments[i], 0).window, place(lines.segments[i], 1).window);
    }
    for (std::size_t i = 0; i < lines.segments.size(); ++i) {
        const Segment& segment = lines.segments[i];
        const std::size_t first = i - segment.from_start;
        double whole = 0;
        for (std::size_t j = first; j <= i + segment.to_end; ++j) {
            if (j == i) start_arcs_[i] = whole;
            whole += lengths_[j];
        }
        start_arcs_[i] -= 0.5 * whole;
    }
}

Cuts::Place Cuts::place(const Segment& segment, double share) const {
    const glm::dmat4 clip_from_world{camera_.clip_from_world()};
    const glm::dvec3 p{lines_.vertices[segment.p]};
    const glm::dvec3 q{lines_.vertices[segment.q]};
    const glm::dvec4 clip_p = clip_from_world * glm::dvec4{p, 1};
    const glm::dvec4 clip_q = clip_from_world * glm::dvec4{q, 1};
    // The share is a share of the way on the screen.
    const double world_share = share * clip_p.w / (share * clip_p.w + (1 - share) * clip_q.w);
    const glm::dvec3 world = p + (q - p) * world_share;
    const glm::dvec4 clip = clip_from_world * glm::dvec4{world, 1};
    const glm::dvec3 device = glm::dvec3{clip} / clip.w;
    return {
        .window = {(device.x + 1) * 0.5 * camera_.size.x, (device.y + 1) * 0.5 * camera_.size.y},
        .depth = (device.z + 1) * 0.5,
        .world = world};
}

std::uint32_t Cuts::end_kind(const Segment& segment, float share) const {
    if (share > 0 && share < 1) return LA_END_HIDDEN;
    const bool last = share == 0 ? segment.from_start == 0 : segment.to_end == 0;
    return last && (segment.tag & LA_TAG_CLOSED) == 0 ? LA_END_PATH : LA_END_JOIN;
}

void Cuts::add(std::uint32_t segment, float from, float to, bool visible) {
    const Segment& own = lines_.segments[segment];
    Interval interval{};
    const auto set_end = [&](float share, float* window, float& depth, float* world, float& arc) {
        const Place at = place(own, static_cast<double>(share));
        for (int axis = 0; axis < 2; ++axis) window[axis] = static_cast<float>(at.window[axis]);
        for (int axis = 0; axis < 3; ++axis) world[axis] = static_cast<float>(at.world[axis]);
        depth = static_cast<float>(at.depth);
        arc = static_cast<float>(start_arcs_[segment] +
                                 lengths_[segment] * static_cast<double>(share));
    };
    set_end(from, interval.start, interval.start_depth, interval.start_world, interval.start_arc);
    set_end(to, interval.end, interval.end_depth, interval.end_world, interval.end_arc);
    interval.alpha = visible ? 1 : 0;
    interval.segment = segment;
    interval.flags = (visible ? LA_INTERVAL_VISIBLE : 0) |
                     end_kind(own, from) << LA_INTERVAL_START_SHIFT |
                     end_kind(own, to) << LA_INTERVAL_END_SHIFT;
    intervals.push_back(interval);
}

void Cuts::add_all() {
    for (std::uint32_t i = 0; i < lines_.segments.size(); ++i) add(i, 0, 1, true);
}

namespace {

struct Span {
    double from, to; ///< pixels from the start of the path
};

/// A straight part of a path.
struct Part {
    glm::dvec2 a, b;
    double start; ///< pixels from the start of the path
    std::size_t path, index;
};

std::vector<Part> parts_of(const std::vector<VectorPath>& paths) {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        double start = 0;
        for (std::size_t k = 1; k < paths[i].points.size(); ++k) {
            const Part part{paths[i].points[k - 1].at, paths[i].points[k].at, start, i, k};
            const double length = glm::distance(part.a, part.b);
            if (length > 1e-9) parts.push_back(part);
            start += length;
        }
    }
    return parts;
}

/// The span where `part` runs along `other`, if both ends of the span are near `other`.
std::optional<Span> span_along(const Part& part, const Part& other) {
    constexpr double near = 0.25;
    constexpr double most_slope = 0.05;
    const glm::dvec2 way = part.b - part.a;
    const double length = glm::length(way);
    const glm::dvec2 along = way / length;
    const auto across = [&](glm::dvec2 point) {
        const glm::dvec2 offset = point - part.a;
        return along.x * offset.y - along.y * offset.x;
    };
    double from = glm::dot(other.a - part.a, along);
    double to = glm::dot(other.b - part.a, along);
    double from_across = across(other.a);
    double to_across = across(other.b);
    if (from > to) {
        std::swap(from, to);
        std::swap(from_across, to_across);
    }
    if (to - from < 1e-9) return {};
    const double slope = (to_across - from_across) / (to - from);
    if (std::abs(slope) > most_slope) return {};
    const Span beside{std::max(from, 0.0), std::min(to, length)};
    if (beside.to <= beside.from) return {};
    for (const double s : {beside.from, beside.to}) {
        if (std::abs(from_across + slope * (s - from)) > near) return {};
    }
    return Span{part.start + beside.from, part.start + beside.to};
}

double longest_of(std::vector<Span> spans) {
    std::ranges::sort(spans, {}, &Span::from);
    double longest = 0;
    double from = 0;
    double to = -1;
    for (const Span span : spans) {
        if (span.from > to + 1e-6) from = span.from;
        to = std::max(to, span.to);
        longest = std::max(longest, to - from);
    }
    return longest;
}

using Cell = std::pair<int, int>;

/// Parts by the cells that the boxes around them touch.
std::map<Cell, std::vector<std::size_t>> grid_of(const std::vector<Part>& parts) {
    constexpr double cell = 16;
    std::map<Cell, std::vector<std::size_t>> grid;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = parts[i];
        const auto index = [](double pixels) {
            return static_cast<int>(std::floor(pixels / cell));
        };
        for (int y = index(std::min(part.a.y, part.b.y) - 1);
             y <= index(std::max(part.a.y, part.b.y) + 1); ++y) {
            for (int x = index(std::min(part.a.x, part.b.x) - 1);
                 x <= index(std::max(part.a.x, part.b.x) + 1); ++x) {
                grid[{y, x}].push_back(i);
            }
        }
    }
    return grid;
}

} // namespace

double longest_overlap(const std::vector<VectorPath>& paths) {
    const std::vector<Part> parts = parts_of(paths);
    // Per pair of paths, the spans where the first runs along the second.
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Span>> spans;
    for (const auto& [cell, members] : grid_of(parts)) {
        for (const std::size_t i : members) {
            for (const std::size_t j : members) {
                if (i == j) continue;
                const auto found = span_along(parts[i], parts[j]);
                if (found) spans[{parts[i].path, parts[j].path}].push_back(*found);
            }
        }
    }
    double longest = 0;
    for (const auto& [pair, found] : spans) longest = std::max(longest, longest_of(found));
    return longest;
}

double total_length(const std::vector<VectorPath>& paths) {
    double length = 0;
    for (const VectorPath& path : paths) {
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            length += glm::distance(path.points[i - 1].at, path.points[i].at);
        }
    }
    return length;
}

std::string flaws_of(const VectorDrawing& drawing) {
    std::ostringstream flaws;
    for (std::size_t i = 0; i < drawing.paths.size(); ++i) {
        const VectorPath& path = drawing.paths[i];
        if (path.points.size() < 2) flaws << "path " << i << " has no length\n";
        if (path.closed && path.points.front().at != path.points.back().at) {
            flaws << "path " << i << " does not close\n";
        }
        std::uint32_t next = 0; // every line of the path has a piece, in order
        for (const VectorPiece& piece : path.pieces) {
            if (piece.point != next && piece.point + 1 != next) {
                flaws << "path " << i << ": pieces jump to " << piece.point << '\n';
            }
            next = piece.point + 1;
        }
        if (next + 1 != path.points.size()) flaws << "path " << i << ": lines without a piece\n";
        for (const VectorPoint& point : path.points) {
            if (!std::isfinite(point.at.x + point.at.y + point.depth + point.arc)) {
                flaws << "path " << i << " is not finite\n";
            }
        }
    }
    return flaws.str();
}

} // namespace lineatlas::test
