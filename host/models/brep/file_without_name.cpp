#include "file_without_name.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace lineatlas::brep {

FileWithoutName::FileWithoutName(std::string_view bytes) : left_(bytes), was_(stdin) {
    file_ =
        ::fopencookie(this, "r", {.read = read, .write = nullptr, .seek = nullptr, .close = close});
    if (file_ == nullptr) throw std::system_error(errno, std::generic_category(), "a stream");
    stdin = file_; // glibc's streams are variables
}

FileWithoutName::~FileWithoutName() {
    stdin = was_;
    if (file_ != nullptr) std::fclose(file_);
}

ssize_t FileWithoutName::read(void* self, char* to, std::size_t size) {
    std::string_view& left = static_cast<FileWithoutName*>(self)->left_;
    size = left.copy(to, size);
    left.remove_prefix(size);
    return static_cast<ssize_t>(size);
}

int FileWithoutName::close(void* self) {
    static_cast<FileWithoutName*>(self)->file_ = nullptr;
    return 0;
}

} // namespace lineatlas::brep
