#pragma once

#include <CL/cl_icd.h>

namespace lineatlas::test {

/// A layer between the OpenCL loader and the drivers (OPENCL_LAYERS) implements this function;
/// opencl_layer_entry.cpp does all else that the loader asks for. `driver` does not change. `table`
/// is a copy of it, and programs call that.
void begin_layer(const cl_icd_dispatch& driver, cl_icd_dispatch& table);

} // namespace lineatlas::test
