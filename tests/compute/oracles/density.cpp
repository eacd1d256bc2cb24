#include "density.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include <glm/common.hpp>

#include "compute/stages/stages.hpp"

namespace lineatlas::test::oracles {
namespace {

/// The sums of one bin, a value per cell.
struct Plane {
    glm::ivec2 cells;
    std::vector<std::uint32_t> values;

    explicit Plane(glm::ivec2 size)
        : cells(size), values(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {
    }

    /// The value of a cell; beside the grid that of the nearest cell.
    std::uint32_t& at(int x, int y) {
        x = std::clamp(x, 0, cells.x - 1);
        y = std::clamp(y, 0, cells.y - 1);
        return values[static_cast<std::size_t>(y * cells.x + x)];
    }
};

/// A logarithm that is linear between powers of two, for x >= 1.
float rough_log2(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return static_cast<float>((bits >> 23U) - 127) +
           static_cast<float>(bits & 0x7FFFFFU) * 0x1p-23F;
}

/// Pseudo-random, 0 to below 1.
float chance(std::uint32_t x) {
    x = (x ^ (x >> 16U)) * 0x85EBCA6BU;
    x = (x ^ (x >> 13U)) * 0xC2B2AE35U;
    x ^= x >> 16U;
    return static_cast<float>(x >> 8U) * 0x1p-24F;
}

/// In 1/LA_BIN_STEPS of a bin.
std::uint32_t priority_of(const DensityInput& in, std::uint32_t i) {
    const Segment& segment = in.segments[i];
    const std::uint32_t kind = segment.tag & LA_TAG_KIND_MASK;
    const std::uint32_t units = in.arcs[i + segment.to_end + 1] - in.arcs[i - segment.from_start];
    const float pixels = static_cast<float>(units) / LA_ARC_UNITS_PER_PIXEL;
    const float length = std::min(rough_log2(1 + pixels / 16) * (1.0F / 6), 1.0F);
    const float tie = kind == LA_KIND_SILHOUETTE ? 0.5F : chance(segment.path); // chains change
    constexpr std::uint32_t most = (LA_DENSITY_BINS - 1) * LA_BIN_STEPS;
    const float priority = LA_PRIORITY_KIND * std::clamp(in.density.priority[kind], 0.0F, 1.0F) +
                           LA_PRIORITY_LENGTH * length + LA_PRIORITY_CHANCE * tie;
    return std::min(static_cast<std::uint32_t>(priority * float{most} + 0.5F), most);
}

/// A stretch of a run with the same opacity everywhere.
struct Piece {
    float from, to; ///< counted in samples of the run
    float opacity;
};

/// A run as stretches of one sample. first, last: the positions at its ends.
struct Pieces {
    float first, last;
    std::vector<Piece> list{};
};

Pieces pieces_of(const Run& run, float length, std::span<const std::uint8_t> alpha) {
    constexpr float solid_step = 2;
    const bool solid = (run.flags & LA_RUN_SOLID) != 0;
    Pieces result{.first = solid ? 0 : run.start_sample,
                  .last = solid ? length / solid_step : run.end_sample};
    for (int j = static_cast<int>(std::floor(result.first)); static_cast<float>(j) < result.last;
         ++j) {
        float opacity = 1;
        if (!solid) {
            const int sample = std::clamp(j, 0, static_cast<int>(run.samples) - 1);
            const std::uint8_t a = alpha[run.address + static_cast<std::uint32_t>(sample)];
            opacity = std::min(static_cast<float>(a) * (3.0F / 255), 1.0F);
        }
        result.list.push_back({std::max(static_cast<float>(j), result.first),
                               std::min(static_cast<float>(j + 1), result.last), opacity});
    }
    return result;
}

using Bins = std::vector<Plane>;

/// Adds length to one cell, shared out between the bins on either side of the priority.
void add(Bins& bins, std::uint32_t priority, glm::ivec2 cell, float pixels) {
    const auto units = static_cast<std::uint32_t>(pixels * LA_DENSITY_UNITS_PER_PIXEL + 0.5F);
    const std::uint32_t bin = priority / LA_BIN_STEPS, above = priority % LA_BIN_STEPS;
    const auto of_next = static_cast<std::uint32_t>(std::uint64_t{units} * above / LA_BIN_STEPS);
    bins[bin].at(cell.x, cell.y) += units - of_next;
    if (above != 0) bins[bin + 1].at(cell.x, cell.y) += of_next;
}

/// Adds the length of a run. The length is shared among the four cells around each piece, and
/// rounded once for each group of four cells.
void add_run(Bins& bins, const Run& run, std::uint32_t priority,
             std::span<const std::uint8_t> alpha) {
    const glm::vec2 start{run.start[0], run.start[1]};
    const glm::vec2 way = glm::vec2{run.end[0], run.end[1]} - start;
    const float length = std::sqrt(way.x * way.x + way.y * way.y);
    if (!(length > 0)) return;
    const Pieces pieces = pieces_of(run, length, alpha);
    const float count = pieces.last - pieces.first;
    glm::ivec2 corner{0};
    std::array<float, 4> sums{};
    const auto flush = [&] {
        for (int k = 0; k < 4; ++k) {
            add(bins, priority, corner + glm::ivec2{k % 2, k / 2},
                sums[static_cast<std::size_t>(k)]);
        }
        sums = {};
    };
    for (const Piece& piece : pieces.list) {
        if (piece.opacity == 0) continue;
        const float drawn = (piece.to - piece.from) * (length / count) * piece.opacity;
        const float share = ((piece.from + piece.to) * 0.5F - pieces.first) / count;
        const glm::vec2 place = (start + way * share) / float{LA_DENSITY_CELL} - 0.5F;
        const glm::vec2 up = place - glm::floor(place), down = 1.0F - up;
        if (glm::ivec2{glm::floor(place)} != corner) flush();
        corner = glm::ivec2{glm::floor(place)};
        sums[0] += drawn * (down.x * down.y);
        sums[1] += drawn * (up.x * down.y);
        sums[2] += drawn * (down.x * up.y);
        sums[3] += drawn * (up.x * up.y);
    }
    flush();
}

/// The weighted sum over five by five cells.
std::uint32_t smooth(Plane& plane, int x, int y) {
    std::uint32_t sum = 0;
    for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
            const int weight = (3 - std::abs(dx)) * (3 - std::abs(dy));
            sum += static_cast<std::uint32_t>(weight) * plane.at(x + dx, y + dy);
        }
    }
    return sum;
}

float limit_at(const DensityInput& in, glm::vec2 place) {
    if (!(in.focus.w > 0)) return in.density.limit;
    const glm::vec2 away = place - glm::vec2{in.focus.x, in.focus.y};
    const float distance = std::sqrt(away.x * away.x + away.y * away.y);
    const float t = std::clamp((distance - in.focus.z) / in.focus.w, 0.0F, 1.0F);
    return in.density.limit * (1 + (in.far_limit - 1) * (t * t * (3 - 2 * t)));
}

/// The mean of a ramp from 1 at allowed - soft to 0 at allowed + soft.
float mean_weight(float before, float own, float allowed, float soft) {
    const float whole = std::clamp(allowed - soft - before, 0.0F, own);
    const float from = std::max(before, allowed - soft);
    const float to = std::min(before + own, allowed + soft);
    if (!(to > from)) return whole / own;
    const float at_middle = (allowed + soft - (from + to) * 0.5F) / (2 * soft);
    return (whole + (to - from) * at_middle) / own;
}

/// The limit of a cell, in the units of smoothed sums.
float allowed_in(const DensityInput& in, int x, int y) {
    const glm::vec2 centre = (glm::vec2{x, y} + 0.5F) * float{LA_DENSITY_CELL};
    return limit_at(in, centre) *
           (LA_DENSITY_UNITS_PER_PIXEL * LA_DENSITY_TENT * LA_DENSITY_CELL * LA_DENSITY_CELL);
}

/// A value per cell.
using Cells = std::vector<float>;

/// The largest value about a cell.
float most_about(const Cells& values, glm::ivec2 cells, int x, int y) {
    float most = 0;
    for (int v = std::max(y - 2, 0); v <= std::min(y + 2, cells.y - 1); ++v) {
        for (int u = std::max(x - 2, 0); u <= std::min(x + 2, cells.x - 1); ++u) {
            most = std::max(most, values[static_cast<std::size_t>(v * cells.x + u)]);
        }
    }
    return most;
}

/// The weights of every bin; returns the length that they leave in each cell.
Cells share_out(const DensityInput& in, Bins& bins, const Cells& excess, std::span<float> weights) {
    const glm::ivec2 cells = bins[0].cells;
    const std::size_t plane = bins[0].values.size();
    Cells drawn(plane);
    for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x) {
            const auto cell = static_cast<std::size_t>(y * cells.x + x);
            const float allowed = allowed_in(in, x, y) / (1 + most_about(excess, cells, x, y));
            float before = 0;
            for (std::size_t bin = LA_DENSITY_BINS; bin-- > 0;) {
                const float own = std::max(static_cast<float>(smooth(bins[bin], x, y)), 1.0F);
                const float weight =
                    mean_weight(before, own, allowed, allowed * LA_DENSITY_SOFTNESS);
                weights[bin * plane + cell] = weight;
                drawn[cell] += weight * static_cast<float>(bins[bin].values[cell]);
                before += own;
            }
        }
    }
    return drawn;
}

/// The excess about each cell: the length that is left beyond the limit, as a share of the limit.
Cells excess_of(const DensityInput& in, glm::ivec2 cells, const Cells& drawn) {
    const auto drawn_at = [&](int x, int y) {
        return drawn[static_cast<std::size_t>(std::clamp(y, 0, cells.y - 1) * cells.x +
                                              std::clamp(x, 0, cells.x - 1))];
    };
    Cells excess;
    for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x) {
            float left = 0;
            for (int dy = -2; dy <= 2; ++dy) {
                for (int dx = -2; dx <= 2; ++dx) {
                    const auto share = static_cast<float>((3 - std::abs(dx)) * (3 - std::abs(dy)));
                    left += share * drawn_at(x + dx, y + dy);
                }
            }
            const float allowed = allowed_in(in, x, y);
            excess.push_back(std::max(left / (allowed * LA_DENSITY_TOLERATED) - 1, 0.0F));
        }
    }
    return excess;
}

} // namespace

void density(const DensityInput& in, std::span<Run> runs, std::span<float> weights) {
    const glm::ivec2 cells = compute::density_cells(in.viewport);
    Bins bins(LA_DENSITY_BINS, Plane{cells});
    for (Run& run : runs) {
        const std::uint32_t priority = priority_of(in, run.segment);
        run.flags &= ~(LA_RUN_BIN_MASK << LA_RUN_BIN_SHIFT);
        run.flags |= priority << LA_RUN_BIN_SHIFT;
        add_run(bins, run, priority, in.alpha);
    }
    const Cells drawn = share_out(in, bins, Cells(bins[0].values.size()), weights);
    share_out(in, bins, excess_of(in, cells, drawn), weights);
}

} // namespace lineatlas::test::oracles
