#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include <unistd.h>

#include "environment_variable.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::test {

/// A copy of the kernels and shaders with one piece of text replaced. Programs use the copy while
/// this object lives.
class PlantedError {
  public:
    PlantedError(const std::string& file, const std::string& from, const std::string& to)
        : folder_(std::filesystem::temp_directory_path() /
                  ("lineatlas_planted_" + std::to_string(::getpid()))) {
        namespace fs = std::filesystem;
        fs::remove_all(folder_); // may be left by a constructor that threw
        fs::create_directories(folder_);
        for (const char* source : {"kernels", "shaders"}) {
            fs::copy(fs::path{LINEATLAS_SOURCE_DIR} / source, folder_, fs::copy_options::recursive);
        }
        std::ostringstream content;
        content << std::ifstream{folder_ / file}.rdbuf();
        std::string text = content.str();
        const std::size_t place = text.find(from);
        if (place == std::string::npos) throw Error(file + " does not hold: " + from);
        std::ofstream{folder_ / file} << text.replace(place, from.size(), to);
        kernels_.emplace("LINEATLAS_KERNEL_DIR", folder_.string());
        shaders_.emplace("LINEATLAS_SHADER_DIR", folder_.string());
    }
    ~PlantedError() { std::filesystem::remove_all(folder_); }
    PlantedError(const PlantedError&) = delete;
    PlantedError& operator=(const PlantedError&) = delete;

  private:
    std::filesystem::path folder_;
    std::optional<EnvironmentVariable> kernels_, shaders_; ///< set once the copy is whole
};

} // namespace lineatlas::test
