#pragma once

#include <CL/cl_icd.h>

namespace lineatlas::test {

/// Puts the functions of cl_khr_gl_sharing and cl_khr_gl_event into the table.
void add_sharing(cl_icd_dispatch& table);
/// Puts what uses memory objects into the table, with a check that they are acquired.
void add_checks(cl_icd_dispatch& table);

/// The layer's own function of that name, or null.
void* sharing_function(const char* name);

/// What was released on any queue becomes visible to GL.
void arrive_in_gl();

} // namespace lineatlas::test
