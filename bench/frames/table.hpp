#pragma once

#include "report.hpp"

namespace lineatlas::bench {

/// Prints Table 1 with this machine's figures beside the paper's, the ratios to OGL likewise,
/// milliseconds, their share per stage, and the goals.
void print_report(const Report& report);

} // namespace lineatlas::bench
