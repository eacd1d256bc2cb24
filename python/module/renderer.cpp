#include <fmt/core.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "drawer.hpp"
#include "intervals.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/vector.hpp"
#include "options.hpp"
#include "style_values.hpp"
#include "views.hpp"

namespace lineatlas::python {
namespace {

using Release = py::gil_scoped_release;
using MaybeView = std::optional<ViewOrCamera>;
using MaybeStyle = std::optional<StyleOrName>;
using MaybeOptions = std::optional<Options>;

std::unique_ptr<Drawer> make_drawer(const ModelOrPath& model, const LineKinds& lines, float crease,
                                    const std::string& compute, const std::string& device,
                                    const std::string& interop) {
    std::shared_ptr<const Model> mesh = model_of(model);
    const LineOptions found = line_options(lines, crease);
    const Release release;
    return std::make_unique<Drawer>(
        find_lines(std::move(mesh), found),
        DeviceOptions{.compute = compute, .device = device, .interop = interop});
}

void set_model(Drawer& drawer, const ModelOrPath& model, const LineKinds& lines, float crease) {
    std::shared_ptr<const Model> mesh = model_of(model);
    const LineOptions found = line_options(lines, crease);
    const Release release;
    drawer.set_subject(find_lines(std::move(mesh), found));
}

Camera camera_on(const Drawer& drawer, Size size, const MaybeView& view, const UpAxis& up) {
    const std::shared_ptr<const ModelLines> subject = drawer.subject();
    return camera_of(view, size, up, subject->lines.vertices, subject->lines.bounds);
}

py::array draw(Drawer& drawer, Size size, const MaybeView& view, const UpAxis& up,
               const MaybeStyle& style, const MaybeOptions& options, bool transparent) {
    const FrameOptions frame = frame_options(options, style_of(style));
    std::vector<std::uint8_t> pixels;
    {
        const Release release;
        pixels = drawer.draw(camera_on(drawer, size, view, up), frame, transparent);
    }
    return array_of(std::move(pixels), {size[1], size[0], 4});
}

py::array intervals(Drawer& drawer, Size size, const MaybeView& view, const UpAxis& up,
                    const MaybeOptions& options, bool hidden) {
    const FrameOptions frame = path_options(options, {}, size);
    std::vector<IntervalRow> rows;
    {
        const Release release;
        rows = interval_rows(drawer.intervals(camera_on(drawer, size, view, up), frame, hidden),
                             size[1]);
    }
    const auto count = static_cast<py::ssize_t>(rows.size());
    return array_of(std::move(rows), {count});
}

/// The drawing as paths.
struct PathArguments {
    Size size;
    const MaybeView& view;
    const UpAxis& up;
    const MaybeStyle& style;
    const MaybeOptions& options;
    bool plotter, tags;
};

VectorDrawing find_paths(Drawer& drawer, const PathArguments& arguments) {
    const FrameOptions frame =
        path_options(arguments.options, style_of(arguments.style), arguments.size);
    const Camera camera = camera_on(drawer, arguments.size, arguments.view, arguments.up);
    // Hidden ones too: what hides a line may bridge a gap in it.
    const FoundIntervals found = drawer.intervals(camera, frame, true);
    const Mesh* mesh = arguments.tags ? &found.subject->model->mesh : nullptr;
    return make_vector_drawing(found.subject->lines, camera, found.intervals, frame.style,
                               {.mesh = mesh, .plotter = arguments.plotter});
}

SvgOptions svg_options(const std::optional<std::string>& page, const std::string& margin,
                       const std::string& title, bool tags, bool transparent) {
    SvgOptions options{.background = !transparent, .tags = tags, .title = title};
    if (page) {
        options.units = Unit::mm;
        options.page = parse_page(*page);
    }
    options.margin = parse_length(margin, options.units);
    return options;
}

std::string svg(Drawer& drawer, Size size, const MaybeView& view, const UpAxis& up,
                const MaybeStyle& style, const MaybeOptions& options,
                const std::optional<std::string>& page, const std::string& margin, bool plotter,
                bool tags, bool transparent, const std::string& title) {
    const SvgOptions sheet = svg_options(page, margin, title, tags, transparent);
    const Release release;
    return to_svg(find_paths(drawer, {size, view, up, style, options, plotter, tags}), sheet);
}

std::string json(Drawer& drawer, Size size, const MaybeView& view, const UpAxis& up,
                 const MaybeStyle& style, const MaybeOptions& options, bool plotter, bool tags) {
    const Release release;
    return to_json(find_paths(drawer, {size, view, up, style, options, plotter, tags}),
                   {.tags = tags, .description = {}});
}

View framed(const Drawer& drawer, Size size, const UpAxis& up, float fov) {
    const Release release;
    return frame(drawer.subject()->lines.vertices, size, up, fov);
}

std::string description(Drawer& drawer) {
    const Release release;
    return drawer.description();
}

void close(Drawer& drawer) {
    const Release release;
    drawer.close();
}

constexpr Size usual_size{1024, 768};

void bind_drawing(py::class_<Drawer>& renderer) {
    const py::arg_v size = py::arg("size") = usual_size;
    const py::arg_v view = py::arg("view") = py::none();
    const py::arg_v up = py::arg("up") = "y";
    const py::arg_v style = py::arg("style") = py::none();
    const py::arg_v options = py::arg("options") = py::none();
    renderer
        .def("draw", &draw, py::kw_only(), size, view, up, style, options,
             py::arg("transparent") = false,
             "The drawing as a (height, width, 4) uint8 array: red, green, blue, alpha, rows from\n"
             "the top. Colour is sRGB-coded and not multiplied by alpha. Without a view the model\n"
             "is framed, with `up` upwards.")
        .def("intervals", &intervals, py::kw_only(), size, view, up, options,
             py::arg("hidden") = false,
             "The visible pieces of all lines, with `hidden` the hidden ones too, as an array of\n"
             "the fields p, q (ends in pixels from the upper left corner), p_depth, q_depth (0\n"
             "near to 1 far), p_world, q_world (points of the model), alpha (mean visibility),\n"
             "kind (a LineKind), visible, segment, path (of the lines found), edge (two positions\n"
             "of the mesh), triangle (that has it), group; -1 where there is none.")
        .def("to_svg", &svg, py::kw_only(), size, view, up, style, options,
             py::arg("page") = py::none(), py::arg("margin") = "0", py::arg("plotter") = false,
             py::arg("tags") = true, py::arg("transparent") = false,
             py::arg("title") = "Line drawing",
             "The drawing as SVG. page: \"a4\", \"300x200mm\", ...; none: the picture. margin:\n"
             "\"10mm\", .... plotter: ordered for the least travel of a pen. tags: each path says\n"
             "where it comes from. transparent: without the paper.")
        .def("to_json", &json, py::kw_only(), size, view, up, style, options,
             py::arg("plotter") = false, py::arg("tags") = true,
             "The drawing as JSON (docs/vector.md).")
        .def("frame", &framed, py::kw_only(), size, up, py::arg("fov") = 40.0F,
             "A view from the front, right and above in which the model just fits.");
}

} // namespace

void bind_renderer(py::module_& module) {
    register_interval_row();
    bind_options(module);
    const py::arg_v lines = py::arg("lines") = py::none();
    const py::arg_v crease = py::arg("crease") = 30.0F;
    py::class_<Drawer> renderer(
        module, "Renderer",
        "Draws a model, or the mesh of a file, as often as wanted.\n\n"
        "Keep it for several pictures: what is slow is done once. It has an OpenGL context of its\n"
        "own, without a window, and leaves what is current on the thread as it is. Any thread\n"
        "may call it; calls wait for each other, and several renderers work at the same time.\n\n"
        "lines: kinds of lines to find (LineKind), as \"crease,silhouette\" or a list; none: all.\n"
        "crease: edges bent by more degrees are creases. compute, device, interop: as in\n"
        "`lineatlas draw --help`.");
    renderer
        .def(py::init(&make_drawer), py::arg("model"), py::kw_only(), lines, crease,
             py::arg("compute") = "opencl", py::arg("device") = "", py::arg("interop") = "")
        .def("set_model", &set_model, py::arg("model"), py::kw_only(), lines, crease,
             "Another model, or other lines of the same, from now on.");
    bind_drawing(renderer);
    renderer
        .def_property_readonly("description", &description,
                               "The backend and device in use, for people.")
        .def("close", &close, "Gives back all that it holds. As does the end of a `with` block.")
        .def(
            "__enter__", [](const py::object& self) { return self; }, "For `with`.")
        .def(
            "__exit__", [](Drawer& drawer, const py::args&) { close(drawer); }, "Closes it.");
}

} // namespace lineatlas::python
