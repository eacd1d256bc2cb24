// The functions of source_file.hpp that call the system.
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <sys/resource.h>

#include "source_file.hpp"

namespace lineatlas {

std::string write_cause(int error) {
    rlimit size{};
    if (error == EFBIG && ::getrlimit(RLIMIT_FSIZE, &size) == 0 && size.rlim_cur != RLIM_INFINITY)
        return "a file may have at most " + counted(size.rlim_cur, "byte", "bytes") +
               " here; raise that limit (ulimit -f)";
    return std::generic_category().message(error);
}

std::uintmax_t check_source(const std::string& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        const bool missing = !error || error == std::errc::no_such_file_or_directory;
        throw read_error(path, missing ? "no such file" : error.message());
    }
    if (std::filesystem::is_directory(status)) throw read_error(path, "it is a folder");
    // A pipe or a device has no end that could be known beforehand.
    if (!std::filesystem::is_regular_file(status)) throw read_error(path, "it is no regular file");

    const std::ifstream stream(path, std::ios::binary);
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!stream || error) throw read_error(path, "no permission to read it");
    if (size == 0) throw read_error(path, "the file is empty");
    return size;
}

SourceFile read_source(const std::string& path) {
    const std::uintmax_t size = check_source(path);
    SourceFile source{.path = path, .bytes = std::string(size, '\0')};
    std::ifstream stream(path, std::ios::binary);
    if (!stream.read(source.bytes.data(), static_cast<std::streamsize>(size)))
        throw read_error(path, "reading stopped before the end of the file");
    return source;
}

} // namespace lineatlas
