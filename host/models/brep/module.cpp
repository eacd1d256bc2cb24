// The module lineatlas-brep: STEP, IGES and BREP, by Open CASCADE.
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include "brep_file.hpp"
#include "iges.hpp"
#include "io/model_module.hpp"
#include "placement.hpp"
#include "step.hpp"

namespace {

using namespace lineatlas;

/// Keeps Open CASCADE's readers from printing remarks on stdout.
class Silence {
  public:
    Silence() : printers_(Message::DefaultMessenger()->Printers()) {
        Message::DefaultMessenger()->ChangePrinters().Clear();
    }
    ~Silence() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

  private:
    Message_SequenceOfPrinters printers_;
};

brep::Assembly read_assembly(const models::Request& request) {
    if (request.extension == ".step" || request.extension == ".stp")
        return brep::read_step(request.bytes);
    if (request.extension == ".iges" || request.extension == ".igs")
        return brep::read_iges(request.bytes);
    return brep::read_brep(request.bytes);
}

void prepare() {
    brep::prepare_step();
    brep::prepare_iges();
}

Soup read(const models::Request& request) {
    // Open CASCADE's readers share tables in the process, and that of IGES uses stdin.
    static std::mutex one_at_a_time;
    const std::scoped_lock lock{one_at_a_time};
    const Silence silence;
    try {
        return brep::place(read_assembly(request),
                           {.deflection = request.deflection, .pixels = request.pixels});
    } catch (const Standard_OutOfMemory&) {
        throw std::bad_alloc();
    } catch (const Standard_Failure& failure) {
        // Open CASCADE's exceptions do not derive from std::exception.
        const std::string message = failure.GetMessageString();
        throw std::runtime_error("Open CASCADE refuses it" +
                                 (message.empty() ? "" : ": " + message));
    }
}

} // namespace

const models::Module lineatlas_brep_2{.prepare = prepare, .read = read};
