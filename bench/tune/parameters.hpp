#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common.hpp"
#include "compute/opencl/tuning_table.hpp"

namespace lineatlas::bench {

/// A value of the tuning table that measuring finds.
struct Parameter {
    std::string field;                 ///< its name in the table
    std::vector<std::uint32_t> values; ///< candidates; 0 and 1 stand for false and true
    Rows (*rows_of)(const Devices&);
    std::string row; ///< the row of bench kernels that is timed
    std::uint32_t n; ///< the size of the row, in elements
    /// True if the tuning uses the value; null: every tuning does.
    bool (*is_used)(const compute::Tuning&);
};

/// All parameters in the order of measuring: forms before sizes of forms.
std::vector<Parameter> parameters();

} // namespace lineatlas::bench
