#pragma once

#include <array>
#include <cstddef>

#include <glm/vec2.hpp>

#include "lineatlas/renderer.hpp"

namespace lineatlas::viewer {

/// Steps that make a picture cheaper, in this order, while the camera moves and pictures take too
/// long. With each step all steps before it are taken too. At rest no step is taken.
enum class Economy {
    none,
    samples, ///< one probe, and depth as fine as the picture
    effects, ///< no fill, no halos, no limit of density, no heavier outline
    marks,   ///< plain pens, of kinds of lines the same one; no hidden lines
    pixels,  ///< half as many a side, drawn twice as large
    details  ///< no short lines (long_lines.hpp); of large models, once that is prepared
};
inline constexpr std::size_t economies = 6;

/// How many pixels of the window, a side, one of the picture takes.
inline int pixel_size(Economy economy) {
    return economy >= Economy::pixels ? 2 : 1;
}

/// Leaves out of a picture, `size` pixels of the window, what gives way.
void save_time(FrameOptions& options, Economy economy, glm::ivec2 size);

/// Chooses what gives way, so that pictures of a movement take no longer than a thirtieth of a
/// second: by what the last one took, and by what of its time each step has saved before.
class Pace {
  public:
    static constexpr double longest = 1.0 / 30; ///< seconds

    /// A picture took so long until it was shown.
    void note(Economy economy, double seconds);
    /// How to draw the next one of a movement of these options.
    Economy choose(const FrameOptions& options, bool details_may_go);
    /// Whether pictures of the options that were looked at last are too slow with all lines.
    bool falls_short() const { return expected(Economy::pixels) > longest; }

  private:
    double expected(Economy economy) const;
    double share_between(Economy from, Economy to) const;
    void learn(Economy from, Economy to, double ratio);

    Economy last_ = Economy::none; ///< drawn
    double seconds_ = 0;           ///< of pictures like the last one
    std::array<double, 3> recent_{};
    std::size_t count_ = 0; ///< of pictures since what gives way has changed
    /// Of the time of the step before; until they are known, as on two cores without a GPU.
    std::array<double, economies> shares_{1, 0.6, 0.75, 0.85, 0.6, 0.6};
    std::array<bool, economies> saves_{}; ///< of the options that were drawn last
    std::array<bool, economies> drawn_{}; ///< before; the first time makes shaders and tables too
    bool guessed_ = false;                ///< `seconds_` is of such a first one
};

} // namespace lineatlas::viewer
