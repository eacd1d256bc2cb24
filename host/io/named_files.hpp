#pragma once

#include <filesystem>
#include <string>

namespace lineatlas {

/// Files that a model names. Only regular files beside the model or below its folder are read,
/// wherever links lead, so that a stranger's model cannot find out about other files on this
/// machine.
class NamedFiles {
  public:
    explicit NamedFiles(const std::filesystem::path& model);

    enum class Outcome { read, missing, outside };
    /// Reads a file into `contents`.
    Outcome read(const std::filesystem::path& name, std::string& contents) const;

  private:
    std::filesystem::path folder_, real_folder_;
};

} // namespace lineatlas
