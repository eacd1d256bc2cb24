#include "frame_settings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/limits.hpp"
#include "lineatlas/error.hpp"
#include "setting_makers.hpp"

namespace lineatlas {
namespace {

using namespace makers;

constexpr std::string_view automatic = "auto";

FrameSetting method() {
    // What follows `automatic` stands in the order of Method.
    const std::vector<std::string> names{std::string{automatic}, "atlas", "exact", "spine",
                                         "itembuffer",           "opengl"};
    return {"method",
            fmt::format("one of {}", fmt::join(names, ", ")),
            "How visibility is computed; auto is exact, but atlas for sequences of pictures and "
            "where options of samples are given",
            false,
            [names](const FrameSettings& s) -> SettingValue {
                return s.method ? names.at(static_cast<std::size_t>(*s.method) + 1) : names.front();
            },
            [names](FrameSettings& s, const SettingValue& value) {
                const std::string* given = std::get_if<std::string>(&value);
                if (given == nullptr) return false;
                const auto found = std::ranges::find(names, *given);
                if (found == names.end()) return false;
                s.method.reset();
                if (found != names.begin())
                    s.method = static_cast<Method>(found - names.begin() - 1);
                return true;
            },
            names};
}

FrameSetting probes() {
    return {"probes",
            fmt::format("one of {}", fmt::join(probe_counts, ", ")),
            "Depth probes per sample; 1 with low quality",
            false,
            [](const FrameSettings& s) -> SettingValue { return double(s.for_pixels().probes); },
            [](FrameSettings& s, const SettingValue& value) {
                const double* given = std::get_if<double>(&value);
                if (given == nullptr ||
                    std::ranges::find(probe_counts, *given) == probe_counts.end()) {
                    return false;
                }
                s.probes = static_cast<std::uint32_t>(*given);
                return true;
            }};
}

FrameSetting depth_scale() {
    const Range range{1, finest_depth_scale};
    return {
        "depth-scale",
        "a whole number " + words(range),
        "Depth texels per pixel and axis; 1 with low quality, 4 for paths with high",
        false,
        [](const FrameSettings& s) -> SettingValue { return double(s.for_pixels().depth_scale); },
        [range](FrameSettings& s, const SettingValue& value) {
            const double* given = std::get_if<double>(&value);
            if (given == nullptr || !range.contains(*given) || *given != std::floor(*given)) {
                return false;
            }
            s.depth_scale = static_cast<int>(*given);
            return true;
        }};
}

FrameSetting lines() {
    return {
        "lines",
        fmt::format("one or more, separated by commas, of {}", fmt::join(line_kind_names, ", ")),
        "Kinds of line to draw",
        false,
        [](const FrameSettings& s) -> SettingValue { return line_kinds_to_text(s.rest.lines); },
        [](FrameSettings& s, const SettingValue& value) {
            const auto* given = std::get_if<std::string>(&value);
            const auto kinds = given != nullptr ? line_kinds_from(*given) : std::nullopt;
            if (kinds) s.rest.lines = *kinds;
            return kinds.has_value();
        },
        {line_kind_names.begin(), line_kind_names.end()}};
}

std::vector<FrameSetting> make_frame_settings() {
    using F = FrameSettings;
    std::vector<FrameSetting> t;
    t.push_back(lines());
    t.push_back(method());
    t.push_back(choice<F>(
        "quality", [](auto& s) -> auto& { return s.quality; }, {"low", "high"},
        "What probes and depth-scale are unless they are given"));
    t.push_back(probes());
    t.push_back(depth_scale());
    t.push_back(number<F>(
        "step", [](auto& s) -> auto& { return s.rest.step; }, {finest_step, 10'000}, "pixels",
        "Distance of visibility samples along a line"));
    t.push_back(choice<F>(
        "atlas", [](auto& s) -> auto& { return s.rest.atlas; }, {"auto", "raster", "compute"},
        "Where samples are computed"));
    t.push_back(choice<F>(
        "depth", [](auto& s) -> auto& { return s.rest.depth_form; }, {"auto", "raster", "compute"},
        "Where the depth of the triangles, and a fill, are drawn"));
    t.push_back(choice<F>(
        "strokes", [](auto& s) -> auto& { return s.rest.stroke_form; },
        {"auto", "raster", "compute"}, "Where plain strokes are drawn"));
    t.push_back(choice<F>(
        "atlas-layout", [](auto& s) -> auto& { return s.rest.atlas_layout; }, {"wrap", "gutter"},
        "How rows of the atlas end"));
    t.push_back(choice<F>(
        "stroke-shader", [](auto& s) -> auto& { return s.rest.stroke_shader; },
        {"geometry", "vertex"}, "How strokes are widened; one picture"));
    return t;
}

} // namespace

bool FrameSettings::asks_for_samples() const {
    const FrameOptions usual;
    return quality != Quality::high || probes || depth_scale || rest.step != usual.step ||
           rest.atlas != usual.atlas || rest.depth_form != usual.depth_form ||
           rest.atlas_layout != usual.atlas_layout;
}

FrameOptions FrameSettings::for_pixels() const {
    FrameOptions options = rest;
    options.method = method.value_or(asks_for_samples() ? Method::atlas : Method::exact);
    const Sampling usual = sampling_of(quality);
    options.probes = probes.value_or(usual.probes);
    options.depth_scale = depth_scale.value_or(usual.depth_scale);
    return options;
}

FrameOptions FrameSettings::for_sequence() const {
    FrameOptions options = for_pixels();
    options.method = method.value_or(Method::atlas);
    return options;
}

FrameOptions FrameSettings::for_paths(glm::ivec2 size) const {
    FrameOptions options = for_pixels();
    if (!depth_scale) options.depth_scale = depth_scale_of_paths(options.depth_scale, size);
    return options;
}

int depth_scale_of_paths(int depth_scale, glm::ivec2 size) {
    constexpr int largest = 4096; // pixels a side
    const bool finer = depth_scale > 1 && size.x <= largest && size.y <= largest;
    return finer ? finest_depth_scale : depth_scale;
}

std::span<const FrameSetting> frame_settings() {
    static const std::vector<FrameSetting> table = make_frame_settings();
    return table;
}

const FrameSetting& find_frame_setting(std::string_view key) {
    return find_setting(frame_settings(), key, "`lineatlas draw --help`");
}

const std::string& name_of(Method method) {
    return find_frame_setting("method").names.at(static_cast<std::size_t>(method) + 1);
}

std::string frame_settings_table() {
    return markdown_table(frame_settings(), FrameSettings{});
}

std::optional<LineKindMask> line_kinds_from(std::string_view text) {
    LineKindMask kinds = 0;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto found = std::ranges::find(line_kind_names, text.substr(begin, end - begin));
        if (found == line_kind_names.end()) return std::nullopt;
        kinds |= 1U << (found - line_kind_names.begin());
        begin = end + 1;
    }
    return kinds;
}

std::string line_kinds_to_text(LineKindMask kinds) {
    std::vector<std::string_view> names;
    for (std::size_t kind = 0; kind < line_kind_names.size(); ++kind) {
        if ((kinds >> kind & 1U) != 0) names.push_back(line_kind_names.at(kind));
    }
    return fmt::format("{}", fmt::join(names, ","));
}

Silhouettes parse_silhouettes(std::string_view option, const std::string& text) {
    const auto found = std::ranges::find(silhouettes_names, text);
    if (found != silhouettes_names.end())
        return static_cast<Silhouettes>(found - silhouettes_names.begin());
    throw UsageError(
        fmt::format("{} must be {}, not {}", option, fmt::join(silhouettes_names, ", "), text));
}

} // namespace lineatlas
