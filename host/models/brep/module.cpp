// The module lineatlas-brep: STEP and BREP, by Open CASCADE.
#include <new>
#include <stdexcept>
#include <string>

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include "brep_file.hpp"
#include "models/model_module.hpp"
#include "placement.hpp"
#include "step.hpp"

namespace {

using namespace lineatlas;

Soup read(const models::Request& request) {
    try {
        const bool step = request.extension == ".step" || request.extension == ".stp";
        brep::Assembly assembly =
            step ? brep::read_step(request.bytes) : brep::read_brep(request.bytes);
        return brep::place(std::move(assembly), request.deflection);
    } catch (const Standard_OutOfMemory&) {
        throw std::bad_alloc();
    } catch (const Standard_Failure& failure) {
        // These are no exceptions of the standard library.
        const std::string message = failure.GetMessageString();
        throw std::runtime_error("Open CASCADE refuses it" +
                                 (message.empty() ? "" : ": " + message));
    }
}

} // namespace

const models::Module lineatlas_brep_1{.prepare = brep::prepare_step, .read = read};
