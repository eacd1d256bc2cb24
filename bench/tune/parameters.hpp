#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common.hpp"
#include "compute/opencl/tuning_table.hpp"

namespace lineatlas::bench {

/// A value of the tuning table that is found by measuring.
struct Parameter {
    std::string field;                 ///< its name in the table
    std::vector<std::uint32_t> values; ///< to try; 0 and 1 are false and true
    Rows (*rows_of)(const Devices&);
    std::string row; ///< of bench kernels: what is timed
    std::uint32_t n; ///< its size
    /// Null, or whether the value is used at all by such a tuning.
    bool (*is_used)(const compute::Tuning&);
};

/// In the order in which they are tried: forms before their sizes.
std::vector<Parameter> parameters();

} // namespace lineatlas::bench
