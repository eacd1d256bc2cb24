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

/// How long talking to the other side may take, all in all: what it lets one wait, and what sending
/// and receiving itself takes. Counted in short times: one in which this process was stopped
/// (Ctrl-Z) is not the other's.
class Patience {
  public:
    explicit Patience(std::chrono::nanoseconds most) : left_(most) {}

    /// From now on time counts.
    void resume() { last_ = Clock::now(); }
    /// Waits until poll() reports one of `events`; false if it takes too long.
    bool wait_for(int socket, short events);
    bool is_over() const { return left_.count() <= 0; }

  private:
    using Clock = std::chrono::steady_clock;

    std::chrono::nanoseconds left_;
    Clock::time_point last_{}; ///< until then time has been counted
};

/// The same for no longer than that.
bool send_all(int socket, std::span<const std::byte> bytes, Patience& patience);
bool receive_all(int socket, std::span<std::byte> bytes, Patience& patience);
/// As many bytes as there are, one at least; 0 when the other side is gone or the time is over.
std::size_t receive_some(int socket, std::span<std::byte> bytes, Patience& patience);

/// A text with its length before it.
bool send_text(int socket, std::string_view text);
std::optional<std::string> receive_text(int socket);

} // namespace lineatlas
