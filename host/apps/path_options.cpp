#include "path_options.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "io/extension.hpp"
#include "io/source_file.hpp"
#include "lineatlas/error.hpp"
#include "output/path_file.hpp"
#include "pdf/pdf.hpp"
#include "truth/ray_scene.hpp"

namespace lineatlas::apps {
namespace {

constexpr const char* own_options[] = {"--units",    "--page",    "--margin",  "--curves",
                                       "--fit-arcs", "--plotter", "--no-tags", "--certify"};
constexpr const char* of_paper[] = {"--units", "--page", "--margin", "--curves", "--fit-arcs"};
constexpr const char* not_in_millimetres[] = {"--units", "--no-tags"};
constexpr const char* only_for_pixels[] = {"--bits", "--dpi"};
constexpr const char* only_for_svg[] = {"--no-tags"};

constexpr std::string_view types_of_others[] = {".eps", ".ps", ".dwg", ".ai", ".hpgl"};

void refuse_types_of_others(const std::filesystem::path& output) {
    const std::string extension = lower_extension(output);
    if (std::ranges::find(types_of_others, extension) == std::end(types_of_others)) return;
    throw write_error(output, "drawings as paths are .svg, .pdf, .dxf or .json; other programs "
                              "make " +
                                  extension + " of these");
}

} // namespace

void PathOptions::declare(CLI::App& app) {
    app_ = &app;
    const std::string group = "Paths (output .svg, .pdf, .dxf or .json)";
    app.add_option("--units", units_,
                   "Units of the SVG: px, mm or in; default mm with --page, else px")
        ->group(group);
    app.add_option(
           "--page", page_,
           "Paper: a0 to a6, letter, legal, tabloid or e.g. 300x200mm; the picture fills it")
        ->group(group);
    app.add_option("--margin", margin_, "Space around the picture on paper, e.g. 10mm")
        ->capture_default_str()
        ->group(group);
    app.add_option("--curves", curves_,
                   "Circles, ellipses and curves of STEP, IGES and BREP files, and circles of "
                   "meshes: as arcs and cubic curves (auto) or as chords (none)")
        ->check(CLI::IsMember({"auto", "none"}))
        ->capture_default_str()
        ->group(group);
    app.add_flag("--fit-arcs", fit_arcs_,
                 "Find circles and arcs in other lines, too, as they are drawn")
        ->group(group);
    app.add_flag("--plotter", plotter_, "Order and join paths for the least travel of a pen")
        ->group(group);
    app.add_flag("--no-tags", no_tags_, "Leave out which edges of the model each path shows")
        ->group(group);
    app.add_flag("--certify", certify_,
                 "Check the drawing by rays; the result is printed and written into the file")
        ->group(group);
}

void PathOptions::refuse(std::span<const char* const> options, const std::string& why) const {
    for (const char* option : options)
        if (app_->count(option) > 0) throw UsageError(fmt::format("{} {}", option, why));
}

void PathOptions::check(const std::filesystem::path& output, Method method) const {
    if (!is_path_file(output)) {
        refuse_types_of_others(output);
        return refuse(own_options,
                      "is for paths; the output must end in .svg, .pdf, .dxf or .json");
    }
    refuse(only_for_pixels, "is for pictures of pixels; see --units and --page");
    const PathFile type = path_file_type(output).value();
    if (type == PathFile::json) refuse(of_paper, "is for paper; JSON is in pixels");
    if (type == PathFile::dxf || type == PathFile::pdf)
        refuse(not_in_millimetres, "is for SVG; DXF and PDF have units of their own and no tags");
    if (type == PathFile::pdf) check_pdf_module();
    if (method != Method::atlas && method != Method::exact) {
        throw UsageError("--method: only atlas and exact make paths");
    }
    svg();
    if (certify_) check_ray_module();
}

Style PathOptions::on_paper(const Style& style, glm::ivec2 size) const {
    const SvgOptions options = svg();
    return options.page ? style_on_page(style, size, *options.page, options.margin) : style;
}

void PathOptions::check_sheet(const std::filesystem::path& output, Method method) const {
    refuse_types_of_others(output);
    const std::optional<PathFile> type = path_file_type(output);
    if (type) refuse(only_for_pixels, "is for pictures of pixels; see --page");
    if (type != PathFile::svg) refuse(only_for_svg, "is for SVG alone, which has tags");
    if (method != Method::exact) throw UsageError("--method: only exact makes a sheet");
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
    options.curves = curves_ != "none";
    options.fit_arcs = fit_arcs_;
    return options;
}

} // namespace lineatlas::apps
