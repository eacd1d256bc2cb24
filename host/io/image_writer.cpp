#include "image_writer.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <system_error>

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "image_loader.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {

namespace {

/// Goes before the pixels.
struct Header {
    std::int32_t width, height;
    std::uint64_t channels, pixels; ///< pixels: values, as in Image
};

constexpr char done = '+'; ///< the answer; else it is a message

bool send_all(int socket, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool receive_all(int socket, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t got = ::recv(socket, bytes.data(), bytes.size(), 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

/// All that comes until the other side closes.
std::string receive_answer(int socket) {
    std::string answer;
    for (std::byte next{}; receive_all(socket, {&next, 1});) answer += static_cast<char>(next);
    return answer;
}

bool has_one_thread() {
    std::error_code error;
    const std::filesystem::directory_iterator threads("/proc/self/task", error);
    return !error && std::distance(begin(threads), end(threads)) == 1;
}

/// What the process does: load, wait for the picture, write it.
std::string write_received(int socket, const std::filesystem::path& path) {
    try {
        image_module();
        Header header{};
        if (!receive_all(socket, std::as_writable_bytes(std::span{&header, 1}))) return {};
        Image image{.size = {header.width, header.height},
                    .channels = static_cast<int>(header.channels),
                    .pixels = {}};
        image.pixels.resize(header.pixels);
        if (!receive_all(socket, std::as_writable_bytes(std::span{image.pixels}))) return {};
        write_image(path, image);
        return {done};
    } catch (const FileError& error) {
        return error.what();
    } catch (const std::exception&) {
        return {}; // no answer: the picture is written on the other side
    }
}

} // namespace

ImageWriter::ImageWriter(const std::filesystem::path& path) : path_(path) {
    check_image_path(path);
    if (has_one_thread()) start(); // a copy of a process with several may find locks held for ever
}

ImageWriter::~ImageWriter() {
    if (process_ > 0) ::kill(process_, SIGKILL);
    end();
}

void ImageWriter::start() {
    std::array<int, 2> sockets{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) return;
    process_ = ::fork();
    if (process_ == 0) {
        ::close(sockets[0]);
        const std::string answer = write_received(sockets[1], path_);
        send_all(sockets[1], std::as_bytes(std::span{answer}));
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

void ImageWriter::write(const Image& image) {
    std::string answer;
    if (process_ > 0) {
        const Header header{.width = image.size.x,
                            .height = image.size.y,
                            .channels = static_cast<std::uint64_t>(image.channels),
                            .pixels = image.pixels.size()};
        if (send_all(socket_, std::as_bytes(std::span{&header, 1})))
            send_all(socket_, std::as_bytes(std::span{image.pixels}));
        ::shutdown(socket_, SHUT_WR);
        answer = receive_answer(socket_);
    }
    end();
    if (answer.empty()) return write_image(path_, image);
    if (answer[0] != done) throw FileError(answer);
}

} // namespace lineatlas
