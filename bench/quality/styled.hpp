#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clipped_lines.hpp"
#include "motion.hpp"
#include "segment_table.h"

// What a style makes of sparkle: how much is drawn of the same points of lines, frame by frame.
namespace lineatlas::bench {

/// What the renderer says of a frame with a style.
struct StyledFrame {
    const ClippedLines& clipped;
    std::span<const std::uint8_t> alpha; ///< in sample order
    std::span<const Run> runs;
    std::span<const float> density; ///< weights, see Renderer::Samples; empty: all is drawn
    glm::ivec2 viewport;
};

/// The opacity of the stroke at every sample, 0 to 1: how much of the sample runs cover, times
/// the opacity that its visibility gives, times what density control leaves.
std::vector<float> shown_samples(const StyledFrame& frame);

/// The same opacity where nothing but visibility counts.
float shown(float visibility);

/// Points of the model that are samples of the first of a row of frames and seen in all of them.
struct Tracks {
    std::size_t frames = 0;
    std::vector<std::uint32_t> segments; ///< of each point
    std::vector<float> positions;        ///< per point and frame, counted in samples of the segment
};

/// Points that move by more than fastest_pixels between two frames are left out.
Tracks follow_points(std::span<const ClippedLines* const> frames, glm::ivec2 viewport);

/// How restless what is drawn is; means over points and pairs of frames.
struct StyledFigures {
    std::uint64_t changes = 0; ///< points times pairs of consecutive frames
    double sparkle_sum = 0;    ///< of |change - change of the truth|
    double flicker_sum = 0;    ///< of what of the changes later ones take back
    double jump_sum = 0;       ///< of what of a change no shift of a few pixels explains
    double shown_sum = 0;      ///< of opacity, over `changes`

    void add(const StyledFigures& other);
    std::optional<double> sparkle() const;
    std::optional<double> flicker() const;
    std::optional<double> jumps() const;
    std::optional<double> mean_shown() const;
};

/// An end of a stroke that moves by this many samples from frame to frame does not jump.
inline constexpr std::uint32_t most_samples_moved = 2;

/// Strokes with a texture: how dark it is changes along the arc.
struct Textures {
    std::vector<StrokeArcs> arcs; ///< of every frame
    float wavelength;             ///< pixels from one darkest place to the next
};

/// shown, truth: of every frame, in sample order; truth as opacity too. With textures what is shown
/// gets the texture where it lies in that frame, and its true change the texture of the frame
/// before, as if it lay on the line. Jumps are of strokes, whatever is on them.
StyledFigures restlessness(const LineSet& lines, std::span<const ClippedLines* const> frames,
                           const Tracks& tracks, std::span<const std::vector<float>> shown,
                           std::span<const std::vector<float>> truth,
                           const std::optional<Textures>& textures = {});

} // namespace lineatlas::bench
