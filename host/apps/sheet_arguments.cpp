#include "sheet_arguments.hpp"

#include <algorithm>
#include <array>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/drawing_scale.hpp"
#include "io/source_file.hpp"
#include "lineatlas/error.hpp"
#include "output/path_file.hpp"
#include "pdf/pdf.hpp"

namespace lineatlas::apps {
namespace {

/// Options that sheets do not have. A sheet has its own cameras and paper, and is drawn once by the
/// exact method.
constexpr std::array not_of_sheets{
    "--at",    "--size",   "--turntable", "--camera-path",  "--frames", "--resume",
    "--units", "--margin", "--plotter",   "--certify",      "--bits",   "--tile",
    "--stats", "--repeat", "--profile",   "--compare-with", "--interop"};

/// Sets a field from text such as "title=Bracket".
void set_field(SheetFields& fields, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw UsageError("--field \"" + text +
                         "\" has no value; it is written as in title=Bracket");
    lineatlas::set_field(fields, text.substr(0, equals), text.substr(equals + 1));
}

/// The sheet as --views, --projection and --scale have it, the other two over what a file says.
SheetOptions sheet_of(const ViewOptions& view) {
    SheetOptions options;
    if (SheetArguments::is_file(view))
        options = load_sheet(view.views());
    else if (!SheetArguments::wants_summary(view))
        options.views = parse_views(view.views());
    if (!view.projection_name().empty())
        options.angle = parse_projection_angle(view.projection_name());
    if (view.to_scale()) options.scale = view.scale();
    return options;
}

} // namespace

void SheetArguments::declare(CLI::App& app) {
    app_ = &app;
    app.add_option("--field", fields_,
                   "NAME=VALUE: a field of the title block of --views: title, file, owner, number, "
                   "creator, approver or date; may be repeated")
        ->allow_extra_args(false)
        ->group("Sheet (--views)");
    app.add_option("--detail", details_,
                   "VIEW/X,Y,Z/RADIUS: a part of a view of --views once more, at twice its scale, "
                   "within a circle about a point of the model; may be repeated. "
                   "VIEW/X,Y,Z/RADIUS/SCALE has a scale of its own, as in 5:1")
        ->allow_extra_args(false)
        ->group("Sheet (--views)");
}

void SheetArguments::check(const ViewOptions& view, const std::filesystem::path& output) const {
    if (!view.is_sheet()) {
        if (!fields_.empty())
            throw UsageError("--field needs --views; add it, or leave out --field");
        if (!details_.empty())
            throw UsageError("--detail needs --views; add it, or leave out --detail");
        return;
    }
    for (const char* option : not_of_sheets)
        if (app_->count(option) > 0)
            throw UsageError(
                fmt::format("--views and {} exclude each other; leave out one of them", option));
    sheet_of(view);
    if (view.to_scale()) parse_scale("--scale", view.scale());
    SheetFields fields;
    for (const std::string& field : fields_) set_field(fields, field);
    for (const std::string& detail : details_) parse_detail(detail);
    const std::optional<PathFile> type = path_file_type(output);
    if (type == PathFile::json)
        throw write_error(output, "a sheet is written as SVG, PDF, DXF or a picture; JSON has one "
                                  "view, see --view");
    if (!type || type == PathFile::pdf) check_pdf_module();
}

bool SheetArguments::has_sections(const ViewOptions& view) {
    const auto is_section = [](const std::string& name) { return name.starts_with("section:"); };
    return view.is_sheet() && std::ranges::any_of(sheet_of(view).views, is_section);
}

SheetOptions SheetArguments::options(const ViewOptions& view, const std::optional<Page>& page,
                                     const std::filesystem::path& model,
                                     std::optional<double> unit_of_file, glm::vec3 up,
                                     glm::dvec3 origin) const {
    SheetOptions options = sheet_of(view);
    options.unit = view.unit(unit_of_file);
    options.up = up;
    options.origin = origin;
    options.measures = wants_summary(view);
    if (page) options.page = *page;
    for (const std::string& detail : details_) options.details.push_back(parse_detail(detail));
    if (options.fields.title.empty()) options.fields.title = model.stem().string();
    if (options.fields.file.empty()) options.fields.file = model.filename().string();
    for (const std::string& field : fields_) set_field(options.fields, field);
    return options;
}

} // namespace lineatlas::apps
