#include "pocl_cache.hpp"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lineatlas::compute {
namespace {

namespace fs = std::filesystem;

constexpr const char* variable = "POCL_CACHE_DIR";

fs::path path_in(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

/// The folder that PoCL uses; empty: one that all users share.
fs::path usual_folder() {
    if (const fs::path own = path_in(variable); !own.empty()) return own;
    if (const fs::path cache = path_in("XDG_CACHE_HOME"); !cache.empty()) return cache / "pocl";
    if (const fs::path home = path_in("HOME"); !home.empty()) return home / ".cache" / "pocl";
    return {};
}

/// Whether the folder, or the nearest existing one above it, can be written to.
bool can_be_made(fs::path folder) {
    std::error_code error;
    folder = fs::absolute(folder, error);
    while (!fs::exists(folder, error) && folder != folder.parent_path())
        folder = folder.parent_path();
    return fs::is_directory(folder, error) &&
           ::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) == 0;
}

/// Makes a folder that only this user can write to and has made, because code is loaded from it.
bool make_private(const fs::path& folder) {
    constexpr mode_t owner_alone = 0700, of_others = 0077;
    ::mkdir(folder.c_str(), owner_alone);
    struct stat status {};
    return ::lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
           status.st_uid == ::geteuid() && (status.st_mode & of_others) == 0 && can_be_made(folder);
}

} // namespace

std::string give_pocl_a_cache() {
    const fs::path usual = usual_folder();
    if (!usual.empty() && can_be_made(usual)) return {};
    std::error_code error;
    const fs::path temporary = fs::temp_directory_path(error);
    const fs::path folder = temporary / ("lineatlas-" + std::to_string(::geteuid()));
    if (!error && make_private(folder)) {
        ::setenv(variable, (folder / "pocl").c_str(), 1);
        return {};
    }
    std::string cause = "PoCL has no place for its cache: ";
    if (usual.empty())
        cause += "there is no HOME";
    else
        cause.append(usual).append(" cannot be written to");
    if (error)
        cause += " and there is no temporary directory";
    else
        cause.append(", ").append(folder).append(" cannot be made or is not yours alone");
    return cause + "; set POCL_CACHE_DIR to a folder of your own";
}

} // namespace lineatlas::compute
