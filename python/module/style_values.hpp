#pragma once

#include <filesystem>
#include <optional>
#include <variant>

#include <pybind11/pybind11.h>

#include "arguments.hpp"
#include "lineatlas/style.hpp"
#include "style/settings.hpp"

namespace lineatlas::python {

/// A style, or its name or path.
using StyleOrName = std::variant<Style, std::filesystem::path>;
using BaseArgument = Argument<std::optional<std::filesystem::path>, "base",
                              "the name of a style or the path of a style file">;

Style style_of(const std::optional<StyleOrName>& given);

/// A Python object as a value of style files; nothing if style files have no such values.
std::optional<SettingValue> setting_value(const pybind11::object& value);
pybind11::object python_value(const SettingValue& value);

} // namespace lineatlas::python
