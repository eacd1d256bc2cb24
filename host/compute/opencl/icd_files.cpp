#include "icd_files.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <dlfcn.h>

#include "loader.hpp"

namespace lineatlas::compute {
namespace {

namespace fs = std::filesystem;

fs::path vendors() {
    for (const char* variable : {"OPENCL_VENDOR_PATH", "OCL_ICD_VENDORS"}) {
        if (const char* path = std::getenv(variable)) return path;
    }
    return "/etc/OpenCL/vendors";
}

std::vector<fs::path> files_in(const fs::path& place) {
    std::error_code error;
    if (!fs::is_directory(place, error)) {
        if (place.extension() == ".icd" && fs::exists(place, error)) return {place};
        return {};
    }
    std::vector<fs::path> files;
    for (fs::directory_iterator file{place, error}, end; !error && file != end;
         file.increment(error)) {
        if (file->path().extension() == ".icd") files.push_back(file->path());
    }
    std::ranges::sort(files);
    return files;
}

} // namespace

std::vector<IcdFile> icd_files() {
    std::vector<IcdFile> result;
    if (!opencl_library().works || opencl_library().in_front) return result;
    for (const fs::path& file : files_in(vendors())) {
        IcdFile icd{.path = file.string(), .library = {}};
        std::getline(std::ifstream{file}, icd.library);
        icd.library.erase(icd.library.find_last_not_of(" \t\r") + 1);
        if (icd.library.empty()) {
            icd.cause = "it names no library";
        } else if (void* const library = ::dlopen(icd.library.c_str(), RTLD_LAZY | RTLD_LOCAL)) {
            ::dlclose(library);
        } else {
            const char* const error = ::dlerror();
            icd.cause = error != nullptr ? error : icd.library + " cannot be opened";
        }
        result.push_back(std::move(icd));
    }
    return result;
}

} // namespace lineatlas::compute
