#pragma once

#include <filesystem>
#include <string>

namespace lineatlas {

/// Files that a model names, of which only regular ones beside the model or below its folder are
/// read, wherever links lead: a model that was sent by somebody says nothing about what else is on
/// this machine.
class NamedFiles {
  public:
    explicit NamedFiles(const std::filesystem::path& model);

    enum class Outcome { read, missing, outside };
    /// Puts what the file holds into `contents`.
    Outcome read(const std::filesystem::path& name, std::string& contents) const;

  private:
    std::filesystem::path folder_, real_folder_;
};

} // namespace lineatlas
