#include "image_writer.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
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

#include "atomic_file.hpp"
#include "confinement.hpp"
#include "image_encoder.hpp"
#include "lineatlas/error.hpp"
#include "message_socket.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

PictureTask::Numbers numbers_of(const Pixels& pixels, const ImageSettings& settings,
                                std::uint64_t bytes) {
    return {.kind = PictureTask::Kind::encode,
            .width = pixels.size.x,
            .height = pixels.size.y,
            .channels = pixels.channels,
            .bits = pixels.bits,
            .premultiplied = pixels.premultiplied ? 1 : 0,
            .file_bits = settings.bits,
            .dpi = settings.dpi,
            .bytes = bytes};
}

PictureTask check_task(const std::filesystem::path& path, glm::ivec2 size) {
    PictureTask task{.numbers = {}, .path = path.string(), .description = {}};
    task.numbers.kind = PictureTask::Kind::check;
    task.numbers.width = size.x;
    task.numbers.height = size.y;
    return task;
}

std::size_t bytes_of(const Pixels& pixels) {
    return static_cast<std::size_t>(pixels.size.x) * static_cast<std::size_t>(pixels.size.y) *
           static_cast<std::size_t>(pixels.channels) * static_cast<std::size_t>(pixels.bits / 8);
}

FileError no_process() {
    return FileError("the process that writes pictures has ended; is there enough memory?");
}

bool holds_whole_picture(const std::filesystem::path& path, glm::ivec2 size) {
    try {
        return is_whole_picture(read_source(path), size);
    } catch (const FileError&) {
        return false;
    }
}

/// A picture as it comes through the socket.
class Incoming {
  public:
    Incoming(int socket, std::uint64_t bytes) : socket_(socket), left_(bytes) {}

    /// The next piece of the picture, so that only the encoder holds a large picture as a whole.
    /// Empty after the last piece, or if no more will come.
    std::span<const std::byte> next() {
        piece_.resize(std::min<std::uint64_t>(left_, std::uint64_t{1} << 20U));
        left_ -= piece_.size();
        if (receive_all(socket_, piece_)) return piece_;
        left_ = 0;
        whole_ = false;
        return {};
    }
    /// Takes the rest of the picture. Returns whether all of it came.
    bool is_whole() {
        while (!next().empty()) continue;
        return whole_;
    }

  private:
    int socket_;
    std::uint64_t left_;
    bool whole_ = true;
    std::vector<std::byte> piece_;
};

/// Does the next task. The encoder makes the content of a file, and this process writes it. Returns
/// the answer: empty if all is well, else a message; nothing if no more tasks will come.
std::optional<std::string> answer_next(int socket, ImageEncoder& encoder) {
    std::optional<PictureTask> task = receive_task(socket);
    if (!task) return std::nullopt;
    const bool is_check = task->numbers.kind == PictureTask::Kind::check;
    Incoming picture{socket, is_check ? 0 : task->numbers.bytes};
    try {
        if (is_check) {
            const SourceFile file = read_source(task->path);
            task->numbers.bytes = file.bytes.size();
            encoder.begin(*task);
            encoder.append(std::as_bytes(std::span{file.bytes}));
            encoder.finish();
            return "";
        }
        encoder.begin(*task);
        for (auto piece = picture.next(); !piece.empty(); piece = picture.next())
            encoder.append(piece);
        if (!picture.is_whole()) return std::nullopt;
        const std::string encoded = encoder.finish();
        AtomicFile{task->path}.commit(
            {reinterpret_cast<const unsigned char*>(encoded.data()), encoded.size()});
        return "";
    } catch (const FileError& error) {
        if (!picture.is_whole()) return std::nullopt;
        return error.what();
    }
}

/// The work of the process until the other side is gone.
void serve(int socket, PictureType first, const ReadLimits& limits) {
    for (const int signal : {SIGINT, SIGTERM}) ::signal(signal, SIG_IGN);
    ::dup2(socket, STDIN_FILENO);
    // Libraries print what they find wrong with a damaged picture; errors go out as answers.
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        if (::dup2(nowhere, output) < 0) ::close(output);
    forget_what_was_inherited();
    ImageEncoder encoder{first, limits};
    while (const std::optional<std::string> answer = answer_next(STDIN_FILENO, encoder)) {
        if (!send_text(STDIN_FILENO, *answer)) return;
    }
}

} // namespace

ImageWriter::ImageWriter(const std::filesystem::path& first, const ReadLimits& limits) {
    // A copy of a process with several threads may find locks held for ever.
    if (has_one_thread()) start(type_by_name(first), limits);
}

ImageWriter::~ImageWriter() {
    if (process_ > 0 && !writing_) ::kill(process_, SIGKILL); // it may still be loading the module
    end();
}

void ImageWriter::start(PictureType first, const ReadLimits& limits) {
    std::array<int, 2> sockets{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) return;
    process_ = ::fork();
    if (process_ == 0) {
        ::close(sockets[0]);
        try {
            serve(sockets[1], first, limits);
        } catch (const std::exception&) {
            // The missing answer tells the other side.
        }
        ::_exit(0); // this copy must not do what the program does at its end
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
    const PictureTask task{.numbers = numbers_of(pixels, settings, bytes_of(pixels)),
                           .path = path.string(),
                           .description = settings.description};
    if (!send_task(socket_, task)) throw no_process();
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

void ImageWriter::abandon() {
    growing_.reset();
    if (!writing_) return;
    writing_ = false;
    end();
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
    if (process_ > 0 && send_task(socket_, check_task(path, size))) {
        if (const std::optional<std::string> answer = receive_text(socket_)) {
            return answer->empty();
        }
    }
    return holds_whole_picture(path, size);
}

} // namespace lineatlas
