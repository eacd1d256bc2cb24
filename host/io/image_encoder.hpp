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

/// False, or none, when the other side is gone.
bool send_task(int socket, const PictureTask& task);
std::optional<PictureTask> receive_task(int socket);

/// Whether the file holds a whole picture of that size.
bool is_whole_picture(const SourceFile& file, glm::ivec2 size);

/// A confined process (confinement.hpp) that has the module for pictures of one type and works on
/// what comes through a socket. For a process with one thread: it is a copy of it, and ends with
/// it. Pictures of the other type have another process.
///
/// Its memory and its time are limited as those of readers are. Where it exceeds them or crashes,
/// the task fails, and the next one has another process.
class ImageEncoder {
  public:
    /// `first`: of the first picture, whose module loads at once. `limits`: of each task. 0: by the
    /// size of its picture.
    ImageEncoder(PictureType first, const ReadLimits& limits);

    // For each task begin(), append() until all bytes are there, and finish(). They throw
    // FileError: what is refused, why the picture is not whole, or how the process has failed.
    void begin(const PictureTask& task);
    void append(std::span<const std::byte> bytes);
    /// What the file is to hold; of a check nothing.
    std::string finish();

  private:
    void start();
    /// Keeps the process to the limits of the task.
    void limit(const PictureTask& task);
    void receive(std::span<std::byte> bytes);
    std::string receive_text(std::uint64_t most);
    /// Says how the process has failed; it is gone then.
    [[noreturn]] void fail();

    WorkerProcess worker_; ///< none: it starts with the next task
    PictureType type_;
    ReadLimits limits_, task_limits_;
    Patience patience_{std::chrono::nanoseconds{0}};
    std::filesystem::path path_; ///< of the task
    bool checks_ = false;        ///< the task is a check
};

} // namespace lineatlas
