#include "options.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join
#include <pybind11/stl.h>

#include "lineatlas/error.hpp"
#include "style/frame_settings.hpp"
#include "style_values.hpp"

namespace lineatlas::python {
namespace {

/// "depth_scale" for "depth-scale".
std::string python_name(std::string key) {
    std::ranges::replace(key, '-', '_');
    return key;
}

/// True for settings of Options. Kinds of line are arguments of Renderer.
bool is_option(const FrameSetting& setting) {
    return setting.key != "lines";
}

/// Options with the given values. None leaves the default.
Options make_options(const py::object& method, const py::object& quality, const py::object& probes,
                     const py::object& depth_scale, const py::object& step, const py::object& atlas,
                     const py::object& depth, const py::object& strokes, Flag<"steady"> steady) {
    Options options;
    options.rest.steady = steady;
    const auto set = [&](const char* key, const py::object& value) {
        if (value.is_none()) return;
        const FrameSetting& setting = find_frame_setting(key);
        const std::optional<SettingValue> given = setting_value(value);
        if (!given) throw wrong_argument(python_name(key), setting.values, value);
        set_value(options, setting, *given, python_name(key));
    };
    set("method", method);
    set("quality", quality);
    set("probes", probes);
    set("depth-scale", depth_scale);
    set("step", step);
    set("atlas", atlas);
    set("depth", depth);
    set("strokes", strokes);
    return options;
}

std::string describe(const Options& options) {
    std::string text = "Options(";
    for (const FrameSetting& setting : frame_settings()) {
        if (!is_option(setting)) continue;
        const SettingValue value = setting.get(options);
        const bool word = std::holds_alternative<std::string>(value);
        text += python_name(setting.key) + "=" +
                (word ? std::string{py::repr(python_value(value))} : value_to_toml(value)) + ", ";
    }
    return text + "steady=" + (options.rest.steady ? "True)" : "False)");
}

std::string documentation() {
    std::string text = "How visibility is computed.\n";
    for (const FrameSetting& setting : frame_settings()) {
        if (!is_option(setting)) continue;
        text +=
            fmt::format("\n{}: {}; {}.", python_name(setting.key), setting.help, setting.values);
    }
    return text + "\nsteady: Average visibility with that of the frame before where the picture "
                  "moves slowly;\na picture then depends on those before it.";
}

Options options_of(const std::optional<Options>& given) {
    if (given) return *given;
    Options options;
    options.rest.steady = false;
    return options;
}

std::optional<float> crease_angle(const Crease& crease) {
    if (const auto* word = std::get_if<std::string>(&crease)) {
        if (*word == "auto") return std::nullopt;
        throw wrong_argument("crease", "degrees or \"auto\"", py::str(*word));
    }
    const float degrees = std::get<float>(crease);
    if (degrees >= 0 && degrees <= 180) return degrees * std::numbers::pi_v<float> / 180;
    throw UsageError(fmt::format("crease must be from 0 to 180 degrees, not {}", degrees));
}

LineKindMask mask_of_names(const std::string& names) {
    if (const std::optional<LineKindMask> kinds = line_kinds_from(names)) return *kinds;
    throw UsageError(fmt::format("there is no line kind \"{}\"; there is {}", names,
                                 fmt::join(line_kind_names, ", ")));
}

} // namespace

FrameOptions frame_options(const std::optional<Options>& given, const Style& style) {
    FrameOptions frame = options_of(given).for_pixels();
    frame.style = style;
    return frame;
}

FrameOptions path_options(const std::optional<Options>& given, const Style& style,
                          std::array<int, 2> size) {
    FrameOptions frame = options_of(given).for_paths({size[0], size[1]});
    if (frame.method != Method::atlas && frame.method != Method::exact)
        throw UsageError("only the methods atlas and exact know intervals");
    frame.style = style;
    return frame;
}

LineOptions line_options(const LineKinds& kinds, const Crease& crease,
                         const std::optional<std::string>& silhouettes, bool separate_objects) {
    LineOptions options{.crease = crease_angle(crease),
                        .separate_objects = separate_objects,
                        .silhouettes = silhouettes ? parse_silhouettes("silhouettes", *silhouettes)
                                                   : LineOptions{}.silhouettes};
    if (!kinds) return options;
    if (const auto* text = std::get_if<std::string>(&*kinds)) {
        options.lines = mask_of_names(*text);
        return options;
    }
    options.lines = 0;
    for (const std::string& name : std::get<std::vector<std::string>>(*kinds))
        options.lines |= mask_of_names(name);
    return options;
}

void bind_options(py::module_& module) {
    const Options defaults;
    const auto usual = [&](const char* key) {
        return python_value(find_frame_setting(key).get(defaults));
    };
    py::class_<Options>(module, "Options", documentation().c_str())
        .def(py::init(&make_options), py::kw_only(), py::arg("method") = usual("method"),
             py::arg("quality") = usual("quality"), py::arg("probes") = py::none(),
             py::arg("depth_scale") = py::none(), py::arg("step") = usual("step"),
             py::arg("atlas") = usual("atlas"), py::arg("depth") = usual("depth"),
             py::arg("strokes") = usual("strokes"), py::arg("steady") = false)
        .def("__repr__", &describe);
}

} // namespace lineatlas::python
