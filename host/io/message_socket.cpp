#include "message_socket.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>

#include <poll.h>
#include <sys/socket.h>

namespace lineatlas {

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

bool Patience::wait_for(int socket, short events) {
    constexpr std::chrono::milliseconds longest{100};
    while (!is_over()) {
        const auto part = std::min(longest, std::chrono::ceil<std::chrono::milliseconds>(left_));
        pollfd waiting{.fd = socket, .events = events, .revents = 0};
        const int ready = ::poll(&waiting, 1, static_cast<int>(part.count()));
        const Clock::time_point now = Clock::now();
        left_ -= std::min<std::chrono::nanoseconds>(now - last_, 2 * longest);
        last_ = now;
        if (ready > 0) return !is_over(); // data that comes too late is not taken
    }
    return false;
}

bool send_all(int socket, std::span<const std::byte> bytes, Patience& patience) {
    patience.resume();
    while (!bytes.empty()) {
        if (!patience.wait_for(socket, POLLOUT)) return false;
        const ssize_t sent =
            ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (sent <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

std::size_t receive_some(int socket, std::span<std::byte> bytes, Patience& patience) {
    patience.resume();
    while (patience.wait_for(socket, POLLIN)) {
        const ssize_t got = ::recv(socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        return got > 0 ? static_cast<std::size_t>(got) : 0;
    }
    return 0;
}

bool receive_all(int socket, std::span<std::byte> bytes, Patience& patience) {
    while (!bytes.empty()) {
        const std::size_t got = receive_some(socket, bytes, patience);
        if (got == 0) return false;
        bytes = bytes.subspan(got);
    }
    return true;
}

bool send_text(int socket, std::string_view text) {
    const std::uint64_t size = text.size();
    return send_all(socket, std::as_bytes(std::span{&size, 1})) &&
           send_all(socket, std::as_bytes(std::span{text}));
}

std::optional<std::string> receive_text(int socket) {
    std::uint64_t size = 0;
    if (!receive_all(socket, std::as_writable_bytes(std::span{&size, 1}))) return std::nullopt;
    std::string text(size, '\0');
    if (!receive_all(socket, std::as_writable_bytes(std::span{text}))) return std::nullopt;
    return text;
}

} // namespace lineatlas
