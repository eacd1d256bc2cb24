#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace lineatlas::compute {

/// The content of a regular file. Nothing if the file does not exist, cannot be read, is longer
/// than `most_bytes`, belongs to another user or may be written by one.
std::optional<std::vector<unsigned char>> read_cache_file(const std::filesystem::path& path,
                                                          std::uintmax_t most_bytes);

/// Makes a file that appears whole or not at all, and its folder, both for this user alone. Returns
/// false and leaves nothing if that fails. A killed writer may leave a file in the folder whose
/// name ends in `part_extension`.
///
/// Unlike pictures, the file is not flushed to the disk. After a crash of the machine its reader
/// notices the damage.
bool write_cache_file(const std::filesystem::path& path, std::string_view part_extension,
                      std::span<const unsigned char> content);

} // namespace lineatlas::compute
