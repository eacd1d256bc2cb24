#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "drawer.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/fills.hpp"
#include "lineatlas/framing.hpp"
#include "lineatlas/section.hpp"
#include "lineatlas/sheet.hpp"
#include "lineatlas/style_files.hpp"
#include "options.hpp"
#include "pdf/pdf.hpp"
#include "progress.hpp"
#include "style_values.hpp"
#include "views.hpp"

namespace lineatlas::python {
namespace {

using MaybeStyle = Argument<std::optional<StyleOrName>, "style",
                            "a Style, the name of one or the path of a style file">;
using MaybeViews = Argument<std::optional<std::string>, "views", "text such as \"front,top\"">;
using Details =
    Argument<std::vector<std::string>, "details", "a list of texts, such as [\"front/20,35,0/8\"]">;
using MaybeAngle = Argument<std::optional<std::string>, "angle", "\"first\" or \"third\"">;
using MaybePage = Argument<std::optional<std::string>, "page", "text such as \"a4\"">;
using MaybeScale = Argument<std::optional<std::string>, "scale", "text such as \"1:2\"">;
using Fields = Argument<std::map<std::string, std::string>, "fields",
                        "a dictionary of texts, such as {\"title\": \"Bracket\"}">;

/// The rest of a model that the plane of a section cuts. What the cut has to say is added to
/// `notes`, once.
ModelLines cut_lines(const ModelLines& whole, const SectionPlane& plane,
                     std::vector<std::string>& notes, const Progress& asked) {
    Section section = cut_mesh(whole.model->mesh, {{plane}});
    for (const std::string& note : section.notes)
        if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
    auto rest = std::make_shared<Model>(Model{.mesh = std::move(section.mesh)});
    return find_lines(std::move(rest), whole.options, asked);
}

/// What a view shows of what the drawer has.
SeenLines seen(Drawer& drawer, const std::shared_ptr<const ModelLines>& subject,
               const SheetView& view, const Style& of_sheet, const Progress& asked) {
    const Style style = style_of_view(of_sheet, view);
    const glm::ivec2 size = view.camera.size;
    FoundIntervals found =
        drawer.intervals(view.camera, path_options({}, style, {size.x, size.y}), true, asked);
    if (found.subject != subject)
        throw UsageError("the model has changed while its sheet was drawn");
    return {std::move(found.intervals), std::move(found.outlines),
            find_fills(subject->lines, view.camera, style.fill, drawer.device(), asked)};
}

/// Draws all views of the drawer's model on a sheet.
VectorSheet draw(Drawer& drawer, SheetOptions options, const Style& style,
                 std::vector<std::string>& notes, const Progress& asked) {
    const std::shared_ptr<const ModelLines> subject = drawer.subject();
    const auto [x, y, z] = subject->model->origin;
    options.origin = {x, y, z};
    const Framing framing = framing_of(subject->lines);
    if (!framing.note.empty()) notes.push_back(framing.note);
    const SheetLayout layout = lay_out_sheet(framing.points, options);
    std::optional<Drawer> rest; // of the last section; its details follow it
    std::string plane;          // of that section
    const auto find = [&](const SheetView& view) -> SeenLines {
        if (!view.cut) return seen(drawer, subject, view, style, asked);
        if (drawer.is_changed())
            throw UsageError(view.name +
                             ": the model was changed after it was made; a section is of "
                             "a mesh as it is");
        if (!rest || plane != view.cut->name)
            rest.emplace(cut_lines(*subject, *view.cut, notes, asked), drawer.device());
        plane = view.cut->name;
        const std::shared_ptr<const ModelLines> cut = rest->subject();
        SeenLines found = seen(*rest, cut, view, style, asked);
        found.lines = &cut->lines;
        found.mesh = &cut->model->mesh;
        return found;
    };
    return make_vector_sheet(subject->lines, layout, find, style, {.mesh = &subject->model->mesh});
}

py::object written(const VectorSheet& sheet, const std::string& type, double dpi,
                   const SheetWriting& writing) {
    if (type == "svg") return py::str(to_svg(sheet, writing));
    if (type == "dxf") return py::str(to_dxf(sheet, writing));
    if (type == "pdf") return py::bytes(to_pdf(sheet, writing));
    Image image = to_image(sheet, dpi, writing);
    return array_of(std::move(image.pixels), {image.size.y, image.size.x, 4});
}

bool is_file(const std::string& views) {
    return views.ends_with(".toml");
}

void check_type(const std::string& type) {
    for (const char* known : {"svg", "dxf", "pdf", "picture"})
        if (type == known) return;
    throw UsageError(
        fmt::format("a sheet is \"svg\", \"dxf\", \"pdf\" or \"picture\", not \"{}\"", type));
}

py::object to_sheet(Drawer& drawer, const Word<"type">& type, const MaybeViews& views,
                    const Details& details, const MaybeAngle& angle, const MaybePage& page,
                    const MaybeScale& scale, Real<"unit"> unit, const UpArgument& up,
                    const Fields& fields, Flag<"measures"> measures, const MaybeStyle& style,
                    Flag<"tags"> tags, Flag<"transparent"> transparent, Flag<"curves"> curves,
                    Flag<"fit_arcs"> fit_arcs, Real<"dpi"> dpi, const py::object& progress) {
    check_type(type);
    SheetOptions options;
    if (*views && is_file(**views)) options = load_sheet(**views);
    if (*scale) options.scale = **scale;
    options.unit = static_cast<double>(*unit);
    options.up = axis_of(up);
    for (const auto& [name, value] : *fields) set_field(options.fields, name, value);
    options.measures = measures;
    if (*views && !is_file(**views)) options.views = parse_views(**views);
    for (const std::string& detail : *details) options.details.push_back(parse_detail(detail));
    if (*angle) options.angle = parse_projection_angle(**angle);
    if (*page) options.page = parse_page(**page);
    const Style own = *style ? style_of(style) : load_style("technical");
    std::vector<std::string> notes;
    const VectorSheet sheet = released(
        progress, [&](const Progress& asked) { return draw(drawer, options, own, notes, asked); });
    for (const std::string& note : notes) warn_user(note);
    return written(sheet, type, static_cast<double>(*dpi),
                   {.background = !transparent,
                    .tags = tags,
                    .curves = curves,
                    .fit_arcs = fit_arcs,
                    .description = {}});
}

} // namespace

void bind_sheets(py::class_<Drawer>& renderer) {
    renderer.def(
        "to_sheet", &to_sheet, py::kw_only(), py::arg("type") = "svg",
        py::arg("views") = py::none(), py::arg("details") = py::list(),
        py::arg("angle") = py::none(), py::arg("page") = py::none(), py::arg("scale") = py::none(),
        py::arg("unit") = 1.0F, py::arg("up") = "y", py::arg("fields") = py::dict(),
        py::arg("measures") = false, py::arg("style") = py::none(), py::arg("tags") = true,
        py::arg("transparent") = false, py::arg("curves") = true, py::arg("fit_arcs") = false,
        py::arg("dpi") = 150.0F, py::arg("progress") = py::none(),
        "Several views of the model on one page, aligned and to scale, with a frame and a title\n"
        "block. type: \"svg\" or \"dxf\" (text), \"pdf\" (bytes) or \"picture\" (a uint8 array as\n"
        "that of draw(), `dpi` pixels per inch). views: sides to look from, as in\n"
        "\"front,30,20,top\", and sections, as in \"front,section:x=12\", or a TOML file; none: "
        "front,\n"
        "top, right and isometric. details: parts of views once more, larger: a view, a point\n"
        "and a radius, and perhaps a scale, as in \"front/20,35,0/8/5:1\". angle: the angle of\n"
        "projection, \"first\" or \"third\"; none: \"third\". page: none: \"a3\". scale: as in\n"
        "\"1:2\"; none: the largest of ISO 5455 that fits. unit: millimetres in a unit of the "
        "model. fields: "
        "of\n"
        "the title block: title, file, owner, number, creator, approver, date. measures: overall\n"
        "sizes, axes and a scale bar. style: none: \"technical\". The others as those of "
        "to_svg().");
}

} // namespace lineatlas::python
