#pragma once

#include <filesystem>
#include <vector>

namespace lineatlas::viewer {

struct FileEntry {
    std::filesystem::path path;
    bool is_folder = false;
};

/// The files of a folder that Session::open() takes, and its folders, by name; folders first. Names
/// that begin with a dot are left out. Empty for a folder that can't be read.
std::vector<FileEntry> list_folder(const std::filesystem::path& folder);

/// The files that were opened last, the latest first, kept from one run to the next.
class RecentFiles {
  public:
    /// `store`: a text file with a path a line; its folder is made. Empty: nothing is kept.
    explicit RecentFiles(std::filesystem::path store);

    /// The files, each once, as far as they existed at the last look.
    const std::vector<std::filesystem::path>& all() const { return all_; }
    void forget_lost();
    /// Adds a file. Ignores a store that cannot be written, because the file was opened all the
    /// same.
    void add(const std::filesystem::path& file);

  private:
    std::filesystem::path store_;
    std::vector<std::filesystem::path> all_;
};

/// Where RecentFiles are kept: below XDG_STATE_HOME, or ~/.local/state. Empty without either.
std::filesystem::path recent_files_store();

} // namespace lineatlas::viewer
