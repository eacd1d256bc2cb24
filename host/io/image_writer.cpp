#include "image_writer.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "image_loader.hpp"
#include "lineatlas/error.hpp"
#include "message_socket.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

enum class Task : std::int32_t { write, check };

/// What is asked of the process. The path and the description follow, then the values.
struct Request {
    Task task;
    std::int32_t width, height, channels, bits, premultiplied, file_bits;
    float dpi;
    std::uint64_t bytes; ///< of the values
};

bool send_request(int socket, const Request& request, const std::filesystem::path& path,
                  const std::string& description) {
    return send_all(socket, std::as_bytes(std::span{&request, 1})) &&
           send_text(socket, path.string()) && send_text(socket, description);
}

std::size_t bytes_of(const Pixels& pixels) {
    return static_cast<std::size_t>(pixels.size.x) * static_cast<std::size_t>(pixels.size.y) *
           static_cast<std::size_t>(pixels.channels) * static_cast<std::size_t>(pixels.bits / 8);
}

FileError no_process() {
    return FileError("the process that writes pictures has ended; is there enough memory?");
}

bool has_one_thread() {
    std::error_code error;
    const std::filesystem::directory_iterator threads("/proc/self/task", error);
    return !error && std::distance(begin(threads), end(threads)) == 1;
}

/// JPEG files end with a mark; what is cut off before it, readers fill up with grey.
bool is_cut_jpeg(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    std::array<char, 2> bytes{};
    if (!file.read(bytes.data(), 2) || bytes != std::array{'\xFF', '\xD8'}) return false;
    file.seekg(-2, std::ios::end);
    return !file.read(bytes.data(), 2) || bytes != std::array{'\xFF', '\xD9'};
}

bool holds_whole_picture(const std::filesystem::path& path, glm::ivec2 size) {
    try {
        return read_image(path).size == size && !is_cut_jpeg(path);
    } catch (const FileError&) {
        return false;
    }
}

/// The answer to one request: empty if all is well, else a message. None when no more will come.
std::optional<std::string> answer_next(int socket) {
    Request request{};
    if (!receive_all(socket, std::as_writable_bytes(std::span{&request, 1}))) return std::nullopt;
    const std::optional<std::string> path = receive_text(socket);
    const std::optional<std::string> description = receive_text(socket);
    if (!path || !description) return std::nullopt;
    const glm::ivec2 size{request.width, request.height};
    if (request.task == Task::check) return holds_whole_picture(*path, size) ? "" : "damaged";
    try {
        std::vector<std::byte> values(request.bytes);
        if (!receive_all(socket, values)) return std::nullopt;
        write_image(*path,
                    {.size = size,
                     .channels = request.channels,
                     .bits = request.bits,
                     .premultiplied = request.premultiplied != 0,
                     .values = values},
                    {.bits = request.file_bits, .dpi = request.dpi, .description = *description});
        return "";
    } catch (const FileError& error) {
        return error.what();
    }
}

/// What the process does until the other side is gone.
void serve(int socket) {
    for (const int signal : {SIGINT, SIGTERM}) ::signal(signal, SIG_IGN);
    // Libraries print what they find wrong with a damaged picture; errors go out as answers.
    if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
        ::dup2(nowhere, STDERR_FILENO);
    }
    try {
        image_module();
    } catch (const FileError&) {
        // Said when a picture comes: writing it tries again.
    }
    while (const std::optional<std::string> answer = answer_next(socket)) {
        if (!send_text(socket, *answer)) return;
    }
}

} // namespace

ImageWriter::ImageWriter() {
    if (has_one_thread()) start(); // a copy of a process with several may find locks held for ever
}

ImageWriter::~ImageWriter() {
    if (process_ > 0 && !writing_) ::kill(process_, SIGKILL); // it may still be loading
    end();
}

void ImageWriter::start() {
    std::array<int, 2> sockets{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) return;
    process_ = ::fork();
    if (process_ == 0) {
        ::close(sockets[0]);
        try {
            serve(sockets[1]);
        } catch (const std::exception&) {
            // No answer is one, too.
        }
        ::_exit(0); // what the program still has to say or to do is not for this copy
    }
    ::close(sockets[1]);
    socket_ = sockets[0];
}

void ImageWriter::end() {
    if (socket_ >= 0) ::close(socket_);
    while (process_ > 0 && ::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
    socket_ = process_ = -1;
}

void ImageWriter::write(const std::filesystem::path& path, const Pixels& pixels,
                        const ImageSettings& settings) {
    if (process_ <= 0) return write_image(path, pixels, settings);
    begin(path, pixels, settings);
    append(pixels.values);
}

void ImageWriter::begin(const std::filesystem::path& path, const Pixels& pixels,
                        const ImageSettings& settings) {
    finish();
    if (process_ <= 0) {
        growing_ = {path, pixels, settings, {}};
        growing_->values.reserve(bytes_of(pixels));
        return;
    }
    const Request request{.task = Task::write,
                          .width = pixels.size.x,
                          .height = pixels.size.y,
                          .channels = pixels.channels,
                          .bits = pixels.bits,
                          .premultiplied = pixels.premultiplied ? 1 : 0,
                          .file_bits = settings.bits,
                          .dpi = settings.dpi,
                          .bytes = bytes_of(pixels)};
    if (!send_request(socket_, request, path, settings.description)) throw no_process();
    writing_ = true;
}

void ImageWriter::append(std::span<const std::byte> values) {
    if (writing_) {
        if (!send_all(socket_, values)) throw no_process();
        return;
    }
    if (!growing_) return;
    growing_->values.insert(growing_->values.end(), values.begin(), values.end());
    if (growing_->values.size() < bytes_of(growing_->pixels)) return;
    const Growing whole = std::move(*growing_);
    growing_.reset();
    Pixels pixels = whole.pixels;
    pixels.values = whole.values;
    write_image(whole.path, pixels, whole.settings);
}

void ImageWriter::finish() {
    if (!writing_) return;
    writing_ = false;
    const std::optional<std::string> answer = receive_text(socket_);
    if (!answer) throw no_process();
    if (!answer->empty()) throw FileError(*answer);
}

bool ImageWriter::is_whole(const std::filesystem::path& path, glm::ivec2 size) {
    finish();
    Request request{};
    request.task = Task::check;
    request.width = size.x;
    request.height = size.y;
    if (process_ > 0 && send_request(socket_, request, path, {})) {
        if (const std::optional<std::string> answer = receive_text(socket_)) {
            return answer->empty();
        }
    }
    return holds_whole_picture(path, size);
}

} // namespace lineatlas
