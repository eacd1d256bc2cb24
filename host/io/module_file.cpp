#include "module_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <dlfcn.h>
#include <link.h>

#include "source_file.hpp"

namespace lineatlas {

namespace {

namespace fs = std::filesystem;

/// The folder of the program or shared library that this code is part of.
fs::path own_folder() {
    Dl_info info{};
    link_map* object = nullptr;
    const bool known = dladdr1(reinterpret_cast<const void*>(&own_folder), &info,
                               reinterpret_cast<void**>(&object), RTLD_DL_LINKMAP) != 0;
    // The linker gives the program itself no name.
    const bool is_program = !known || object == nullptr || *object->l_name == '\0';
    std::error_code error;
    return fs::canonical(is_program ? "/proc/self/exe" : object->l_name, error).parent_path();
}

FileError load_error(const ModuleFile& module, const fs::path& path, const std::string& cause) {
    return FileError("cannot load " + quoted(path) + ", " + module.purpose + ": " + cause);
}

/// Where a module may be. Messages name the last place.
std::vector<fs::path> places_of(const ModuleFile& module) {
    const std::string file_name = std::string{module.name} + ".so";
    if (const char* folder = std::getenv("LINEATLAS_MODULE_DIR"))
        return {fs::path(folder) / file_name};
    const fs::path own = own_folder();
    // Places beside a shared library, an installed program, and the programs and tests of a build.
    std::vector<fs::path> places;
    for (const fs::path& folder :
         {own, own / LINEATLAS_LIBRARIES_FROM_PROGRAMS, own / "lib", own.parent_path() / "lib"})
        places.push_back(folder / "lineatlas" / file_name);
    return places;
}

bool is_there(const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error);
}

} // namespace

bool was_built(const ModuleFile& module) {
    constexpr std::string_view built = LINEATLAS_MODULES; // each followed by a space
    return built.find(std::string{module.name} + ' ') != built.npos;
}

bool has_module(const ModuleFile& module) {
    return std::ranges::any_of(places_of(module), is_there);
}

fs::path find_module(const ModuleFile& module) {
    const std::vector<fs::path> places = places_of(module);
    const auto found = std::ranges::find_if(places, is_there);
    if (found != places.end()) return *found;
    if (std::getenv("LINEATLAS_MODULE_DIR") != nullptr)
        throw load_error(module, places.back(),
                         "no such file; LINEATLAS_MODULE_DIR names its folder");
    if (!was_built(module))
        throw load_error(module, places.back(),
                         "this lineatlas was built without it; build it anew with " +
                             std::string{module.library} + " (on Debian: apt install " +
                             module.package + ")");
    std::string cause{"no such file; "};
    if (module.own_package != nullptr)
        cause += std::string{"install the package "} + module.own_package + ", ";
    cause += std::string{"build the target "} + module.name +
             ", or set LINEATLAS_MODULE_DIR to its folder";
    throw load_error(module, places.back(), cause);
}

const void* load_module(const ModuleFile& module, const char* symbol) {
    const fs::path path = find_module(module);
    void* library = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr) {
        const std::string cause = dlerror();
        // If memory is too small for a library, the linker's message does not say so.
        constexpr std::size_t room_of_libraries = std::size_t{16} << 20U;
        ::operator delete(::operator new(room_of_libraries));
        throw load_error(module, path,
                         cause + "; is " + module.library + " installed (on Debian: apt install " +
                             module.package + ")?");
    }
    const void* found = dlsym(library, symbol);
    if (found == nullptr)
        throw load_error(module, path, "it belongs to another version; build both anew");
    return found;
}

} // namespace lineatlas
