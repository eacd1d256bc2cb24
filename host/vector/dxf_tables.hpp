#pragma once

#include <span>
#include <string>
#include <string_view>

#include "dxf_layers.hpp"
#include "dxf_text.hpp"

namespace lineatlas {

/// The name of the application under which extended data of entities stands.
inline constexpr std::string_view dxf_application = "LINEATLAS";

/// Writes tables and blocks, which stand before the lines of a drawing of this size. Returns the
/// handle of the block that lines belong to.
DxfText::Handle write_tables(DxfText& text, const DxfLayers& layers, glm::dvec2 size);

/// The text of a file. `body`: all sections from the tables to the entities. Comments stand before
/// them.
std::string dxf_file(DxfText body, glm::dvec2 size, std::span<const std::string> comments);

} // namespace lineatlas
