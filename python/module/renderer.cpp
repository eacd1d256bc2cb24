#include <fmt/core.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "base/exact_bounds.hpp"
#include "bindings.hpp"
#include "core/empty_drawing.hpp"
#include "core/progress.hpp"
#include "drawer.hpp"
#include "intervals.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/fills.hpp"
#include "lineatlas/framing.hpp"
#include "lineatlas/vector.hpp"
#include "options.hpp"
#include "pdf/pdf.hpp"
#include "process.hpp"
#include "progress.hpp"
#include "style_values.hpp"
#include "views.hpp"

namespace lineatlas::python {
namespace {

using MaybeStyle = Argument<std::optional<StyleOrName>, "style",
                            "a Style, the name of one or the path of a style file">;
using MaybeOptions = Argument<std::optional<Options>, "options", "an Options">;
using MaybePage = Argument<std::optional<std::string>, "page", "text such as \"a4\"">;

/// Warns of a drawing without lines. `why` is the reason; empty: the drawing has lines.
void warn_of_no_line(const std::string& why) {
    if (!why.empty()) warn_user("no line is drawn: " + why);
}

/// The reason why a camera shows none of these lines; empty if it shows some.
std::string why_blank(const ModelLines& subject, const Camera& camera) {
    const std::string why = why_no_line(subject.lines, subject.options.lines, camera);
    const auto [x, y, z] = subject.model->origin;
    const glm::dvec3 origin{x, y, z};
    if (origin == glm::dvec3{0}) return why;
    return why + "; views and cameras are about Mesh.origin, which is " + written(origin);
}

void warn(const std::string& note) {
    if (!note.empty() && PyErr_WarnEx(PyExc_RuntimeWarning, note.c_str(), 1) != 0) {
        throw py::error_already_set(); // if warnings are errors
    }
}

std::unique_ptr<Drawer> make_drawer(const ModelArgument& model, const KindsArgument& lines,
                                    const CreaseArgument& crease,
                                    const MaybeSilhouettes& silhouettes,
                                    Flag<"separate_objects"> apart, const py::object& progress,
                                    const Word<"compute">& compute, const Word<"device">& device,
                                    const Word<"interop">& interop, Flag<"one_picture"> once) {
    std::shared_ptr<const Model> mesh = model_of(model);
    const LineOptions found = line_options(lines, *crease, *silhouettes, apart);
    std::string note;
    auto drawer = released(progress, [&](const Progress& asked) {
        auto made = std::make_unique<Drawer>(
            find_lines(std::move(mesh), found, asked),
            DeviceOptions{
                .compute = compute, .device = device, .interop = interop, .one_picture = once});
        note = made->take_note();
        return made;
    });
    warn(note);
    return drawer;
}

void set_model(Drawer& drawer, const ModelArgument& model, const KindsArgument& lines,
               const CreaseArgument& crease, const MaybeSilhouettes& silhouettes,
               Flag<"separate_objects"> apart, const py::object& progress) {
    std::shared_ptr<const Model> mesh = model_of(model);
    const LineOptions found = line_options(lines, *crease, *silhouettes, apart);
    released(progress, [&](const Progress& asked) {
        drawer.set_subject(find_lines(std::move(mesh), found, asked));
    });
}

void prepare(Drawer& drawer, const MaybeStyle& style, const MaybeOptions& options,
             const py::object& progress) {
    const FrameOptions frame = frame_options(options, style_of(style));
    const std::string note = released(progress, [&](const Progress& asked) {
        drawer.prepare(frame, asked);
        return drawer.take_note();
    });
    warn(note);
}

py::array draw(Drawer& drawer, const SizeArgument& size, const MaybeView& view,
               const UpArgument& up, const MaybeStyle& style, const MaybeOptions& options,
               Flag<"transparent"> transparent) {
    const FrameOptions frame = frame_options(options, style_of(style));
    Picture picture;
    std::string flaw, note, of_framing;
    {
        const Released released;
        const auto subject = drawer.subject();
        const auto [camera, framed] = camera_of(view, size, up, subject->lines);
        of_framing = framed;
        picture = drawer.draw(camera, frame, transparent);
        note = drawer.take_note();
        const bool shows_lines =
            picture.shows_lines ? *picture.shows_lines : any_in_view(subject->lines, camera);
        if (!shows_lines) flaw = why_blank(*subject, camera);
    }
    warn(note);
    warn_user(of_framing);
    warn_of_no_line(flaw);
    return array_of(std::move(picture.pixels), {(*size)[1], (*size)[0], 4});
}

py::array intervals(Drawer& drawer, const SizeArgument& size, const MaybeView& view,
                    const UpArgument& up, const MaybeOptions& options, Flag<"hidden"> hidden,
                    const py::object& progress) {
    const FrameOptions frame = path_options(options, {}, size);
    std::string of_framing;
    std::vector<IntervalRow> rows = released(progress, [&](const Progress& asked) {
        const auto [camera, framed] = camera_of(view, size, up, drawer.subject()->lines);
        of_framing = framed;
        return interval_rows(drawer.intervals(camera, frame, hidden, asked), (*size)[1]);
    });
    warn_user(of_framing);
    const auto count = static_cast<py::ssize_t>(rows.size());
    return array_of(std::move(rows), {count});
}

/// The paper of a drawing's file.
struct Paper {
    std::optional<Page> page;
    Length margin;
};

Paper paper_of(const std::optional<std::string>& page, const std::string& margin) {
    if (!page) return {.page = {}, .margin = parse_length(margin, Unit::px)};
    return {.page = parse_page(*page), .margin = parse_length(margin, Unit::mm)};
}

/// The arguments of drawings as paths.
struct PathArguments {
    const SizeArgument& size;
    const MaybeView& view;
    const UpArgument& up;
    const MaybeStyle& style;
    const MaybeOptions& options;
    const Paper& paper;
    bool plotter;
    const py::object& progress;
};

/// A drawing as text by `written`, made without the interpreter's lock.
template <class Written>
std::string draw_paths(Drawer& drawer, const PathArguments& arguments, const Written& written) {
    FrameOptions frame = path_options(arguments.options, style_of(arguments.style), arguments.size);
    std::string flaw, of_framing;
    std::string text = released(arguments.progress, [&](const Progress& asked) {
        const auto [camera, framed] =
            camera_of(arguments.view, arguments.size, arguments.up, drawer.subject()->lines);
        of_framing = framed;
        if (const Paper& paper = arguments.paper; paper.page)
            frame.style = style_on_page(frame.style, camera.size, *paper.page, paper.margin);
        // Hidden intervals are needed too: a stroke may bridge a short one.
        const bool fills = !arguments.plotter && frame.style.fill.mode != FillMode::none;
        const float found_by = fills ? 0.5F : 1; // share of the time, roughly
        const FoundIntervals found =
            drawer.intervals(camera, frame, true, part_of(asked, 0, found_by));
        const LineSet& lines = found.subject->lines;
        VectorDrawing drawing = make_vector_drawing(lines, camera, found.intervals, frame.style,
                                                    {.mesh = &found.subject->model->mesh,
                                                     .outlines = found.outlines,
                                                     .plotter = arguments.plotter});
        if (fills)
            drawing.fills = find_fills(lines, camera, frame.style.fill, drawer.device(),
                                       part_of(asked, found_by, 1));
        if (drawing.paths.empty()) flaw = why_blank(*found.subject, camera);
        return written(drawing);
    });
    warn_user(of_framing);
    warn_of_no_line(flaw);
    return text;
}

std::string svg(Drawer& drawer, const SizeArgument& size, const MaybeView& view,
                const UpArgument& up, const MaybeStyle& style, const MaybeOptions& options,
                const MaybePage& page, const Word<"margin">& margin, Flag<"plotter"> plotter,
                Flag<"tags"> tags, Flag<"transparent"> transparent, Flag<"curves"> curves,
                Flag<"fit_arcs"> fit_arcs, const Word<"title">& title, const py::object& progress) {
    const Paper paper = paper_of(page, margin);
    const SvgOptions sheet{.units = paper.page ? Unit::mm : Unit::px,
                           .page = paper.page,
                           .margin = paper.margin,
                           .background = !transparent,
                           .tags = tags,
                           .curves = curves,
                           .fit_arcs = fit_arcs,
                           .title = title};
    return draw_paths(drawer, {size, view, up, style, options, paper, plotter, progress},
                      [&](const VectorDrawing& drawing) { return to_svg(drawing, sheet); });
}

std::string dxf(Drawer& drawer, const SizeArgument& size, const MaybeView& view,
                const UpArgument& up, const MaybeStyle& style, const MaybeOptions& options,
                const MaybePage& page, const Word<"margin">& margin, Flag<"plotter"> plotter,
                Flag<"curves"> curves, Flag<"fit_arcs"> fit_arcs, const py::object& progress) {
    const Paper paper = paper_of(page, margin);
    const DxfOptions sheet{.page = paper.page,
                           .margin = paper.margin,
                           .curves = curves,
                           .fit_arcs = fit_arcs,
                           .description = {}};
    return draw_paths(drawer, {size, view, up, style, options, paper, plotter, progress},
                      [&](const VectorDrawing& drawing) { return to_dxf(drawing, sheet); });
}

py::bytes pdf(Drawer& drawer, const SizeArgument& size, const MaybeView& view, const UpArgument& up,
              const MaybeStyle& style, const MaybeOptions& options, const MaybePage& page,
              const Word<"margin">& margin, Flag<"plotter"> plotter,
              Flag<"transparent"> transparent, Flag<"curves"> curves, Flag<"fit_arcs"> fit_arcs,
              const Word<"title">& title, const py::object& progress) {
    const Paper paper = paper_of(page, margin);
    const PdfOptions sheet{.page = paper.page,
                           .margin = paper.margin,
                           .background = !transparent,
                           .curves = curves,
                           .fit_arcs = fit_arcs,
                           .title = title};
    return draw_paths(drawer, {size, view, up, style, options, paper, plotter, progress},
                      [&](const VectorDrawing& drawing) { return to_pdf(drawing, sheet); });
}

std::string json(Drawer& drawer, const SizeArgument& size, const MaybeView& view,
                 const UpArgument& up, const MaybeStyle& style, const MaybeOptions& options,
                 Flag<"plotter"> plotter, Flag<"tags"> tags, const py::object& progress) {
    return draw_paths(drawer, {size, view, up, style, options, {}, plotter, progress},
                      [&](const VectorDrawing& drawing) {
                          return to_json(drawing, {.tags = tags, .description = {}});
                      });
}

View framed(const Drawer& drawer, const SizeArgument& size, const UpArgument& up, Real<"fov"> fov,
            const std::string& projection, const std::optional<std::string>& view) {
    Framing framing;
    View framed;
    {
        const Released released;
        framing = framing_of(drawer.subject()->lines);
        framed = frame(framing.points, size, up, fov, parse_projection(projection), view);
    }
    warn_user(framing.note);
    return framed;
}

std::string description(Drawer& drawer) {
    const Released released;
    return drawer.description();
}

void close(Drawer& drawer) {
    const Released released;
    drawer.close();
}

void bind_drawing(py::class_<Drawer>& renderer) {
    const py::arg_v size = py::arg("size") = usual_size;
    const py::arg_v view = py::arg("view") = py::none();
    const py::arg_v up = py::arg("up") = "y";
    const py::arg_v style = py::arg("style") = py::none();
    const py::arg_v options = py::arg("options") = py::none();
    const py::arg_v progress = py::arg("progress") = py::none();
    renderer
        .def("prepare", &prepare, py::kw_only(), style, options, progress,
             "Builds ahead all kernels that pictures of this style with these options need, so\n"
             "that draw() builds none. What is built stays for all renderers of the process.")
        .def("draw", &draw, py::kw_only(), size, view, up, style, options,
             py::arg("transparent") = false,
             "The drawing as a (height, width, 4) uint8 array: red, green, blue, alpha, rows from\n"
             "the top. Colour is sRGB-coded and not multiplied by alpha. Without a view the model\n"
             "is framed, with `up` upwards.")
        .def("intervals", &intervals, py::kw_only(), size, view, up, options,
             py::arg("hidden") = false, progress,
             "The visible pieces of all lines, with `hidden` the hidden ones too, as an array of\n"
             "the fields p, q (ends in pixels from the upper left corner), p_depth, q_depth (0\n"
             "near to 1 far), p_world, q_world (points of the model), alpha (mean visibility),\n"
             "kind (a LineKind), visible, segment, path (of the lines found), edge (two positions\n"
             "of the mesh), triangle (that has it), crossing (the other triangle of an "
             "intersection),\n"
             "group; -1 where there is none.")
        .def("to_svg", &svg, py::kw_only(), size, view, up, style, options,
             py::arg("page") = py::none(), py::arg("margin") = "0", py::arg("plotter") = false,
             py::arg("tags") = true, py::arg("transparent") = false, py::arg("curves") = true,
             py::arg("fit_arcs") = false, py::arg("title") = "Line drawing", progress,
             "The drawing as SVG. page: \"a4\", \"300x200mm\", ...; none: the picture. margin:\n"
             "\"10mm\", .... plotter: ordered for the least travel of a pen. tags: each path says\n"
             "where it comes from. transparent: without the paper. curves: edges along\n"
             "circles and ellipses of the file, and circles that a mesh was cut from, become\n"
             "arcs. fit_arcs: so do parts of other lines that are round within 0.02 pixels.")
        .def("to_dxf", &dxf, py::kw_only(), size, view, up, style, options,
             py::arg("page") = py::none(), py::arg("margin") = "0", py::arg("plotter") = false,
             py::arg("curves") = true, py::arg("fit_arcs") = false, progress,
             "The drawing as DXF in millimetres of the page; arguments as those of to_svg().")
        .def("to_pdf", &pdf, py::kw_only(), size, view, up, style, options,
             py::arg("page") = py::none(), py::arg("margin") = "0", py::arg("plotter") = false,
             py::arg("transparent") = false, py::arg("curves") = true, py::arg("fit_arcs") = false,
             py::arg("title") = "Line drawing", progress,
             "The drawing as a PDF of one page; arguments as those of to_svg().")
        .def("to_json", &json, py::kw_only(), size, view, up, style, options,
             py::arg("plotter") = false, py::arg("tags") = true, progress,
             "The drawing as JSON (docs/vector.md).")
        .def("frame", &framed, py::kw_only(), size, up, py::arg("fov") = 40.0F,
             py::arg("projection") = "perspective", py::arg("view") = py::none(),
             "A view in which the model just fits; as lineatlas.frame().");
}

} // namespace

void bind_renderer(py::module_& module) {
    register_interval_row();
    bind_options(module);
    const py::arg_v lines = py::arg("lines") = py::none();
    const py::arg_v crease = py::arg("crease") = "auto";
    const py::arg_v silhouettes = py::arg("silhouettes") = py::none();
    const py::arg_v apart = py::arg("separate_objects") = false;
    const py::arg_v progress = py::arg("progress") = py::none();
    py::class_<Drawer> renderer(
        module, "Renderer",
        "Draws a model, or the mesh of a file, as often as wanted.\n\n"
        "Keep it for several pictures, because slow work is done once. The first picture makes\n"
        "an OpenGL context without a window; the thread's own context stays current. Intervals\n"
        "and paths need no context. Any thread may call it; calls wait for each other, and\n"
        "several renderers work at the same time.\n\n"
        "lines: kinds of lines to find (LineKind), as \"crease,silhouette\" or a list; none: all.\n"
        "crease: edges bent by more degrees are creases; \"auto\": by more than 28.8, except\n"
        "noise of scanned or sculpted surfaces and seams. silhouettes: \"mesh\" along edges,\n"
        "\"smooth\" by normals of the surface, \"auto\" (default) smooth on scans and on surfaces\n"
        "of STEP, IGES and BREP files. separate_objects: the objects of Mesh.triangle_object, or\n"
        "groups of one name, can move and hide (set_transforms(), hide()). progress: called with\n"
        "the share that is done, 0 to 1, here and in other methods; Cancelled is raised once it\n"
        "returns False. compute, device, interop: as in `lineatlas draw --help`. one_picture: no\n"
        "driver of OpenCL is started beside a software GL, which takes longer than a picture.");
    renderer
        .def(py::init(&make_drawer), py::arg("model"), py::kw_only(), lines, crease, silhouettes,
             apart, progress, py::arg("compute") = "", py::arg("device") = "",
             py::arg("interop") = "", py::arg("one_picture") = false)
        .def("set_model", &set_model, py::arg("model"), py::kw_only(), lines, crease, silhouettes,
             apart, progress, "Another model, or other lines of the same, from now on.");
    bind_drawing(renderer);
    bind_sheets(renderer);
    bind_motion(renderer);
    bind_picking(module, renderer);
    renderer
        .def_property_readonly("description", &description,
                               "The backend and device in use, for people.")
        .def("close", &close, "Frees everything. The end of a `with` block does the same.")
        .def(
            "__enter__", [](const py::object& self) { return self; }, "For `with`.")
        .def(
            "__exit__", [](Drawer& drawer, const py::args&) { close(drawer); }, "Closes it.");
}

} // namespace lineatlas::python
