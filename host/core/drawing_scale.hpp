#pragma once

#include <string>
#include <string_view>

namespace lineatlas {

/// Reads "1:50" as 0.02. Both numbers must lie between 1e-6 and 1e10. Throws UsageError that names
/// `option`.
double parse_scale(std::string_view option, const std::string& text);

/// The largest scale of ISO 5455 that is no larger than this; empty below 1:5000000000.
std::string standard_scale(double largest);

/// The smallest scale of ISO 5455 that is no smaller than this; empty above 5000000000:1.
std::string enlarging_scale(double smallest);

} // namespace lineatlas
