#pragma once

#include <string>

#include "opencl.hpp"

namespace lineatlas::compute {

/// The standard's name of a status, with its number: "CL_OUT_OF_RESOURCES (-5)".
std::string name_of(cl_int status);

/// Whether a status says that memory, or another resource, has run out.
bool is_shortage(cl_int status);

/// Advice for the user on a status, after "; "; empty if there is none.
std::string advice_on(cl_int status);

} // namespace lineatlas::compute
