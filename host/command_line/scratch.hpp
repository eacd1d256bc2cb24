#pragma once

#include <filesystem>
#include <string>

#include <stdlib.h>

#include "lineatlas/error.hpp"

namespace lineatlas {

/// A new folder under the temporary directory, which is removed with this object. Throws Error.
class Scratch {
  public:
    Scratch() {
        std::string name = (std::filesystem::temp_directory_path() / "lineatlas-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw Error("cannot make a folder " + name);
        folder = name;
    }
    ~Scratch() {
        std::error_code error;
        std::filesystem::remove_all(folder, error);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::filesystem::path folder;
};

} // namespace lineatlas
