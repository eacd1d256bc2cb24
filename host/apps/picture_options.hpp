#pragma once

#include <filesystem>

#include "command_line/cli_fwd.hpp"
#include "lineatlas/io.hpp"

namespace lineatlas::apps {

/// --bits, --dpi, --transparent and --tile.
class PictureOptions {
  public:
    void declare(CLI::App& app);

    /// Throws UsageError for wrong values, and FileError if the picture's type does not allow them.
    void check(const std::filesystem::path& output) const;
    bool transparent() const { return transparent_; }
    int tile_size() const { return tile_; } ///< 0: not given
    ImageSettings settings() const { return {.bits = bits_, .dpi = dpi_, .description = {}}; }

  private:
    int bits_ = 0;
    float dpi_ = 0;
    bool transparent_ = false;
    int tile_ = 0;
};

} // namespace lineatlas::apps
