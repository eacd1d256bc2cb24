#include "atomic_file.hpp"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "source_file.hpp"

namespace lineatlas {

namespace {

namespace fs = std::filesystem;

std::string cause(int error) {
    return std::generic_category().message(error);
}

/// Writing through a link changes what it points to, as every other program does.
fs::path behind_links(const fs::path& target) {
    std::error_code error;
    if (!fs::is_symlink(target, error)) return target;
    const fs::path resolved = fs::weakly_canonical(target, error);
    return error ? target : resolved;
}

void check_place(const fs::path& target) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) throw write_error(target, "it is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw write_error(target, "it is no regular file");
    const fs::path folder = target.parent_path();
    const fs::file_status folder_status = fs::status(folder.empty() ? "." : folder, error);
    if (!fs::exists(folder_status)) throw write_error(target, "its folder does not exist");
    if (!fs::is_directory(folder_status)) throw write_error(target, "its folder is a file");
}

/// Short whatever the target's name is, so that it fits wherever the target's name does.
fs::path name_beside(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    return target.parent_path() /
           (".lineatlas-" + std::to_string(::getpid()) + '-' + std::to_string(counter++) + ".part");
}

} // namespace

AtomicFile::AtomicFile(const fs::path& target) : target_(behind_links(target)) {
    check_place(target_);
    constexpr mode_t read_write_all = 0666; // narrowed by the umask
    do {
        temporary_ = name_beside(target_);
        descriptor_ =
            ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, read_write_all);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0)
        throw write_error(target_, "its folder cannot be written to (" + cause(errno) + ")");
}

AtomicFile::~AtomicFile() {
    ::close(descriptor_);
    std::error_code ignored;
    if (!committed_) fs::remove(temporary_, ignored);
}

void AtomicFile::commit(std::span<const unsigned char> content) {
    while (!content.empty()) {
        const ssize_t written = ::write(descriptor_, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw write_error(target_, cause(errno));
        content = content.subspan(static_cast<std::size_t>(written));
    }
    // Without this a crash of the machine may leave the new name with no data behind it.
    if (::fsync(descriptor_) != 0) throw write_error(target_, cause(errno));

    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) throw write_error(target_, error.message());
    committed_ = true;
}

} // namespace lineatlas
