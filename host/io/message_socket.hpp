#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace lineatlas {

// Messages over a stream socket between two processes of this program.

/// False when the other side is gone.
bool send_all(int socket, std::span<const std::byte> bytes);
bool receive_all(int socket, std::span<std::byte> bytes);

/// A text with its length before it.
bool send_text(int socket, const std::string& text);
std::optional<std::string> receive_text(int socket);

} // namespace lineatlas
