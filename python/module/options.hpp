#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <pybind11/pybind11.h>

#include "arrays.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas::python {

/// How visibility is computed. What is left out of it depends on what it is for.
struct Options {
    FrameOptions frame{};
    bool high = true;
    bool usual_depth = true; ///< depth_scale was not given
};

/// For a picture of pixels or, more exactly, for its lines as paths or intervals.
FrameOptions frame_options(const std::optional<Options>& given, const Style& style);
FrameOptions path_options(const std::optional<Options>& given, const Style& style,
                          std::array<int, 2> size);

/// "crease,silhouette" or a list of such names; nothing: all.
using LineKinds = std::optional<std::variant<std::string, std::vector<std::string>>>;
LineOptions line_options(const LineKinds& kinds, float crease_degrees);

void bind_options(pybind11::module_& module);

} // namespace lineatlas::python
