#pragma once

#include <string_view>

#include "dxf_layers.hpp"
#include "dxf_text.hpp"

namespace lineatlas {

/// Under this name extended data of entities says what they show.
inline constexpr std::string_view dxf_application = "LINEATLAS";

/// What stands before the lines of a drawing of this size: tables and blocks. Returns the handle of
/// the block that lines belong to.
DxfText::Handle write_tables(DxfText& text, const DxfLayers& layers, glm::dvec2 size);

/// What stands behind them.
void write_objects(DxfText& text);

/// The file's first section. `last`: the largest handle in the others.
DxfText dxf_header(glm::dvec2 size, DxfText::Handle last);

} // namespace lineatlas
