#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace lineatlas {

/// The value in the middle; of an even number of values the mean of the two there. NaN without
/// values.
inline double median(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// The value below which this share of the values lies: 0.1 for the 10th percentile. It is the
/// nearest of `values`, or NaN without values.
inline double quantile(std::vector<double> values, double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const double last = static_cast<double>(values.size() - 1);
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * last + 0.5);
    std::ranges::nth_element(values, place);
    return *place;
}

} // namespace lineatlas
