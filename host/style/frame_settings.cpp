#include "frame_settings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "core/limits.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/style_files.hpp"
#include "setting_makers.hpp"

namespace lineatlas {
namespace {

using namespace makers;

using Option = SettingOf<FrameOptions>;

constexpr std::string_view automatic_lines = "auto";

std::vector<std::string> names_of_lines() {
    std::vector<std::string> names{line_kind_names.begin(), line_kind_names.end()};
    names.emplace_back(automatic_lines);
    return names;
}

Option lines() {
    return {"lines",
            fmt::format("auto, or one or more, separated by commas, of {}",
                        fmt::join(line_kind_names, ", ")),
            "Kinds of line to draw; auto: all but tangent and centre, plus more-lines of the style",
            false,
            [](const FrameOptions& o) -> SettingValue {
                return o.lines ? line_kinds_to_text(*o.lines) : std::string{automatic_lines};
            },
            [](const FrameOptions&) { return true; }, // bits that are no kind select nothing
            [](FrameOptions& o, const SettingValue& value) {
                const auto* given = std::get_if<std::string>(&value);
                const bool is_automatic = given != nullptr && *given == automatic_lines;
                if (is_automatic) o.lines.reset();
                if (is_automatic) return true;
                const auto kinds = given != nullptr ? line_kinds_from(*given) : std::nullopt;
                if (kinds) o.lines = *kinds;
                return kinds.has_value();
            },
            names_of_lines()};
}

Option probes() {
    const auto is_count = [](double given) {
        return std::ranges::find(probe_counts, given) != probe_counts.end();
    };
    return {"probes",
            fmt::format("one of {}", fmt::join(probe_counts, ", ")),
            "Depth probes per sample; 1 with low quality",
            false,
            [](const FrameOptions& o) -> SettingValue { return double(o.probes); },
            [is_count](const FrameOptions& o) { return is_count(o.probes); },
            [is_count](FrameOptions& o, const SettingValue& value) {
                const double* given = std::get_if<double>(&value);
                if (given == nullptr || !is_count(*given)) return false;
                o.probes = static_cast<std::uint32_t>(*given);
                return true;
            }};
}

std::vector<Option> make_options() {
    using F = FrameOptions;
    std::vector<Option> t;
    t.push_back(lines());
    t.push_back(choice<F>(
        "method", [](auto& o) -> auto& { return o.method; },
        {"atlas", "exact", "spine", "item-buffer", "opengl"}, "How visibility is computed"));
    t.push_back(probes());
    t.push_back(whole<F>(
        "depth-scale", [](auto& o) -> auto& { return o.depth_scale; }, {1, finest_depth_scale},
        "Depth texels per pixel and axis; 1 with low quality, 4 for paths with high"));
    t.push_back(number<F>(
        "step", [](auto& o) -> auto& { return o.step; }, {finest_step, longest_step}, "pixels",
        "Distance of visibility samples along a line"));
    t.push_back(choice<F>(
        "atlas", [](auto& o) -> auto& { return o.forms.atlas; }, {"auto", "raster", "compute"},
        "Where samples are computed"));
    t.push_back(choice<F>(
        "depth", [](auto& o) -> auto& { return o.forms.depth; }, {"auto", "raster", "compute"},
        "Where the depth of the triangles, and a fill, are drawn"));
    t.push_back(choice<F>(
        "strokes", [](auto& o) -> auto& { return o.forms.strokes; }, {"auto", "raster", "compute"},
        "Where plain strokes are drawn"));
    return t;
}

/// The settings of a frame that are one member of FrameOptions each.
const std::vector<Option>& options_table() {
    static const std::vector<Option> table = make_options();
    return table;
}

FrameSetting in_rest(const Option& own) {
    return {
        own.key,
        own.values,
        own.help,
        own.flag,
        [get = own.get](const FrameSettings& s) { return get(s.rest); },
        [holds = own.holds](const FrameSettings& s) { return holds(s.rest); },
        [set = own.set](FrameSettings& s, const SettingValue& value) { return set(s.rest, value); },
        own.names};
}

/// A setting whose value follows from other settings unless it is chosen.
template <class T>
FrameSetting chosen(const Option& own, std::optional<T> FrameSettings::*choice,
                    T FrameOptions::*member) {
    return {own.key,
            own.values,
            own.help,
            own.flag,
            [get = own.get](const FrameSettings& s) { return get(s.for_pixels()); },
            [holds = own.holds](const FrameSettings& s) { return holds(s.for_pixels()); },
            [set = own.set, choice, member](FrameSettings& s, const SettingValue& value) {
                FrameOptions options;
                if (!set(options, value)) return false;
                s.*choice = options.*member;
                return true;
            },
            own.names};
}

FrameSetting method(const Option& own) {
    static const std::string automatic = "auto";
    FrameSetting setting = chosen(own, &FrameSettings::method, &FrameOptions::method);
    setting.names.insert(setting.names.begin(), automatic);
    setting.values = fmt::format("one of {}", fmt::join(setting.names, ", "));
    setting.help = "How visibility is computed; auto is atlas for sequences of pictures and with "
                   "options of samples, otherwise exact";
    setting.get = [get = setting.get](const FrameSettings& s) {
        return s.method ? get(s) : SettingValue{automatic};
    };
    setting.set = [set = setting.set](FrameSettings& s, const SettingValue& value) {
        if (value != SettingValue{automatic}) return set(s, value);
        s.method.reset();
        return true;
    };
    return setting;
}

std::vector<FrameSetting> make_frame_settings() {
    using F = FrameSettings;
    std::vector<FrameSetting> t;
    for (const Option& own : options_table()) {
        if (own.key == "method") {
            t.push_back(method(own));
            t.push_back(choice<F>(
                "quality", [](auto& s) -> auto& { return s.quality; }, {"low", "high"},
                "Default of probes and depth-scale"));
        } else if (own.key == "probes") {
            t.push_back(chosen(own, &F::probes, &FrameOptions::probes));
        } else if (own.key == "depth-scale") {
            t.push_back(chosen(own, &F::depth_scale, &FrameOptions::depth_scale));
        } else {
            t.push_back(in_rest(own));
        }
    }
    return t;
}

} // namespace

bool FrameSettings::asks_for_samples() const {
    const FrameOptions usual;
    return quality != Quality::high || probes || depth_scale || rest.step != usual.step ||
           rest.forms.atlas != usual.forms.atlas || rest.forms.depth != usual.forms.depth;
}

FrameOptions FrameSettings::for_pixels() const {
    FrameOptions options = rest;
    options.method = method.value_or(asks_for_samples() ? Method::atlas : Method::exact);
    const Sampling usual = sampling_of(quality);
    options.probes = probes.value_or(usual.probes);
    options.depth_scale = depth_scale.value_or(usual.depth_scale);
    return options;
}

FrameOptions default_frame_options() {
    FrameOptions options = FrameSettings{}.for_pixels();
    options.style = default_style();
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

void check_frame_options(const FrameOptions& options) {
    for (const Option& own : options_table()) check_member(options, own, "");
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
