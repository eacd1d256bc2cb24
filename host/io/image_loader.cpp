#include "image_loader.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <system_error>

#include <dlfcn.h>
#include <link.h>

#include "source_file.hpp"

namespace lineatlas {

namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "lineatlas-images.so";

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

FileError load_error(const fs::path& path, const std::string& cause) {
    return FileError("cannot load " + quoted(path) + ", which reads and writes pictures: " + cause);
}

fs::path find_module() {
    std::error_code error;
    if (const char* folder = std::getenv("LINEATLAS_MODULE_DIR")) {
        const fs::path path = fs::path(folder) / file_name;
        if (fs::exists(path, error)) return path;
        throw load_error(path, "no such file; LINEATLAS_MODULE_DIR names its folder");
    }
    const fs::path own = own_folder();
    // Of a shared library, of an installed program, of the programs and tests of a build.
    const std::array folders{own, own / LINEATLAS_LIBRARIES_FROM_PROGRAMS, own / "lib",
                             own.parent_path() / "lib"};
    std::array<fs::path, folders.size()> places;
    std::ranges::transform(folders, places.begin(),
                           [](const fs::path& folder) { return folder / "lineatlas" / file_name; });
    for (const fs::path& path : places)
        if (fs::exists(path, error)) return path;
    throw load_error(places.back(), "no such file; build the target lineatlas-images, or set "
                                    "LINEATLAS_MODULE_DIR to its folder");
}

const images::Module& load_module() {
    const fs::path path = find_module();
    void* library = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr)
        throw load_error(path, std::string(dlerror()) +
                                   "; is OpenImageIO installed (on Debian: apt install "
                                   "libopenimageio-dev)?");
    const void* module = dlsym(library, images::module_symbol);
    if (module == nullptr) throw load_error(path, "it belongs to another version; build both anew");
    return *static_cast<const images::Module*>(module);
}

} // namespace

const images::Module& image_module() {
    static const images::Module& module = load_module();
    return module;
}

void check_image_module() {
    find_module();
}

} // namespace lineatlas
