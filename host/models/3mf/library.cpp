#include "library.hpp"

#include <Common/NMR_ErrorConst.h>

#include "models/part_names.hpp"
#include "refusal.hpp"

namespace lineatlas::threemf {

namespace {

/// Refuses units and required parts that lib3mf does not know. lib3mf itself would take millimetres
/// for the unit and go on without those parts.
void refuse_unknown(const Handle& reader) {
    const auto count = value<DWORD>(reader, NMR::lib3mf_reader_getwarningcount);
    for (DWORD i = 0; i < count; ++i) {
        DWORD code = 0;
        ULONG size = 0;
        check(NMR::lib3mf_reader_getwarningutf8(reader.get(), i, &code, nullptr, 0, &size),
              reader.get());
        if (code == NMR_ERROR_INVALIDMODELUNIT)
            refuse("its unit of length is unknown; 3MF has micron, millimeter, centimeter, inch, "
                   "foot and meter");
        if (code == NMR_ERROR_REQUIREDEXTENSIONNOTSUPPORTED)
            refuse("it requires an extension that is not supported");
    }
}

} // namespace

void check(LIB3MFRESULT result, NMR::PLib3MFBase* instance) {
    if (result == LIB3MF_OK) return;
    DWORD code = 0;
    LPCSTR message = nullptr;
    const bool known = instance != nullptr &&
                       NMR::lib3mf_getlasterror(instance, &code, &message) == LIB3MF_OK &&
                       message != nullptr;
    refuse("lib3mf refuses it" + (known ? ": " + models::part_name(message, "no cause") : ""));
}

Handle read_model(std::string_view file) {
    NMR::PLib3MFBase* instance = nullptr;
    check(NMR::lib3mf_createmodel(&instance), nullptr);
    Handle model{instance};
    const Handle reader = get(model, NMR::lib3mf_model_queryreader, MODELREADERCLASS_3MF);
    // lib3mf only reads the bytes, although its interface does not say so.
    BYTE* const bytes = reinterpret_cast<BYTE*>(const_cast<char*>(file.data()));
    check(NMR::lib3mf_reader_readfrombuffer(reader.get(), bytes, file.size()), reader.get());
    refuse_unknown(reader);
    return model;
}

} // namespace lineatlas::threemf
