#pragma once

#include <pybind11/pybind11.h>

// The parts of the module. Each function binds one of them.
namespace lineatlas::python {

void bind_errors(pybind11::module_& module);
void bind_mesh(pybind11::module_& module);
void bind_view(pybind11::module_& module);
void bind_sequences(pybind11::module_& module);
void bind_style(pybind11::module_& module);
void bind_renderer(pybind11::module_& module);
void bind_files(pybind11::module_& module);

/// Makes all bound functions name an unknown keyword argument in one line, instead of pybind11's
/// list of signatures. Call it after everything is bound.
void name_unknown_arguments(pybind11::module_& module);

} // namespace lineatlas::python
