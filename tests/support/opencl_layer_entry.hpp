#pragma once

#include <CL/cl_icd.h>

namespace lineatlas::test {

/// What a layer between the OpenCL loader and the drivers (OPENCL_LAYERS) implements; all else that
/// the loader asks of it is opencl_layer_entry.cpp. `driver` stays; `table`, a copy of it, is what
/// programs call.
void begin_layer(const cl_icd_dispatch& driver, cl_icd_dispatch& table);

} // namespace lineatlas::test
