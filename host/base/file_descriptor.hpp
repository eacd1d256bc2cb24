#pragma once

#include <utility>

#include <unistd.h>

namespace lineatlas {

/// Owns a file descriptor and closes it; can be moved, but not copied.
class FileDescriptor {
  public:
    /// number: -1 for none, as system calls return it.
    explicit FileDescriptor(int number = -1) : number_(number) {}
    ~FileDescriptor() {
        if (is_open()) ::close(number_);
    }
    FileDescriptor(FileDescriptor&& other) noexcept : number_(other.release()) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    bool is_open() const { return number_ >= 0; }
    int number() const { return number_; }
    /// Gives the descriptor to an owner that closes it.
    int release() { return std::exchange(number_, -1); }

  private:
    int number_;
};

} // namespace lineatlas
