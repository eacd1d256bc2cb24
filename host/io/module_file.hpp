#pragma once

#include <filesystem>

namespace lineatlas {

/// A part of the library in a file of its own, which is loaded when first needed. So users who
/// never need the part need not install the libraries that it links.
struct ModuleFile {
    const char* name;    ///< of the file without its .so, and of the target that builds it
    const char* purpose; ///< "which ...", for messages
    const char* library; ///< that it links, and
    const char* package; ///< what brings that on Debian
    const char* own_package = nullptr; ///< of Debian in which it comes alone
};

/// Where it is: LINEATLAS_MODULE_DIR, or lib/lineatlas beside this program or shared library.
/// Loads nothing. Throws FileError.
std::filesystem::path find_module(const ModuleFile& module);

/// Whether this lineatlas was built with it, be it installed or not.
bool was_built(const ModuleFile& module);

/// Whether it is anywhere there.
bool has_module(const ModuleFile& module);

/// Loads it for the rest of the process and returns its one symbol, which is named by version.
/// Throws FileError.
const void* load_module(const ModuleFile& module, const char* symbol);

} // namespace lineatlas
