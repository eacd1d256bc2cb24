#pragma once

#include <filesystem>
#include <random>
#include <string>

namespace lineatlas::test {

/// Damages a file in a way drawn by `random`: bits flipped, cut, emptied, garbage behind it or in
/// its place, or swapped with `other`. Returns what it did.
std::string damage(const std::filesystem::path& file, const std::filesystem::path& other,
                   std::minstd_rand& random);

} // namespace lineatlas::test
