#pragma once

#include "lineatlas/sheet.hpp"

namespace lineatlas {

/// Throws UsageError for views that do not exist or are named twice, if there are no views, and for
/// a unit that is no length.
void check_sheet_options(const SheetOptions& options);

} // namespace lineatlas
