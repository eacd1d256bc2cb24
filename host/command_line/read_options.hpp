#pragma once

#include <map>
#include <string>

#include "cli_fwd.hpp"
#include "io/isolated.hpp"
#include "lineatlas/style.hpp"

namespace lineatlas {

/// --read-memory and --read-seconds: limits of the process that reads a file.
class ReadOptions {
  public:
    void declare(CLI::App& app);
    /// Throws UsageError.
    void check() const;

    ReadLimits limits() const;
    /// The pictures of a style's pens. Throws FileError.
    std::map<std::string, Image> pen_images(const Style& style) const;

  private:
    double gibibytes_ = 0; ///< 0: not given
    double seconds_ = 0;
    const CLI::App* app_ = nullptr;
};

} // namespace lineatlas
