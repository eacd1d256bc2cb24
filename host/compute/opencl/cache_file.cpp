#include "cache_file.hpp"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file_descriptor.hpp"

namespace lineatlas::compute {
namespace {

namespace fs = std::filesystem;

bool write_all(int descriptor, std::span<const unsigned char> content) {
    while (!content.empty()) {
        const ssize_t written = ::write(descriptor, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        content = content.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

bool read_all(int descriptor, std::span<unsigned char> content) {
    while (!content.empty()) {
        const ssize_t count = ::read(descriptor, content.data(), content.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        content = content.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

/// Whether only this user can have written a file. Its program will run with this user's rights.
bool is_own(const struct stat& status) {
    return S_ISREG(status.st_mode) && status.st_uid == ::geteuid() &&
           (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

/// Makes folders for this user alone, whatever the umask is, as the XDG specification asks.
void make_folders(const fs::path& folder) {
    std::error_code error;
    if (folder.empty() || fs::exists(folder, error)) return;
    make_folders(folder.parent_path());
    ::mkdir(folder.c_str(), S_IRWXU);
}

} // namespace

std::optional<std::vector<unsigned char>> read_cache_file(const fs::path& path,
                                                          std::uintmax_t most_bytes) {
    // O_NONBLOCK, because someone may have put a pipe there.
    const FileDescriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    struct stat status {};
    if (!file.is_open() || ::fstat(file.number(), &status) != 0 || !is_own(status) ||
        static_cast<std::uintmax_t>(status.st_size) > most_bytes) {
        return std::nullopt;
    }
    std::vector<unsigned char> content(static_cast<std::size_t>(status.st_size));
    if (!read_all(file.number(), content)) return std::nullopt;
    return content;
}

bool write_cache_file(const fs::path& path, std::string_view part_extension,
                      std::span<const unsigned char> content) {
    make_folders(path.parent_path());
    std::string part = (path.parent_path() / "XXXXXX").string() + std::string{part_extension};
    const FileDescriptor file{
        ::mkostemps(part.data(), static_cast<int>(part_extension.size()), O_CLOEXEC)};
    if (!file.is_open()) return false;
    std::error_code error;
    if (write_all(file.number(), content))
        fs::rename(part, path, error);
    else
        error = std::make_error_code(std::errc::io_error);
    if (!error) return true;
    fs::remove(part, error);
    return false;
}

} // namespace lineatlas::compute
