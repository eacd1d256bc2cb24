#pragma once

#include "lineatlas/sheet.hpp"

namespace lineatlas {

/// The space that measures need around a view, millimetres.
constexpr double space_for_measures = 24;

/// Draws the overall sizes of a model (ISO 129-1), each once, beside the first aligned view that
/// shows it in its true length; the model's axes beside every view; and a scale bar. Sets
/// VectorSheet::model_size.
void add_measures(VectorSheet& sheet);

} // namespace lineatlas
