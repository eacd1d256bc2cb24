#include "options.hpp"

#include <algorithm>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "lineatlas/error.hpp"

namespace lineatlas::python {
namespace {

const std::map<std::string, Method> methods{{"atlas", Method::atlas},
                                            {"spine", Method::spine},
                                            {"itembuffer", Method::item_buffer},
                                            {"opengl", Method::opengl}};

Options make_options(const std::string& method, const std::string& quality,
                     std::optional<std::uint32_t> probes, std::optional<int> depth_scale,
                     float step, bool steady) {
    const auto found = methods.find(method);
    if (found == methods.end()) {
        throw UsageError("method \"" + method +
                         "\" is unknown; there is atlas, spine, itembuffer, opengl");
    }
    if (quality != "high" && quality != "low")
        throw UsageError("quality \"" + quality + "\" is unknown; there is high, low");
    Options options{.high = quality == "high", .usual_depth = !depth_scale};
    options.frame.method = found->second;
    options.frame.probes = probes.value_or(options.high ? 9 : 1);
    options.frame.depth_scale = depth_scale.value_or(options.high ? 2 : 1);
    options.frame.step = step;
    options.frame.steady = steady;
    return options;
}

std::string describe(const Options& options) {
    const auto is_method = [&](const auto& entry) { return entry.second == options.frame.method; };
    return fmt::format("Options(method='{}', quality='{}', probes={}, depth_scale={}, step={:.6g}, "
                       "steady={})",
                       std::ranges::find_if(methods, is_method)->first,
                       options.high ? "high" : "low", options.frame.probes,
                       options.frame.depth_scale, options.frame.step,
                       options.frame.steady ? "True" : "False");
}

Options options_of(const std::optional<Options>& given) {
    return given ? *given : make_options("atlas", "high", {}, {}, FrameOptions{}.step, false);
}

std::vector<std::string> names_of(const LineKinds& kinds) {
    if (const auto* list = std::get_if<std::vector<std::string>>(&*kinds)) return *list;
    const std::string& text = std::get<std::string>(*kinds);
    std::vector<std::string> names{""};
    for (const char letter : text) {
        if (letter == ',')
            names.emplace_back();
        else
            names.back() += letter;
    }
    return names;
}

LineKindMask mask_of_name(const std::string& name) {
    const auto found = std::ranges::find(line_kind_names, name);
    if (found == line_kind_names.end()) {
        throw UsageError(fmt::format("there is no line kind \"{}\"; there is {}", name,
                                     fmt::join(line_kind_names, ", ")));
    }
    return 1U << (found - line_kind_names.begin());
}

} // namespace

FrameOptions frame_options(const std::optional<Options>& given, const Style& style) {
    FrameOptions frame = options_of(given).frame;
    frame.style = style;
    return frame;
}

FrameOptions path_options(const std::optional<Options>& given, const Style& style,
                          std::array<int, 2> size) {
    const Options options = options_of(given);
    FrameOptions frame = frame_options(options, style);
    if (frame.method != Method::atlas) throw UsageError("only the method atlas knows intervals");
    // Paths end where the depth buffer has it: it is finer where no GL's limit is in its way.
    constexpr int largest = 4096;
    if (options.high && options.usual_depth && size[0] <= largest && size[1] <= largest)
        frame.depth_scale = 4;
    return frame;
}

LineOptions line_options(const LineKinds& kinds, float crease_degrees) {
    LineOptions options{.crease_angle = crease_degrees * std::numbers::pi_v<float> / 180};
    if (!kinds) return options;
    options.kinds = 0;
    for (const std::string& name : names_of(kinds)) options.kinds |= mask_of_name(name);
    return options;
}

void bind_options(py::module_& module) {
    py::class_<Options>(
        module, "Options",
        "How visibility is computed.\n\n"
        "method: atlas, spine, itembuffer or opengl. quality: high (9 probes per sample, 2 depth\n"
        "texels per pixel and axis, 4 for intervals and paths) or low (1 and 1). probes: 1, 4, 9\n"
        "or 16. depth_scale: 1 to 4. step: pixels between samples. steady: average visibility\n"
        "with that of the frame before where the picture moves slowly; a picture then depends on\n"
        "those before it.")
        .def(py::init(&make_options), py::kw_only(), py::arg("method") = "atlas",
             py::arg("quality") = "high", py::arg("probes") = py::none(),
             py::arg("depth_scale") = py::none(), py::arg("step") = FrameOptions{}.step,
             py::arg("steady") = false)
        .def("__repr__", &describe);
}

} // namespace lineatlas::python
