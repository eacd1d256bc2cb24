#pragma once

#include <filesystem>
#include <span>

namespace lineatlas {

/// The file that is really written by writing to `target`. As in other programs, writing through a
/// symbolic link changes the file that the link points to, which need not exist yet.
std::filesystem::path behind_links(const std::filesystem::path& target);

/// A file that appears at its place whole or not at all: it is written without a name, or under
/// another one where the file system knows no such files, flushed to the disk and renamed. What was
/// at the place before passes on its permissions, and its owner and group where that is allowed.
class AtomicFile {
  public:
    /// Creates the file, empty and not yet at its place. That is the only sure test of whether the
    /// folder can be written to: permission bits say nothing about the superuser, full or read-only
    /// disks. Throws FileError, also when `target` is something else than a file or nothing.
    explicit AtomicFile(const std::filesystem::path& target);

    /// Removes what was not committed.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Gives the file its content and its place. Call once. Throws FileError, and then nothing has
    /// changed at the place.
    void commit(std::span<const unsigned char> content);

  private:
    void name();

    std::filesystem::path target_;
    std::filesystem::path temporary_; ///< empty while it has no name
    int descriptor_ = -1;
    bool committed_ = false;
};

} // namespace lineatlas
