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
    /// A file that is read; what is none is left alone.
    void reads(const std::filesystem::path& path);
    /// A file that is written for `option`. Throws UsageError.
    void writes(std::string_view option, const std::filesystem::path& path);
    /// The same for one of many, whose names differ among themselves.
    void check(std::string_view option, const std::filesystem::path& path) const;

  private:
    std::map<std::filesystem::path, std::string> known_; ///< and what lies there
};

} // namespace lineatlas::apps
