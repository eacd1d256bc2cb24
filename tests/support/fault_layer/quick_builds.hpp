#pragma once

#include <CL/cl_icd.h>

namespace lineatlas::test {

/// A driver that builds each program once in a process: for tests that make hundreds of renderers,
/// since PoCL's compiler reads its own headers anew for every program of every one of them.
///
/// Contexts of the same devices are one, because programs belong to a context, and kernels of a
/// program come from the first that was built of the same source with the same options. `wanted` is
/// asked when a context is made. Returns the table to call in place of `driver`, which stays.
const cl_icd_dispatch& build_once(const cl_icd_dispatch& driver, const bool& wanted);

} // namespace lineatlas::test
