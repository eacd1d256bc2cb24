#pragma once

#include <filesystem>
#include <span>

namespace lineatlas {

/// A file that appears at its place whole or not at all: it is written beside its place under
/// another name, flushed to the disk and renamed.
class AtomicFile {
  public:
    /// Creates the file under its other name, empty. That is the only sure test of whether the
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
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    bool committed_ = false;
};

} // namespace lineatlas
