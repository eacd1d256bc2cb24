#include "picture_options.hpp"

#include <cmath>

#include <CLI/App.hpp>

#include "lineatlas/error.hpp"

namespace lineatlas::apps {

void PictureOptions::declare(CLI::App& app) {
    const std::string group = "Picture file";
    app.add_option("--bits", bits_,
                   "Bits per channel: PNG and TIFF 8 (default) or 16, EXR 16 (default) or 32")
        ->group(group);
    app.add_option("--dpi", dpi_, "Pixels per inch on paper, noted in the file")->group(group);
    app.add_flag("--transparent", transparent_, "Leave the paper out: PNG, TIFF and EXR")
        ->group(group);
    app.add_option("--tile", tile_,
                   "Draw by tiles of so many pixels a side, with less memory; also done without "
                   "this option if GL cannot draw the picture in one piece")
        ->group(group);
}

void PictureOptions::check(const std::filesystem::path& output) const {
    if (bits_ != 0 && bits_ != 8 && bits_ != 16 && bits_ != 32) {
        throw UsageError("--bits must be 8, 16 or 32");
    }
    constexpr int smallest_tile = 16;
    if (tile_ != 0 && tile_ < smallest_tile) throw UsageError("--tile must be at least 16 pixels");
    constexpr float finest = 100'000;
    if (!(dpi_ >= 0) || dpi_ > finest) throw UsageError("--dpi must be a number from 0 to 100000");
    check_image_settings(output, settings(), transparent_);
}

} // namespace lineatlas::apps
