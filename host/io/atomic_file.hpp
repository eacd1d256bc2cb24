#pragma once

#include <filesystem>
#include <span>

namespace lineatlas {

/// The file that writing to `target` changes. As in other programs, writing through a symbolic link
/// changes the file that the link points to. That file need not exist yet.
std::filesystem::path behind_links(const std::filesystem::path& target);

/// A file that appears at its place whole or not at all. It is written without a name, or under a
/// temporary one if the file system cannot do that, then flushed to the disk and renamed. It takes
/// over the permissions of the file that was there before, and its owner and group if that is
/// allowed.
class AtomicFile {
  public:
    /// Creates the file, empty and not yet at its place. No other test tells for sure whether the
    /// folder can be written to: permission bits say nothing about the superuser or about full or
    /// read-only disks. Throws FileError, also if `target` exists and is no file.
    explicit AtomicFile(const std::filesystem::path& target);

    /// Removes the file unless it was committed.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Gives the file its content and its place. Call once. If it throws FileError, nothing has
    /// changed at the place.
    void commit(std::span<const unsigned char> content);

  private:
    void name();

    std::filesystem::path target_;
    std::filesystem::path temporary_; ///< empty while the file has no name
    int descriptor_ = -1;
    bool committed_ = false;
};

} // namespace lineatlas
