#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace lineatlas::apps {

/// Where the files of one command lie, links followed: nothing that is read may be written, and no
/// file may be written for two options.
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
