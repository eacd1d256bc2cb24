#pragma once

#include <CL/cl_icd.h>

namespace lineatlas::test {

/// A driver that builds each program once in a process. It is for tests that make hundreds of
/// renderers, because PoCL's compiler reads its own headers again for every program of every
/// renderer.
///
/// Contexts of the same devices are one, because programs belong to a context. Kernels of a program
/// come from the first program that was built from the same source with the same options. `wanted`
/// is read when a context is made. Returns the table to call in place of `driver`; `driver` does
/// not change.
const cl_icd_dispatch& build_once(const cl_icd_dispatch& driver, const bool& wanted);

} // namespace lineatlas::test
