#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace lineatlas::bench {

/// How many pixels of two picture files differ, and how many by more than a twentieth of a value's
/// range. Null if a file is missing or broken, or the sizes differ.
nlohmann::ordered_json compare_pictures(const std::filesystem::path& one,
                                        const std::filesystem::path& other);

} // namespace lineatlas::bench
