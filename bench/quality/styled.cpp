#include "styled.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "shared/constants.h"

namespace lineatlas::bench {
namespace {

/// The weights of density control, looked up as in the stroke shader.
class Weights {
  public:
    Weights(std::span<const float> values, glm::ivec2 viewport)
        : values_(values), cells_((viewport + (LA_DENSITY_CELL - 1)) / LA_DENSITY_CELL) {}

    float at(std::uint32_t priority, glm::vec2 place) const {
        if (values_.empty()) return 1;
        const std::uint32_t bin = priority / LA_BIN_STEPS;
        const float share = static_cast<float>(priority % LA_BIN_STEPS) / float{LA_BIN_STEPS};
        const float weight = of_bin(bin, place);
        return share > 0 ? std::lerp(weight, of_bin(bin + 1, place), share) : weight;
    }

  private:
    float of_bin(std::uint32_t bin, glm::vec2 place) const {
        const glm::vec2 x = place / float{LA_DENSITY_CELL} - 0.5F;
        const glm::ivec2 low{glm::floor(x)};
        const glm::vec2 up = x - glm::vec2{low};
        const auto of_cell = [&](int dx, int dy) {
            const glm::ivec2 cell = glm::clamp(low + glm::ivec2{dx, dy}, glm::ivec2{0}, cells_ - 1);
            return values_[static_cast<std::size_t>(
                (static_cast<int>(bin) * cells_.y + cell.y) * cells_.x + cell.x)];
        };
        return std::lerp(std::lerp(of_cell(0, 0), of_cell(1, 0), up.x),
                         std::lerp(of_cell(0, 1), of_cell(1, 1), up.x), up.y);
    }

    std::span<const float> values_;
    glm::ivec2 cells_;
};

/// The value at a position: linear between the centres of samples, constant beyond the outer ones.
float interpolated(std::span<const float> samples, float position) {
    const float most = static_cast<float>(samples.size() - 1);
    const float x = std::clamp(position - 0.5F, 0.0F, most);
    const auto low = static_cast<std::size_t>(x);
    const std::size_t high = std::min(low + 1, samples.size() - 1);
    return std::lerp(samples[low], samples[high], x - static_cast<float>(low));
}

std::span<const float> own_samples(const ClippedLines& frame, const std::vector<float>& values,
                                   std::uint32_t segment) {
    return std::span{values}.subspan(frame.offsets[segment], frame.samples(segment));
}

/// The smallest and the largest sample about a position, also beyond the segment's ends along the
/// path.
std::pair<float, float> range_about(const LineSet& lines, const ClippedLines& frame,
                                    const std::vector<float>& values, std::uint32_t segment,
                                    float position) {
    const Segment& own = lines.segments[segment];
    const std::uint32_t path_first = frame.offsets[segment - own.from_start];
    const std::uint32_t path_last = frame.offsets[segment + own.to_end + 1] - 1;
    const std::uint32_t l = frame.samples(segment);
    const auto centre = frame.offsets[segment] +
                        static_cast<std::uint32_t>(std::clamp(position, 0.0F, float(l) - 0.5F));
    const std::uint32_t reach = most_samples_moved;
    const std::uint32_t low = centre - std::min(reach, centre - path_first);
    const std::uint32_t high = std::min(centre + reach, path_last);
    const auto [least, most] = std::minmax_element(values.begin() + low, values.begin() + high + 1);
    return {*least, *most};
}

/// Sets the positions of a point of a segment in all frames. False if a frame does not show the
/// point, or if it moves too fast.
bool follow(std::span<const ClippedLines* const> frames, glm::ivec2 viewport, std::uint32_t segment,
            double parameter, std::vector<float>& positions) {
    positions.clear();
    std::optional<glm::dvec2> place_before;
    for (const ClippedLines* frame : frames) {
        const std::uint32_t l = frame->samples(segment);
        if (l == 0) return false;
        const auto share = share_at(frame->clipped[segment], parameter);
        if (!share) return false;
        const glm::dvec2 place = window_segment(frame->clipped[segment], viewport).at(*share);
        if (place_before && glm::distance(place, *place_before) > fastest_pixels) return false;
        place_before = place;
        positions.push_back(static_cast<float>(*share * l));
    }
    return true;
}

std::optional<double> mean(double sum, std::uint64_t count) {
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count);
}

} // namespace

float shown(float visibility) {
    return std::min(visibility * 3, 1.0F); // shaders/mark.glsl
}

std::vector<float> shown_samples(const StyledFrame& frame) {
    const Weights weights{frame.density, frame.viewport};
    std::vector<float> result(frame.clipped.offsets.back());
    for (const Run& run : frame.runs) {
        const std::uint32_t first = frame.clipped.offsets[run.segment];
        const std::uint32_t l = frame.clipped.samples(run.segment);
        const WindowSegment place =
            window_segment(frame.clipped.clipped[run.segment], frame.viewport);
        const std::uint32_t priority = run.flags >> LA_RUN_BIN_SHIFT & LA_RUN_BIN_MASK;
        const auto begin = static_cast<std::uint32_t>(std::clamp(run.start_sample, 0.0F, float(l)));
        for (std::uint32_t j = begin; j < l && static_cast<float>(j) < run.end_sample; ++j) {
            const float covered = std::min(run.end_sample, static_cast<float>(j + 1)) -
                                  std::max(run.start_sample, static_cast<float>(j));
            const float opacity = shown(static_cast<float>(frame.alpha[first + j]) / 255);
            if (opacity == 0) continue;
            result[first + j] +=
                covered * opacity * weights.at(priority, glm::vec2{place.at((j + 0.5) / l)});
        }
    }
    for (float& sample : result) sample = std::min(sample, 1.0F);
    return result;
}

Tracks follow_points(std::span<const ClippedLines* const> frames, glm::ivec2 viewport) {
    Tracks tracks{frames.size(), {}, {}};
    const ClippedLines& start = *frames.front();
    std::vector<float> positions;
    for (std::uint32_t i = 0; i < start.clipped.size(); ++i) {
        const std::uint32_t l = start.samples(i);
        for (std::uint32_t j = 0; j < l; ++j) {
            const double parameter = parameter_at(start.clipped[i], (j + 0.5) / l);
            if (!follow(frames, viewport, i, parameter, positions)) continue;
            tracks.segments.push_back(i);
            tracks.positions.insert(tracks.positions.end(), positions.begin(), positions.end());
        }
    }
    return tracks;
}

void StyledFigures::add(const StyledFigures& other) {
    changes += other.changes;
    sparkle_sum += other.sparkle_sum;
    flicker_sum += other.flicker_sum;
    jump_sum += other.jump_sum;
    shown_sum += other.shown_sum;
}

std::optional<double> StyledFigures::sparkle() const {
    return mean(sparkle_sum, changes);
}
std::optional<double> StyledFigures::flicker() const {
    return mean(flicker_sum, changes);
}
std::optional<double> StyledFigures::jumps() const {
    return mean(jump_sum, changes);
}
std::optional<double> StyledFigures::mean_shown() const {
    return mean(shown_sum, changes);
}

StyledFigures restlessness(const LineSet& lines, std::span<const ClippedLines* const> frames,
                           const Tracks& tracks, std::span<const std::vector<float>> shown,
                           std::span<const std::vector<float>> truth,
                           const std::optional<Textures>& textures) {
    StyledFigures figures;
    for (std::size_t k = 0; k < tracks.segments.size(); ++k) {
        const std::uint32_t segment = tracks.segments[k];
        const auto position = [&](std::size_t f) {
            return tracks.positions[k * tracks.frames + f];
        };
        const auto at = [&](std::span<const std::vector<float>> values, std::size_t f) {
            return double{interpolated(own_samples(*frames[f], values[f], segment), position(f))};
        };
        // Places without a stroke have opacity 0, so any texture coordinate will do.
        const auto ink = [&](std::size_t f) {
            if (!textures) return 1.0;
            const double arc = textures->arcs[f].at(segment, position(f)).value_or(0);
            return 0.5 + 0.5 * std::cos(2 * std::numbers::pi * arc / textures->wavelength);
        };
        double changed = 0;
        for (std::size_t f = 1; f < tracks.frames; ++f) {
            const double now = at(shown, f);
            const double change = now * ink(f) - at(shown, f - 1) * ink(f - 1);
            const double true_change = (at(truth, f) - at(truth, f - 1)) * ink(f - 1);
            const auto [least, most] =
                range_about(lines, *frames[f - 1], shown[f - 1], segment, position(f - 1));
            ++figures.changes;
            figures.sparkle_sum += std::abs(change - true_change);
            figures.jump_sum += std::max({0.0, now - most, least - now});
            figures.shown_sum += now * ink(f);
            changed += std::abs(change);
        }
        const std::size_t last = tracks.frames - 1;
        const double net = at(shown, last) * ink(last) - at(shown, 0) * ink(0);
        figures.flicker_sum += 0.5 * (changed - std::abs(net));
    }
    return figures;
}

} // namespace lineatlas::bench
