#pragma once

#include <pybind11/pybind11.h>

// What the module consists of: each adds its part.
namespace lineatlas::python {

void bind_errors(pybind11::module_& module);
void bind_mesh(pybind11::module_& module);
void bind_view(pybind11::module_& module);
void bind_sequences(pybind11::module_& module);
void bind_style(pybind11::module_& module);
void bind_renderer(pybind11::module_& module);
void bind_files(pybind11::module_& module);

/// Makes all functions of the module, once they are bound, say in one line which named argument
/// they don't have, in place of pybind11's list of signatures.
void name_unknown_arguments(pybind11::module_& module);

} // namespace lineatlas::python
