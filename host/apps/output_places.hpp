#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace lineatlas::apps {

/// The places of one command's files, with links followed. A file that is read must not be written,
/// and no file may be the output of two options.
class OutputPlaces {
  public:
    /// Adds a file that is read. Ignores a path that is no file.
    void reads(const std::filesystem::path& path);
    /// Adds a file that `option` writes. Throws UsageError if it is taken.
    void writes(std::string_view option, const std::filesystem::path& path);
    /// As writes(), for one of many files whose names differ. Adds nothing.
    void check(std::string_view option, const std::filesystem::path& path) const;

  private:
    std::map<std::filesystem::path, std::string> known_; ///< places, and what lies there
};

} // namespace lineatlas::apps
