#include "fuzz.hpp"

#include <fstream>
#include <iterator>

#include <unistd.h>

namespace lineatlas::fuzz {
namespace {

namespace fs = std::filesystem;

/// A folder for one process, removed at its end.
class Folder {
  public:
    Folder() {
        const fs::path memory = "/dev/shm";
        std::error_code ignored;
        const fs::path base =
            fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path();
        path_ = base / ("lineatlas_fuzz_" + std::to_string(::getpid()));
        fs::create_directories(path_);
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

} // namespace

fs::path put_file(std::string_view extension, std::span<const std::uint8_t> bytes) {
    static const Folder folder;
    const fs::path path = folder.path() / ("input" + std::string{extension});
    write_file(path, bytes);
    return path;
}

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
    std::ofstream file{path, std::ios::binary};
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    file.close();
    expect(!file.fail(), "the input could not be written to " + path.string());
}

std::vector<unsigned char> read_file(const fs::path& path) {
    std::ifstream file{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{file}, std::istreambuf_iterator<char>{}};
}

} // namespace lineatlas::fuzz
