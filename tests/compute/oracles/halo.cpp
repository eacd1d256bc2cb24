#include "halo.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/common.hpp>

namespace lineatlas::test::oracles {
namespace {

float cross(glm::vec2 a, glm::vec2 b) {
    return a.x * b.y - a.y * b.x;
}
float length_of(glm::vec2 v) {
    return std::sqrt(v.x * v.x + v.y * v.y);
}

/// A run on the screen, or a longer one in its place.
struct Line {
    glm::vec2 start, end;

    glm::vec2 way() const { return end - start; }
    float length() const { return length_of(way()); }
};

Line line_of(const Run& run) {
    return {{run.start[0], run.start[1]}, {run.end[0], run.end[1]}};
}

Line lengthened(const Line& line, float at_start, float at_end) {
    const glm::vec2 along = line.way() / line.length();
    return {line.start - along * at_start, line.end + along * at_end};
}

float reach(const HaloInput& in, std::size_t r, bool at_end) {
    return shown_across(in.segments, in.runs, r, at_end) ? 0.0F : LA_HALO_REACH_HIDDEN;
}

struct Crossing {
    float on_r, on_c; ///< shares of the two ways
    float sine;       ///< of the angle between them
};

std::optional<Crossing> find_crossing(const Line& r, const Line& c) {
    const glm::vec2 between = c.start - r.start;
    const float area = cross(r.way(), c.way());
    const float sign = area < 0 ? -1.0F : 1.0F;
    const float size = area * sign;
    const float along_r = cross(between, c.way()) * sign;
    const float along_c = cross(between, r.way()) * sign;
    if (along_r < 0 || along_r > size || along_c < 0 || along_c > size) return std::nullopt;
    const float sine = size / (r.length() * c.length());
    if (!(sine >= LA_HALO_LEAST_SINE)) return std::nullopt;
    return Crossing{along_r / size, along_c / size, sine};
}

bool are_neighbours(std::span<const Segment> segments, std::uint32_t i, std::uint32_t j) {
    const Segment &a = segments[i], &b = segments[j];
    if (i == j || a.p == b.p || a.p == b.q || a.q == b.p || a.q == b.q) return true;
    const auto [low, high] = std::minmax(i, j);
    const bool around =
        (a.tag & LA_TAG_CLOSED) != 0 && segments[low].from_start == 0 && segments[high].to_end == 0;
    return a.path == b.path && (high - low == 1 || around);
}

float inverse_w(const Run& run, const ClippedSegment& segment, float share) {
    const float sample = run.start_sample + (run.end_sample - run.start_sample) * share;
    const float u = std::clamp(sample / static_cast<float>(run.samples), 0.0F, 1.0F);
    const float at_p = 1 / segment.p[3];
    return at_p + (1 / segment.q[3] - at_p) * u;
}

float depth_at(const Run& run, float share) {
    return run.start_depth + (run.end_depth - run.start_depth) * share;
}

using Cut = std::pair<float, float>;

/// A run as the line that is cut and as the line that cuts.
struct Lines {
    Line under, over;
    float before; ///< the length by which `under` is longer at its start

    Lines(const HaloInput& in, std::size_t r) : before(reach(in, r, false)) {
        const Run& run = in.runs[r];
        under = lengthened(line_of(run), before, reach(in, r, true));
        over = lengthened(line_of(run), LA_HALO_REACH_OVER, LA_HALO_REACH_OVER);
    }
};

/// The gap that run c leaves in run r.
std::optional<Cut> find_cut(const HaloInput& in, const Run& r, const Lines& lines_r, const Run& c,
                            const Lines& lines_c) {
    const Line &line = lines_r.under, &other = lines_c.over;
    const float before = lines_r.before;
    const std::optional<Crossing> crossing = find_crossing(line, other);
    if (!crossing || are_neighbours(in.segments, r.segment, c.segment)) return std::nullopt;
    const float at = crossing->on_r * line.length() - before;
    const float share = at / line_of(r).length();
    const float at_c = crossing->on_c * other.length() - LA_HALO_REACH_OVER;
    const float share_c = std::clamp(at_c / line_of(c).length(), 0.0F, 1.0F);
    const float apart =
        in.tolerance * inverse_w(r, in.clipped[r.segment], share) + LA_DEPTH_ROUNDING;
    if (!(depth_at(c, share_c) < depth_at(r, share) - 2 * apart)) return std::nullopt;
    const float stretch =
        std::min(1 / crossing->sine, LA_HALO_STRETCH * LA_HALO_STRETCH * crossing->sine);
    const float half_gap = in.width * stretch;
    const float centre = r.start_arc + at;
    return Cut{centre - half_gap, centre + half_gap};
}

/// Calls `visit` with the index of every square of the picture that the box around a line, a few
/// pixels wider, touches.
template <class Visit>
void for_each_square(const Line& line, glm::ivec2 squares, Visit visit) {
    constexpr float side = 32, margin = 4.5F;
    const auto square_of = [&](glm::vec2 place) {
        return glm::clamp(glm::ivec2{glm::floor(place / side)}, glm::ivec2{0}, squares - 1);
    };
    const glm::ivec2 low = square_of(glm::min(line.start, line.end) - margin);
    const glm::ivec2 high = square_of(glm::max(line.start, line.end) + margin);
    for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
            visit(static_cast<std::size_t>(y * squares.x + x));
        }
    }
}

} // namespace

void halo(const HaloInput& in, std::span<RunCuts> cuts) {
    const glm::ivec2 squares = glm::ivec2{in.viewport} / 32 + 1;
    std::vector<std::vector<std::uint32_t>> passing(static_cast<std::size_t>(squares.x) *
                                                    static_cast<std::size_t>(squares.y));
    const auto has_length = [](const Run& run) { return line_of(run).way() != glm::vec2{0}; };
    std::vector<Lines> lines;
    for (std::size_t r = 0; r < in.runs.size(); ++r) lines.emplace_back(in, r);
    for (std::uint32_t c = 0; c < in.runs.size(); ++c) {
        if (!has_length(in.runs[c])) continue;
        for_each_square(line_of(in.runs[c]), squares,
                        [&](std::size_t square) { passing[square].push_back(c); });
    }
    for (std::size_t r = 0; r < in.runs.size(); ++r) {
        std::vector<Cut> found;
        if (has_length(in.runs[r])) {
            for_each_square(line_of(in.runs[r]), squares, [&](std::size_t square) {
                for (const std::uint32_t c : passing[square]) {
                    const std::optional<Cut> cut =
                        find_cut(in, in.runs[r], lines[r], in.runs[c], lines[c]);
                    if (cut) found.push_back(*cut);
                }
            });
        }
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        found.resize(LA_MOST_CUTS, {0, 0});
        for (std::size_t k = 0; k < LA_MOST_CUTS; ++k) {
            cuts[r].from[k] = found[k].first;
            cuts[r].to[k] = found[k].second;
        }
    }
}

} // namespace lineatlas::test::oracles
