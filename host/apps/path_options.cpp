#include "path_options.hpp"

#include <span>

#include <fmt/format.h>

#include "io/extension.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

constexpr const char* own_options[] = {"--units", "--page", "--margin", "--plotter", "--no-tags"};
constexpr const char* only_for_svg[] = {"--units", "--page", "--margin"};
constexpr const char* only_for_pixels[] = {"--bits", "--dpi"};

} // namespace

bool is_json_file(const std::filesystem::path& path) {
    return lower_extension(path) == ".json";
}
bool is_path_file(const std::filesystem::path& path) {
    return lower_extension(path) == ".svg" || is_json_file(path);
}

void PathOptions::declare(CLI::App& app) {
    app_ = &app;
    const std::string group = "Paths (output .svg or .json)";
    app.add_option("--units", units_,
                   "Units of the SVG: px, mm or in; default mm with --page, else px")
        ->group(group);
    app.add_option("--page", page_,
                   "Paper of the SVG: a0 to a6, letter, legal, tabloid or e.g. 300x200mm; the "
                   "picture fills it")
        ->group(group);
    app.add_option("--margin", margin_, "Space around the picture in the SVG, e.g. 10mm")
        ->capture_default_str()
        ->group(group);
    app.add_flag("--plotter", plotter_, "Order and join paths for the least travel of a pen")
        ->group(group);
    app.add_flag("--no-tags", no_tags_, "Leave out which edges of the model each path shows")
        ->group(group);
}

void PathOptions::check(const std::filesystem::path& output) const {
    const auto refuse = [&](std::span<const char* const> options, const std::string& why) {
        for (const char* option : options) {
            if (app_->count(option) > 0) throw UsageError(fmt::format("{} {}", option, why));
        }
    };
    if (!is_path_file(output)) {
        return refuse(own_options, "is for paths; the output must end in .svg or .json");
    }
    refuse(only_for_pixels, "is for pictures of pixels; see --units and --page");
    if (is_json_file(output)) refuse(only_for_svg, "is for SVG; JSON is in pixels");
    if (app_->get_option("--method")->as<std::string>() != "atlas") {
        throw UsageError("--method: paths come from the atlas alone");
    }
    svg();
}

SvgOptions PathOptions::svg() const {
    SvgOptions options;
    if (!page_.empty()) {
        options.page = parse_page(page_);
        options.units = Unit::mm;
    }
    if (!units_.empty()) options.units = parse_unit(units_);
    options.margin = parse_length(margin_, options.units);
    options.tags = tags();
    return options;
}

} // namespace lineatlas::apps
