#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lineatlas {

// Messages over a stream socket between two processes of this program.

/// False when the other side is gone.
bool send_all(int socket, std::span<const std::byte> bytes);
bool receive_all(int socket, std::span<std::byte> bytes);

/// How long the other side may let one wait, all in all. Counted in short waits: a time in which
/// this process was stopped (Ctrl-Z) is not the other's.
class Patience {
  public:
    explicit Patience(std::chrono::nanoseconds most) : left_(most) {}

    /// Waits until poll() reports one of `events`; false if it takes too long.
    bool wait_for(int socket, short events);
    bool is_over() const { return left_.count() <= 0; }

  private:
    std::chrono::nanoseconds left_;
};

/// The same for no longer than that.
bool send_all(int socket, std::span<const std::byte> bytes, Patience& patience);
bool receive_all(int socket, std::span<std::byte> bytes, Patience& patience);

/// A text with its length before it.
bool send_text(int socket, std::string_view text);
std::optional<std::string> receive_text(int socket);

} // namespace lineatlas
