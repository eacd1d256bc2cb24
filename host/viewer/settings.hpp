#pragma once

#include <array>
#include <string>

#include "style/frame_settings.hpp"

namespace lineatlas::viewer {

/// How one picture is made; a split screen has two.
struct Side {
    Method method = Method::atlas;
    std::uint32_t probes = sampling_of(Quality::high).probes;
    int depth_scale = sampling_of(Quality::high).depth_scale;
    float step = FrameOptions{}.step;

    bool operator==(const Side&) const = default;
};

struct MethodLabel {
    Method method;
    const char* label; ///< for people
};
inline constexpr std::array<MethodLabel, 5> method_labels{{{Method::atlas, "Segment atlas"},
                                                           {Method::exact, "Exact"},
                                                           {Method::spine, "Spine test"},
                                                           {Method::item_buffer, "Item buffer"},
                                                           {Method::opengl, "OpenGL lines"}}};

inline const char* label_of(Method method) {
    return method_labels.at(static_cast<std::size_t>(method)).label;
}

/// Everything about the pictures but model, camera and device.
struct Settings {
    std::array<Side, 2> sides{{{}, {.method = Method::opengl}}};
    bool split = false;
    float split_at = 0.5F; ///< share of the width that shows the first side
    LineKindMask lines = all_line_kinds;
    std::string style_name; ///< where the style comes from; empty: plain lines
    Style style{};
    bool steady = true;
};

inline FrameOptions frame_options(const Settings& settings, std::size_t side) {
    const Side& chosen = settings.sides.at(side);
    FrameOptions options;
    options.method = chosen.method;
    options.probes = chosen.probes;
    options.depth_scale = chosen.depth_scale;
    options.step = chosen.step;
    options.lines = settings.lines;
    options.style = settings.style;
    // Two pictures in turn have no frame before that they could be averaged with.
    options.steady = settings.steady && !settings.split;
    return options;
}

} // namespace lineatlas::viewer
