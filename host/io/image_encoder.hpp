#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "image_loader.hpp"
#include "lineatlas/io.hpp"
#include "message_socket.hpp"
#include "reader_process.hpp"
#include "source_file.hpp"
#include "worker_process.hpp"

namespace lineatlas {

/// A request about a picture. The values of a picture to be written, or the content of a file,
/// follow in `bytes` bytes.
struct PictureTask {
    enum class Kind : std::int32_t { encode, check };

    struct Numbers {
        Kind kind;
        std::int32_t width, height, channels, bits, premultiplied, file_bits;
        float dpi;
        std::uint64_t bytes;
    };
    Numbers numbers;
    std::string path, description;
};

/// False, or nothing, if the other side is gone.
bool send_task(int socket, const PictureTask& task);
std::optional<PictureTask> receive_task(int socket);

/// Whether the file holds a whole picture of this size.
bool is_whole_picture(const SourceFile& file, glm::ivec2 size);

/// A confined process (confinement.hpp) that has the module for pictures of one type and works on
/// tasks that come through a socket. It is a copy of the process that makes it, which must have one
/// thread, and ends with that. Pictures of the other type have another process.
///
/// Its memory and time are limited as those of readers are. If it exceeds the limits or crashes,
/// the task fails, and the next task gets another process.
class ImageEncoder {
  public:
    /// `first`: type of the first picture, whose module loads at once. `limits`: those of each
    /// task; 0: by the size of its picture.
    ImageEncoder(PictureType first, const ReadLimits& limits);

    // For each task begin(), append() until all bytes are there, and finish(). They throw FileError
    // if the picture is refused or not whole, or if the process has failed.
    void begin(const PictureTask& task);
    void append(std::span<const std::byte> bytes);
    /// The content of the file; for a check nothing.
    std::string finish();

  private:
    void start();
    /// Keeps the process to the limits of the task.
    void limit(const PictureTask& task);
    void receive(std::span<std::byte> bytes);
    std::string receive_text(std::uint64_t most);
    /// Ends the process and throws FileError that says how it has failed.
    [[noreturn]] void fail();

    WorkerProcess worker_; ///< none: a process starts with the next task
    PictureType type_;
    ReadLimits limits_, task_limits_;
    Patience patience_{std::chrono::nanoseconds{0}};
    std::filesystem::path path_; ///< of the task
    bool checks_ = false;        ///< the task is a check
};

} // namespace lineatlas
