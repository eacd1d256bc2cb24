#pragma once

#include "report.hpp"

namespace lineatlas::bench {

/// The paper's Table 1 with our figures beside the paper's, the ratios to OGL likewise,
/// milliseconds, where they go, and the goals.
void print_report(const Report& report);

} // namespace lineatlas::bench
