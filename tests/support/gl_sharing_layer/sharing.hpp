#pragma once

#include <string_view>

#include <CL/cl_icd.h>

namespace lineatlas::test {

/// Puts the functions of cl_khr_gl_sharing, cl_khr_gl_event and cl_khr_external_memory into the
/// table.
void add_sharing(cl_icd_dispatch& table);
/// Puts what uses memory objects into the table, with a check that they are acquired.
void add_checks(cl_icd_dispatch& table);

/// Whether a function of that name is the layer's own; then it, or null where it is said to lack.
bool is_sharing_function(std::string_view name);
void* sharing_function(std::string_view name);

/// What was released on any queue becomes visible to GL.
void arrive_in_gl();

} // namespace lineatlas::test
