#pragma once

#include <StepData_StepModel.hxx>

namespace lineatlas::brep {

/// Puts surfaces of revolution in place of the degenerate tori of a STEP file (ISO 10303-42,
/// degenerate_toroidal_surface), before its shapes are made. Such a torus crosses itself and has an
/// outer part, an apple, and an inner one, a lemon; select_outer says which is meant. Open CASCADE
/// would make both.
void sweep_degenerate_tori(const StepData_StepModel& model);

} // namespace lineatlas::brep
