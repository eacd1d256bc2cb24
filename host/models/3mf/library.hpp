#pragma once

#include <memory>
#include <string>

#include <Model/COM/NMR_DLLInterfaces.h>

namespace lineatlas::threemf {

struct Release {
    void operator()(NMR::PLib3MFBase* instance) const { NMR::lib3mf_release(instance); }
};
/// An object of lib3mf: a pointer without a type, which must be given back.
using Handle = std::unique_ptr<NMR::PLib3MFBase, Release>;

/// Refuses in lib3mf's own words if a call on `instance` failed.
void check(LIB3MFRESULT result, NMR::PLib3MFBase* instance);

/// The handle that a call returns: `get(model, lib3mf_model_getbuilditems)`.
template <class... Arguments, class... Given>
Handle get(const Handle& of, LIB3MFRESULT (*call)(Arguments...), Given... given) {
    NMR::PLib3MFBase* instance = nullptr;
    check(call(of.get(), given..., &instance), of.get());
    return Handle{instance};
}

/// The value that a call returns.
template <class Value, class... Arguments, class... Given>
Value value(const Handle& of, LIB3MFRESULT (*call)(Arguments...), Given... given) {
    Value result{};
    check(call(of.get(), given..., &result), of.get());
    return result;
}

/// The text that a call such as lib3mf_object_getnameutf8 returns.
template <class... Arguments, class... Given>
std::string text(const Handle& of, LIB3MFRESULT (*call)(Arguments...), Given... given) {
    ULONG size = 0;
    check(call(of.get(), given..., nullptr, 0, &size), of.get());
    std::string result(std::size_t{size} + 1, '\0');
    check(call(of.get(), given..., result.data(), size + 1, &size), of.get());
    return result.c_str(); // up to its zero
}

/// A model as lib3mf reads it from a package in memory. Refuses what lib3mf refuses.
Handle read_model(std::string_view file);

} // namespace lineatlas::threemf
