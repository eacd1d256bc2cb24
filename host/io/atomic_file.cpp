#include "atomic_file.hpp"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <set>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "source_file.hpp"

namespace lineatlas {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view part_prefix = ".lineatlas-";
constexpr std::string_view part_extension = ".part";
constexpr mode_t read_write_all = 0666; // narrowed by the umask

void check_place(const fs::path& target) {
    std::error_code error;
    if (fs::is_symlink(target, error)) throw write_error(target, "its links lead nowhere");
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) throw write_error(target, "it is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw write_error(target, "it is no regular file");
    const fs::path folder = target.parent_path();
    const fs::file_status folder_status = fs::status(folder.empty() ? "." : folder, error);
    if (!fs::exists(folder_status)) throw write_error(target, "its folder does not exist");
    if (!fs::is_directory(folder_status)) throw write_error(target, "its folder is a file");
}

fs::path folder_of(const fs::path& target) {
    return target.has_parent_path() ? target.parent_path() : fs::path{"."};
}

/// A temporary name beside the target. It is short, so that it fits wherever the target's name
/// does.
fs::path name_beside(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    return folder_of(target) / (std::string{part_prefix} + std::to_string(::getpid()) + '-' +
                                std::to_string(counter++) + std::string{part_extension});
}

/// Removes old temporary files of killed writers from a folder, the first time that this process
/// writes there. Files of writers at work, on any machine, are far younger.
void remove_left_behind(const fs::path& folder) {
    static std::mutex mutex;
    static std::set<fs::path> tidied;
    {
        const std::lock_guard lock{mutex};
        if (!tidied.insert(folder).second) return;
    }
    std::error_code error;
    for (fs::directory_iterator file{folder, error}, end; !error && file != end;
         file.increment(error)) {
        const std::string name = file->path().filename().string();
        if (!name.starts_with(part_prefix) || !name.ends_with(part_extension)) continue;
        std::error_code ignored;
        const auto age = fs::file_time_type::clock::now() - file->last_write_time(ignored);
        if (!ignored && age > std::chrono::hours{1}) fs::remove(file->path(), ignored);
    }
}

std::string link_to(int descriptor) {
    return "/proc/self/fd/" + std::to_string(descriptor);
}

/// Opens a file without a name. Nothing is left of it however this process ends. Returns -1 if the
/// file system or a missing /proc does not allow it.
int open_nameless(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, read_write_all);
    if (descriptor < 0 || ::access(link_to(descriptor).c_str(), F_OK) == 0) return descriptor;
    ::close(descriptor);
    return -1;
}

/// Lets the same users read and write the file as before, and nobody else.
void keep_owner_and_mode(const fs::path& target, int descriptor) {
    struct stat old {};
    if (::stat(target.c_str(), &old) != 0) return;
    constexpr mode_t permissions = 0777, of_group = 0070;
    mode_t mode = old.st_mode & permissions;
    // Only the superuser can give files away. Others keep at least the group, or give the group no
    // rights.
    if (::fchown(descriptor, old.st_uid, old.st_gid) != 0 &&
        ::fchown(descriptor, static_cast<uid_t>(-1), old.st_gid) != 0) {
        mode &= ~of_group;
    }
    if (::fchmod(descriptor, mode) != 0) throw write_error(target, write_cause(errno));
}

} // namespace

fs::path behind_links(const fs::path& target) {
    constexpr int most_links = 40; // as many as the kernel follows
    fs::path place = target;
    std::error_code error;
    for (int i = 0; i < most_links && fs::is_symlink(place, error); ++i) {
        const fs::path next = fs::read_symlink(place, error);
        if (error) break;
        place = place.parent_path() / next; // an absolute `next` replaces the folder
    }
    return place;
}

AtomicFile::AtomicFile(const fs::path& target) : target_(behind_links(target)) {
    check_place(target_);
    const fs::path folder = folder_of(target_);
    remove_left_behind(folder);
    descriptor_ = open_nameless(folder);
    while (descriptor_ < 0) {
        temporary_ = name_beside(target_);
        descriptor_ =
            ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, read_write_all);
        if (descriptor_ < 0 && errno != EEXIST)
            throw write_error(target_,
                              "its folder cannot be written to (" + write_cause(errno) + ")");
    }
}

AtomicFile::~AtomicFile() {
    ::close(descriptor_);
    std::error_code ignored;
    if (!committed_ && !temporary_.empty()) fs::remove(temporary_, ignored);
}

/// Gives a file without a name a name beside its place, because no call can put it directly in the
/// place of another file.
void AtomicFile::name() {
    while (temporary_.empty()) {
        const fs::path name = name_beside(target_);
        if (::linkat(AT_FDCWD, link_to(descriptor_).c_str(), AT_FDCWD, name.c_str(),
                     AT_SYMLINK_FOLLOW) == 0) {
            temporary_ = name;
        } else if (errno != EEXIST) {
            throw write_error(target_, write_cause(errno));
        }
    }
}

void AtomicFile::commit(std::span<const unsigned char> content) {
    while (!content.empty()) {
        const ssize_t written = ::write(descriptor_, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw write_error(target_, write_cause(errno));
        content = content.subspan(static_cast<std::size_t>(written));
    }
    keep_owner_and_mode(target_, descriptor_);
    // Without this call a crash of the machine may leave the new name without data.
    if (::fsync(descriptor_) != 0) throw write_error(target_, write_cause(errno));

    name();
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) throw write_error(target_, error.message());
    committed_ = true;
}

} // namespace lineatlas
