#include "image_encoder.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <new>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "confinement.hpp"
#include "image_codec.hpp"
#include "image_loader.hpp"
#include "message_socket.hpp"
#include "reader_process.hpp"
#include "reader_protocol.hpp"

namespace lineatlas {

namespace {

/// Exit status of the process if it runs out of memory.
constexpr int no_memory = 3;

/// Whether a JPEG file lacks the mark at its end. Readers fill such files up with grey.
bool is_cut_jpeg(std::string_view bytes) {
    return bytes.starts_with("\xFF\xD8") && !bytes.ends_with("\xFF\xD9");
}

/// The content of the file; for a check nothing. Throws FileError.
std::vector<unsigned char> do_task(const PictureTask& task, std::string bytes) {
    const PictureTask::Numbers& numbers = task.numbers;
    const glm::ivec2 size{numbers.width, numbers.height};
    if (numbers.kind == PictureTask::Kind::encode)
        return encode_image(
            task.path,
            {.size = size,
             .channels = numbers.channels,
             .bits = numbers.bits,
             .premultiplied = numbers.premultiplied != 0,
             .values = std::as_bytes(std::span{bytes})},
            {.bits = numbers.file_bits, .dpi = numbers.dpi, .description = task.description});
    if (is_whole_picture({task.path, std::move(bytes)}, size)) return {};
    throw read_error(task.path, "it is damaged");
}

/// Does the next task. Returns false if no more tasks will come. The answer is a message, empty if
/// all is well, and the result.
bool answer_next(int socket, std::string message) {
    const std::optional<PictureTask> task = receive_task(socket);
    if (!task) return false;
    std::string bytes(task->numbers.bytes, '\0');
    if (!receive_all(socket, std::as_writable_bytes(std::span{bytes}))) return false;
    std::vector<unsigned char> result;
    try {
        if (message.empty()) result = do_task(*task, std::move(bytes));
    } catch (const FileError& error) {
        message = error.what();
    }
    return send_text(socket, message) &&
           send_text(socket, {reinterpret_cast<const char*>(result.data()), result.size()});
}

/// The work of the process until the other side is gone.
void serve(int socket, PictureType type) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::dup2(socket, STDIN_FILENO);
    forget_what_was_inherited();
    std::set_new_handler([] { ::_exit(no_memory); });
    confine_to_reading();
    std::string no_module;
    try {
        image_module(type); // nothing can be loaded later
    } catch (const FileError& error) {
        no_module = error.what();
    }
    confine();
    while (answer_next(STDIN_FILENO, no_module)) continue;
}

} // namespace

bool send_task(int socket, const PictureTask& task) {
    return send_all(socket, std::as_bytes(std::span{&task.numbers, 1})) &&
           send_text(socket, task.path) && send_text(socket, task.description);
}

std::optional<PictureTask> receive_task(int socket) {
    PictureTask task{};
    if (!receive_all(socket, std::as_writable_bytes(std::span{&task.numbers, 1})))
        return std::nullopt;
    const std::optional<std::string> path = receive_text(socket);
    const std::optional<std::string> description = receive_text(socket);
    if (!path || !description) return std::nullopt;
    task.path = *path;
    task.description = *description;
    return task;
}

bool is_whole_picture(const SourceFile& file, glm::ivec2 size) {
    try {
        return !is_cut_jpeg(file.bytes) && decode_image(file).size == size;
    } catch (const FileError&) {
        return false;
    }
}

ImageEncoder::ImageEncoder(PictureType first, const ReadLimits& limits)
    : type_(first), limits_(limits) {
    start(); // the module loads while other processes draw
}

void ImageEncoder::start() {
    std::array<int, 2> sockets{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) return;
    const pid_t process = ::fork();
    if (process == 0) {
        try {
            serve(sockets[1], type_);
        } catch (const std::exception&) {
            // The missing answer tells the other side.
        }
        ::_exit(0);
    }
    ::close(sockets[1]);
    worker_ = WorkerProcess{process, sockets[0]};
}

void ImageEncoder::limit(const PictureTask& task) {
    constexpr std::uint64_t bytes_per_pixel = 8; // of a decoded picture with 16 bits per channel
    const PictureTask::Numbers& numbers = task.numbers;
    const std::uint64_t decoded = bytes_per_pixel * static_cast<std::uint64_t>(numbers.width) *
                                  static_cast<std::uint64_t>(numbers.height);
    task_limits_ = limits_for(std::max(decoded, numbers.bytes), limits_);
    patience_ = Patience{task_limits_.time};
    if (reader::sanitized) return;
    // Set from here, because the process itself may not change its limits.
    rlimit memory{};
    ::getrlimit(RLIMIT_DATA, &memory);
    memory.rlim_cur = std::min<rlim_t>(memory.rlim_cur, task_limits_.memory);
    task_limits_.memory = memory.rlim_cur;
    ::prlimit(worker_.id(), RLIMIT_DATA, &memory, nullptr);
}

void ImageEncoder::begin(const PictureTask& task) {
    path_ = task.path;
    checks_ = task.numbers.kind == PictureTask::Kind::check;
    if (const PictureType type = type_by_name(task.path); type != type_) {
        worker_.end();
        type_ = type;
    }
    if (!worker_.is_there()) start();
    limit(task);
    if (!send_task(worker_.socket(), task)) fail();
}

void ImageEncoder::append(std::span<const std::byte> bytes) {
    if (!send_all(worker_.socket(), bytes, patience_)) fail();
}

void ImageEncoder::receive(std::span<std::byte> bytes) {
    if (!receive_all(worker_.socket(), bytes, patience_)) fail();
}

std::string ImageEncoder::receive_text(std::uint64_t most) {
    std::uint64_t size = 0;
    receive(std::as_writable_bytes(std::span{&size, 1}));
    if (size > most) fail();
    std::string text(size, '\0');
    receive(std::as_writable_bytes(std::span{text}));
    return text;
}

std::string ImageEncoder::finish() {
    const std::string message = receive_text(reader::longest_refusal);
    std::string encoded = receive_text(task_limits_.memory); // the process cannot have had more
    if (!message.empty()) throw FileError(message);
    return encoded;
}

void ImageEncoder::fail() {
    const std::string work = checks_ ? "decoding it" : "encoding it";
    std::string cause = work + " failed: its process";
    if (patience_.is_over()) {
        const auto seconds =
            std::chrono::duration_cast<std::chrono::duration<double>>(task_limits_.time);
        std::ostringstream text;
        text << work << " took more than " << seconds.count() << " s";
        cause = text.str();
    } else if (!worker_.is_there()) {
        cause += " cannot be started";
    } else {
        const auto [status, went_on_mute] = worker_.ending();
        if (!went_on_mute && WIFEXITED(status) && WEXITSTATUS(status) == no_memory)
            cause =
                work + " needs more than " + written_gibibytes(task_limits_.memory) + " of memory";
        else if (!went_on_mute && WIFSIGNALED(status))
            cause += " was ended by signal " + std::to_string(WTERMSIG(status));
        else
            cause += " gave no answer";
    }
    worker_.end();
    throw checks_ ? read_error(path_, cause) : write_error(path_, cause);
}

} // namespace lineatlas
