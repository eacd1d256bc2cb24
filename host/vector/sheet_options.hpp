#pragma once

#include "lineatlas/sheet.hpp"

namespace lineatlas {

/// Throws UsageError for views that there are not or that are named twice, for none, and for a unit
/// that is no length.
void check_sheet_options(const SheetOptions& options);

} // namespace lineatlas
