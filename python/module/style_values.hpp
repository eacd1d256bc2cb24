#pragma once

#include <filesystem>
#include <optional>
#include <variant>

#include <pybind11/pybind11.h>

#include "lineatlas/style.hpp"
#include "style/settings.hpp"

namespace lineatlas::python {

/// Where a style or its name will do.
using StyleOrName = std::variant<Style, std::filesystem::path>;

Style style_of(const std::optional<StyleOrName>& given);

/// A value of a setting between Python and style files.
SettingValue setting_value(const pybind11::object& value);
pybind11::object python_value(const SettingValue& value);

} // namespace lineatlas::python
