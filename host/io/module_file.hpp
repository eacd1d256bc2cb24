#pragma once

#include <filesystem>

namespace lineatlas {

/// A part of the library in a file of its own, which is loaded when first needed. So users who
/// never need the part need not install the libraries that it links.
struct ModuleFile {
    const char* name;    ///< of the file without its .so, and of the target that builds it
    const char* purpose; ///< "which ...", for messages
    const char* library; ///< the library that it links
    const char* package; ///< the Debian package with that library
    const char* own_package = nullptr; ///< the Debian package of the module alone
};

/// The path of a module: in LINEATLAS_MODULE_DIR, or in lib/lineatlas beside this program or shared
/// library. Loads nothing. Throws FileError.
std::filesystem::path find_module(const ModuleFile& module);

/// Whether this lineatlas was built with the module, installed or not.
bool was_built(const ModuleFile& module);

/// Whether the module is in any of its places.
bool has_module(const ModuleFile& module);

/// Loads a module for the rest of the process and returns its one symbol, which carries a version
/// in its name. Throws FileError.
const void* load_module(const ModuleFile& module, const char* symbol);

} // namespace lineatlas
