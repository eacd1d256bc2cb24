#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace lineatlas::compute {

/// A regular file's content; none if there is no such file, it can't be read, is longer than
/// `most_bytes`, belongs to another user or may be written by one.
std::optional<std::vector<unsigned char>> read_cache_file(const std::filesystem::path& path,
                                                          std::uintmax_t most_bytes);

/// Makes a file that appears whole or not at all, and its folder, both for this user alone. What
/// can't be written is not. A writer that is killed may leave a file in the folder whose name ends
/// in `part_extension`.
///
/// Unlike a picture's, the file is not flushed to the disk: after a crash of the machine its reader
/// finds out that it is damaged.
void write_cache_file(const std::filesystem::path& path, std::string_view part_extension,
                      std::span<const unsigned char> content);

} // namespace lineatlas::compute
