#pragma once

#include <string_view>

#include <CL/cl_icd.h>

namespace lineatlas::test {

/// Puts the functions of cl_khr_gl_sharing, cl_khr_gl_event and cl_khr_external_memory into the
/// table.
void add_sharing(cl_icd_dispatch& table);
/// Puts functions that use memory objects into the table, with a check that the objects are
/// acquired.
void add_checks(cl_icd_dispatch& table);

/// is_sharing_function(): true if the layer has its own function of that name. sharing_function():
/// that function, or null if it is to be missing.
bool is_sharing_function(std::string_view name);
void* sharing_function(std::string_view name);

/// Makes objects that were released on any queue visible to GL.
void arrive_in_gl();

} // namespace lineatlas::test
