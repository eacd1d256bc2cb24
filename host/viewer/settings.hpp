#pragma once

#include <array>
#include <string>
#include <vector>

#include "command_line/session_file.hpp"
#include "lineatlas/style_files.hpp"
#include "shown.hpp"
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
inline constexpr std::array<MethodLabel, 5> method_labels{{{Method::atlas, "Quick"},
                                                           {Method::exact, "Exact"},
                                                           {Method::spine, "Spine test"},
                                                           {Method::item_buffer, "Item buffer"},
                                                           {Method::opengl, "OpenGL lines"}}};

inline const char* label_of(Method method) {
    return method_labels.at(static_cast<std::size_t>(method)).label;
}

/// Everything about the pictures except model, camera and device.
struct Settings {
    std::array<Side, 2> sides{{{}, {.method = Method::opengl}}};
    bool split = false;
    float split_at = 0.5F;               ///< share of the width that shows the first side
    std::optional<LineKindMask> lines{}; ///< FrameOptions::lines
    std::string style_name;              ///< name or path of the style; empty: plain lines
    Style style = default_style();
    Shown shown{};
    bool steady = true;
    /// If the segment atlas is chosen, pictures at rest are drawn by `exact`.
    bool exact_at_rest = true;
    std::vector<SessionFile::NamedView> bookmarks{};
    /// Measured distances, as pairs of points in the model's coordinates.
    std::vector<std::array<glm::dvec3, 2>> distances{};
};

/// Whether two settings draw alike.
bool same(const Settings& a, const Settings& b);

inline FrameOptions frame_options(const Settings& settings, std::size_t side) {
    const Side& chosen = settings.sides.at(side);
    FrameOptions options;
    options.method = chosen.method;
    options.probes = chosen.probes;
    options.depth_scale = chosen.depth_scale;
    options.step = chosen.step;
    options.lines = settings.lines;
    options.style = settings.style;
    // The two pictures of a split screen have no frame before to be averaged with.
    options.steady = settings.steady && !settings.split;
    return options;
}

/// Whether pictures at rest are drawn by another method than those of a movement.
inline bool is_refined(const Settings& settings) {
    return settings.exact_at_rest && !settings.split && settings.sides[0].method == Method::atlas;
}

/// Options of the first side's picture when nothing moves.
inline FrameOptions still_options(const Settings& settings) {
    FrameOptions options = frame_options(settings, 0);
    if (is_refined(settings)) options.method = Method::exact;
    return options;
}

} // namespace lineatlas::viewer
