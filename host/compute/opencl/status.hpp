#pragma once

#include <string>

#include "opencl.hpp"

namespace lineatlas::compute {

/// The standard's name of a status, with its number: "CL_OUT_OF_RESOURCES (-5)".
std::string name_of(cl_int status);

/// Whether it says that memory, or another resource, has run out.
bool is_shortage(cl_int status);

/// What the user can do about it, after "; ", or nothing.
std::string advice_on(cl_int status);

} // namespace lineatlas::compute
