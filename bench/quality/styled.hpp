#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clipped_lines.hpp"
#include "motion.hpp"
#include "segment_table.h"

// Sparkle of styled drawings: the opacity of the same points of lines, frame by frame.
namespace lineatlas::bench {

/// The renderer's data of a frame with a style.
struct StyledFrame {
    const ClippedLines& clipped;
    std::span<const std::uint8_t> alpha; ///< in sample order
    std::span<const Run> runs;
    std::span<const float> density; ///< weights, see Renderer::Samples; empty: no density control
    glm::ivec2 viewport;
};

/// The opacity of the stroke at every sample, 0 to 1: the share of the sample that runs cover,
/// times the opacity by its visibility, times the weight of density control.
std::vector<float> shown_samples(const StyledFrame& frame);

/// The opacity by visibility alone.
float shown(float visibility);

/// Points of the model at the samples of the first of several frames, which all of the frames show.
struct Tracks {
    std::size_t frames = 0;
    std::vector<std::uint32_t> segments; ///< the segment of each point
    std::vector<float> positions;        ///< per point and frame, in samples of the segment
};

/// Follows points through the frames. Leaves out points that move by more than fastest_pixels
/// between two frames.
Tracks follow_points(std::span<const ClippedLines* const> frames, glm::ivec2 viewport);

/// Figures of how much a drawing changes; means over points and pairs of frames.
struct StyledFigures {
    std::uint64_t changes = 0; ///< points times pairs of consecutive frames
    double sparkle_sum = 0;    ///< of |change - change of the truth|
    double flicker_sum = 0;    ///< of changes that later changes take back
    double jump_sum = 0;       ///< of changes beyond those that a shift of a stroke's end explains
    double shown_sum = 0;      ///< of opacity, over `changes`

    void add(const StyledFigures& other);
    std::optional<double> sparkle() const;
    std::optional<double> flicker() const;
    std::optional<double> jumps() const;
    std::optional<double> mean_shown() const;
};

/// A stroke's end that moves by up to this many samples from frame to frame does not jump.
inline constexpr std::uint32_t most_samples_moved = 2;

/// Strokes with a texture whose darkness changes along the arc.
struct Textures {
    std::vector<StrokeArcs> arcs; ///< of every frame
    float wavelength;             ///< pixels from one darkest place to the next
};

/// The figures of tracked points. shown, truth: opacities of every frame, in sample order. With
/// `textures` the shown opacity is multiplied by the texture of its frame. The true change is
/// multiplied by the texture of the previous frame, because a texture should stay on the line.
/// Jumps count strokes without their texture.
StyledFigures restlessness(const LineSet& lines, std::span<const ClippedLines* const> frames,
                           const Tracks& tracks, std::span<const std::vector<float>> shown,
                           std::span<const std::vector<float>> truth,
                           const std::optional<Textures>& textures = {});

} // namespace lineatlas::bench
