#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <pybind11/pybind11.h>

#include "arguments.hpp"
#include "arrays.hpp"
#include "style/frame_settings.hpp"

namespace lineatlas::python {

/// How visibility is computed. `steady` is off by default, because it makes a picture depend on
/// earlier ones.
using Options = FrameSettings;

/// Options for a picture of pixels, and, more exact, for paths and intervals.
FrameOptions frame_options(const std::optional<Options>& given, const Style& style);
FrameOptions path_options(const std::optional<Options>& given, const Style& style,
                          std::array<int, 2> size);

/// Kinds as "crease,silhouette" or as a list of names; nothing: all kinds.
using LineKinds = std::optional<std::variant<std::string, std::vector<std::string>>>;
using KindsArgument =
    Argument<LineKinds, "lines", "line kinds as \"crease,silhouette\" or as a list">;
/// A crease angle in degrees, or "auto".
using Crease = std::variant<float, std::string>;
using CreaseArgument = Argument<Crease, "crease", "degrees or \"auto\"">;
/// A name of silhouettes_names; nothing: the tool's default.
using MaybeSilhouettes =
    Argument<std::optional<std::string>, "silhouettes", "\"mesh\", \"smooth\" or \"auto\"">;
LineOptions line_options(const LineKinds& kinds, const Crease& crease,
                         const std::optional<std::string>& silhouettes, bool separate_objects);

void bind_options(pybind11::module_& module);

} // namespace lineatlas::python
