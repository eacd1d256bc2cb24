#pragma once

namespace lineatlas::interop {

/// Throws DeviceError, with the way out, unless a call of OpenCL's returned CL_SUCCESS.
void check_handover(int status, const char* call);

} // namespace lineatlas::interop
