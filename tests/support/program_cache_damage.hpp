#pragma once

#include <filesystem>
#include <random>
#include <string>

namespace lineatlas::test {

/// Damages a file in a way that `random` chooses: flips bits, cuts or empties it, puts garbage
/// behind it or in its place, or swaps it with `other`. Returns the way in words.
std::string damage(const std::filesystem::path& file, const std::filesystem::path& other,
                   std::minstd_rand& random);

} // namespace lineatlas::test
