#pragma once

#include <cstdint>
#include <string_view>

#include <unistd.h>

namespace lineatlas::reader {

// The protocol between the two ends of a ReaderProcess.

/// The first argument of a process that reads. Next come the kind, the path, the bytes of memory
/// that it may take, the process that started it, and settings for the kind.
inline constexpr std::string_view argument = "--read-one-file";
inline constexpr int argument_count = 7;

/// The descriptor of the process's socket.
inline constexpr int socket = STDIN_FILENO;

/// Comes first. `read` is followed by the result, `refused` by a message with its size before it,
/// `no_memory` by nothing.
enum class Answer : std::uint8_t { read = 1, refused, no_memory };

/// Bytes of the longest message that says why a file is refused.
inline constexpr std::uint64_t longest_refusal = std::uint64_t{64} << 10U;

/// Whether this is a build with sanitizers. They reserve terabytes, so memory cannot be limited,
/// and they report on stderr.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ||                         \
    __has_feature(memory_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

} // namespace lineatlas::reader
