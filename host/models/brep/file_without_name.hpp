#pragma once

#include <cstdio>
#include <string_view>

#include <sys/types.h>

namespace lineatlas::brep {

/// Makes bytes in memory the contents of C's stdin, which Open CASCADE reads if it gets a file
/// without a name. Its reader of IGES knows no streams, and a confined process opens no files. For
/// as long as this lives, stdin is these bytes for the whole process, so that only one may live at
/// a time.
class FileWithoutName {
  public:
    static constexpr const char* name = "";

    explicit FileWithoutName(std::string_view bytes);
    ~FileWithoutName();
    FileWithoutName(const FileWithoutName&) = delete;
    FileWithoutName& operator=(const FileWithoutName&) = delete;

  private:
    static ssize_t read(void* self, char* to, std::size_t size);
    static int close(void* self);

    std::string_view left_;
    std::FILE* file_ = nullptr; ///< null once Open CASCADE has closed it, as it does after success
    std::FILE* was_;
};

} // namespace lineatlas::brep
