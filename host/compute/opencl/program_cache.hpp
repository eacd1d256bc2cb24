#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace lineatlas::compute {

/// Built programs in files, one each, in a folder that many processes may use at once.
///
/// Nothing in the folder is trusted: `find` returns a whole program that this user stored under
/// this key, or nothing. Failures are no errors: a program that cannot be stored is built again the
/// next time.
class ProgramCache {
  public:
    static constexpr std::uintmax_t default_limit = std::uintmax_t{64} << 20U;

    /// `limit`: bytes that its files may take together; the longest unused go first.
    explicit ProgramCache(std::filesystem::path folder, std::uintmax_t limit = default_limit);

    /// The user's folder: $XDG_CACHE_HOME/lineatlas, else ~/.cache/lineatlas. None if neither
    /// variable is set.
    static std::optional<std::filesystem::path> default_folder();

    /// The program stored under `key`.
    std::optional<std::vector<unsigned char>> find(std::string_view key) const;

    /// Stores a program under `key`, in place of another one. False: it was not stored.
    bool store(std::string_view key, std::span<const unsigned char> program) const;

    /// The file of the program with this key, whether or not it exists.
    std::filesystem::path file_of(std::string_view key) const;

  private:
    void tidy() const;

    std::filesystem::path folder_;
    std::uintmax_t limit_;
};

} // namespace lineatlas::compute
