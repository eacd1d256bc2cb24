#include "bindings.hpp"
#include "process.hpp"

PYBIND11_MODULE(_lineatlas, module) {
    using namespace lineatlas::python;
    module.doc() = "The compiled part of lineatlas; import lineatlas.";
    module.attr("__version__") = LINEATLAS_VERSION;
    watch_process();
    bind_errors(module);
    bind_mesh(module);
    bind_view(module);
    bind_sequences(module);
    bind_style(module);
    bind_renderer(module);
    bind_files(module);
    name_unknown_arguments(module);
}
