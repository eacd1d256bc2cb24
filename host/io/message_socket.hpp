#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lineatlas {

// Messages over a stream socket between two processes of this program.

/// False if the other side is gone.
bool send_all(int socket, std::span<const std::byte> bytes);
bool receive_all(int socket, std::span<std::byte> bytes);

/// How long talking to the other side may take in all: waiting for it, and sending and receiving.
/// Time is counted in short intervals, so that an interval in which this process was stopped
/// (Ctrl-Z) hardly counts.
class Patience {
  public:
    explicit Patience(std::chrono::nanoseconds most) : left_(most) {}

    /// Counts time from the call on.
    void resume() { last_ = Clock::now(); }
    /// Waits until poll() reports one of `events`; false if it takes too long.
    bool wait_for(int socket, short events);
    bool is_over() const { return left_.count() <= 0; }

  private:
    using Clock = std::chrono::steady_clock;

    std::chrono::nanoseconds left_;
    Clock::time_point last_{}; ///< time has been counted up to here
};

/// As above, for no longer than `patience`.
bool send_all(int socket, std::span<const std::byte> bytes, Patience& patience);
bool receive_all(int socket, std::span<std::byte> bytes, Patience& patience);
/// Receives as many bytes as there are, at least one. Returns 0 if the other side is gone or the
/// time is over.
std::size_t receive_some(int socket, std::span<std::byte> bytes, Patience& patience);

/// Sends a text with its length before it.
bool send_text(int socket, std::string_view text);
std::optional<std::string> receive_text(int socket);

} // namespace lineatlas
