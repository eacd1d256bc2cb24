#pragma once

#include <array>
#include <cstddef>

#include <glm/vec2.hpp>

#include "lineatlas/renderer.hpp"

namespace lineatlas::viewer {

/// Steps that make a picture cheaper, in this order, while the camera moves and pictures take too
/// long. A step includes all steps before it. At rest no step is taken.
enum class Economy {
    none,
    samples, ///< one probe, and depth as fine as the picture
    effects, ///< no fill, no halos, no limit of density, no heavier outline
    marks,   ///< plain pens, one for all kinds of line; no hidden lines
    pixels,  ///< half as many pixels a side, drawn twice as large
    details  ///< no short lines (long_lines.hpp); for large models, once these lines are prepared
};
inline constexpr std::size_t economies = 6;

/// The side of a pixel of the picture in pixels of the window.
inline int pixel_size(Economy economy) {
    return economy >= Economy::pixels ? 2 : 1;
}

/// Leaves things out of a picture, as a step says. `size`: pixels of the window.
void save_time(FrameOptions& options, Economy economy, glm::ivec2 size);

/// Chooses the step of economy so that pictures of a movement take no longer than a thirtieth of a
/// second. It knows how long the last pictures took, and which share of the time each step has
/// saved before.
class Pace {
  public:
    static constexpr double longest = 1.0 / 30; ///< seconds

    /// Notes how long a picture took until it was shown.
    void note(Economy economy, double seconds);
    /// The step for the next picture of a movement with these options.
    Economy choose(const FrameOptions& options, bool details_may_go);
    /// Whether pictures of the last options are too slow with all lines.
    bool falls_short() const { return expected(Economy::pixels) > longest; }

  private:
    double expected(Economy economy) const;
    double share_between(Economy from, Economy to) const;
    void learn(Economy from, Economy to, double ratio);

    Economy last_ = Economy::none; ///< drawn
    double seconds_ = 0;           ///< of pictures like the last one
    std::array<double, 3> recent_{};
    std::size_t count_ = 0; ///< of pictures since the step has changed
    /// Time of a step as a share of that of the step before. The first values are those of two
    /// cores without a GPU.
    std::array<double, economies> shares_{1, 0.6, 0.75, 0.85, 0.6, 0.6};
    std::array<bool, economies> saves_{}; ///< whether a step saves anything of the last options
    std::array<bool, economies> drawn_{}; ///< whether a step was drawn before; the first time makes
                                          ///< shaders and tables too
    bool guessed_ = false;                ///< `seconds_` is that of such a first picture
};

} // namespace lineatlas::viewer
