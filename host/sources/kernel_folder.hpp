#pragma once

#include <filesystem>
#include <map>

namespace lineatlas {

/// Looks now and then whether files were written in the folder that LINEATLAS_KERNEL_DIR names.
class KernelFolder {
  public:
    /// What is there now counts as seen.
    KernelFolder();

    /// False where the variable is not set.
    bool is_set() const { return !folder_.empty(); }
    const std::filesystem::path& path() const { return folder_; }

    /// Whether files were written, added or removed since it last said so. It says so when two
    /// looks in turn find the same, since editors write in several steps.
    bool has_changed();

  private:
    using WriteTimes = std::map<std::filesystem::path, std::filesystem::file_time_type>;
    WriteTimes look() const;

    std::filesystem::path folder_;
    WriteTimes seen_, last_;
};

} // namespace lineatlas
