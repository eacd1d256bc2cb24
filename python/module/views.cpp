#include "views.hpp"

#include <numbers>
#include <utility>

#include <fmt/core.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "core/check_camera.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/framing.hpp"
#include "model.hpp"
#include "process.hpp"

namespace lineatlas::python {
namespace {

constexpr float radians_per_degree = std::numbers::pi_v<float> / 180;

template <Text name>
using Point = Argument<Triple, name, "three numbers">;

View make_view(const Point<"eye">& eye, const Point<"target">& target, const Point<"up">& up,
               Real<"fov"> fov, Real<"near"> near, Real<"far"> far, const std::string& projection) {
    return {.eye = vector_of(eye),
            .target = vector_of(target),
            .up = vector_of(up),
            .fov_y = fov * radians_per_degree,
            .near = near,
            .far = far,
            .projection = parse_projection(projection)};
}

std::string describe(const View& view) {
    const auto written = [](glm::vec3 v) {
        return fmt::format("({:.7g}, {:.7g}, {:.7g})", v.x, v.y, v.z);
    };
    return fmt::format("View(eye={}, target={}, up={}, fov={:.6g}, near={:.7g}, far={:.7g}, "
                       "projection='{}')",
                       written(view.eye), written(view.target), written(view.up),
                       view.fov_y / radians_per_degree, view.near, view.far,
                       name_of(view.projection));
}

/// A matrix from rows; GLM stores columns.
glm::mat4 matrix_from(const py::object& object, const char* name) {
    const auto rows =
        py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(object);
    if (!rows) {
        PyErr_Clear();
        throw wrong_argument(name, "a (4, 4) array of numbers", object);
    }
    if (rows.ndim() != 2 || rows.shape(0) != 4 || rows.shape(1) != 4)
        throw UsageError(std::string{name} + " must have the shape (4, 4)");
    glm::mat4 matrix{1};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = static_cast<float>(rows.at(row, column));
    }
    return matrix;
}

py::array matrix_of(const glm::mat4& matrix) {
    std::vector<float> rows;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) rows.push_back(matrix[column][row]);
    return array_of(std::move(rows), {4, 4});
}

Camera make_python_camera(const py::object& view, const py::object& projection,
                          Flag<"zero_to_one"> zero_to_one) {
    Camera camera;
    camera.view = matrix_from(view, "view");
    camera.projection = matrix_from(projection, "projection");
    camera.clip.zero_to_one = zero_to_one;
    check_camera(camera);
    return camera;
}

View frame_model(const ModelArgument& model, const SizeArgument& size, const UpArgument& up,
                 Real<"fov"> fov, const std::string& projection,
                 const std::optional<std::string>& view) {
    Framing framing;
    View framed;
    {
        const auto mesh = model_of(model);
        const Released released;
        framing = framing_of(extract_lines(mesh->mesh));
        framed = frame(framing.points, size, up, fov, parse_projection(projection), view);
    }
    warn_user(framing.note);
    return framed;
}

/// Bounds for the near and far plane of a camera without a model.
Bounds around(glm::vec3 point) {
    return {.min = point - 1.0F, .max = point + 1.0F};
}

template <glm::vec3 View::*member>
std::tuple<float, float, float> triple(const View& view) {
    return tuple_of(view.*member);
}

void bind_view_class(py::module_& module) {
    const View defaults;
    py::class_<View>(module, "View",
                     "A camera: where the eye is, what it looks at.\n\n"
                     "fov: vertical field of view in degrees. near, far: distances of the planes\n"
                     "of the depth buffer; 0: fitted to the model. projection: \"perspective\" or\n"
                     "\"orthographic\", which shows as much as the other does at the target.")
        .def(py::init(&make_view), py::arg("eye"), py::arg("target"),
             py::arg("up") = tuple_of(defaults.up), py::arg("fov") = 40.0F, py::arg("near") = 0.0F,
             py::arg("far") = 0.0F, py::arg("projection") = "perspective")
        .def_property_readonly("eye", &triple<&View::eye>, "Where the eye is.")
        .def_property_readonly("target", &triple<&View::target>, "What it looks at.")
        .def_property_readonly("up", &triple<&View::up>, "What is upwards.")
        .def_property_readonly(
            "fov", [](const View& view) { return view.fov_y / radians_per_degree; },
            "Vertical field of view in degrees.")
        .def_readonly("near", &View::near, "Distance of the near plane; 0: fitted.")
        .def_readonly("far", &View::far, "Distance of the far plane; 0: fitted.")
        .def_property_readonly(
            "projection", [](const View& view) { return name_of(view.projection); },
            "\"perspective\" or \"orthographic\".")
        .def_property_readonly("shown_height", &shown_height,
                               "Model units from the picture's lower border to its upper one; in\n"
                               "perspective at the target.")
        .def("__repr__", &describe);
}

} // namespace

glm::vec3 up_of(const UpAxis& up) {
    if (const auto* vector = std::get_if<Triple>(&up)) return vector_of(*vector);
    const std::string& name = std::get<std::string>(up);
    if (name == "x") return {1, 0, 0};
    if (name == "y") return {0, 1, 0};
    if (name == "z") return {0, 0, 1};
    throw UsageError("up \"" + name + "\" is not x, y, z or three numbers");
}

glm::vec3 axis_of(const UpAxis& up) {
    const glm::vec3 axis = up_of(up);
    if (axis != glm::abs(axis) || axis.x + axis.y + axis.z != 1 || glm::dot(axis, axis) != 1)
        throw UsageError("up must be an axis to frame a model: x, y or z; else give a view");
    return axis;
}

View frame(std::span<const glm::vec3> points, Size size, const UpAxis& up, float fov,
           Projection projection, const std::optional<std::string>& direction) {
    if (points.empty()) throw UsageError("there is nothing to frame: give a view");
    if (size[0] < 1 || size[1] < 1) throw UsageError("size: both sides must be at least 1");
    const glm::vec3 axis = axis_of(up);
    if (!(fov > 0 && fov < 180)) throw UsageError("fov must be above 0 and below 180 degrees");
    const glm::ivec2 pixels{size[0], size[1]};
    const float fov_y = fov * radians_per_degree;
    if (!direction) return frame_points(points, pixels, axis, fov_y, projection);
    return frame_points_from(view_direction(*direction, axis), points, pixels, fov_y, projection);
}

Shot camera_of(const std::optional<ViewOrCamera>& given, Size size, const UpAxis& up,
               const LineSet& lines) {
    const glm::ivec2 pixels{size[0], size[1]};
    if (given && std::holds_alternative<Camera>(*given)) {
        Camera camera = std::get<Camera>(*given);
        if (size[0] < 1 || size[1] < 1) throw UsageError("size: both sides must be at least 1");
        camera.size = pixels;
        return {camera};
    }
    Framing framing;
    if (!given) framing = framing_of(lines);
    const View view = given ? std::get<View>(*given) : frame(framing.points, size, up, 40);
    return {make_camera(view, pixels, lines.vertices.empty() ? around(view.target) : lines.bounds),
            std::move(framing.note)};
}

void warn_user(const std::string& text) {
    if (text.empty()) return;
    const py::object name = py::reinterpret_borrow<py::object>(PyEval_GetGlobals())["__name__"];
    const py::ssize_t level =
        name.equal(py::str("lineatlas")) ? 2 : 1; // called from one of the package's functions
    if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), level) != 0) throw py::error_already_set();
}

void bind_view(py::module_& module) {
    bind_view_class(module);
    py::class_<Camera>(module, "Camera",
                       "A camera as the two matrices of a program of its own, (4, 4) each, for\n"
                       "column vectors as in OpenGL. zero_to_one: depth of clip space goes from 0\n"
                       "to w as in Direct3D and Vulkan. Depth may be reversed. Raises UsageError\n"
                       "for a matrix that is not finite or has no inverse.")
        .def(py::init(&make_python_camera), py::arg("view"), py::arg("projection"), py::kw_only(),
             py::arg("zero_to_one") = false)
        .def_property_readonly(
            "view", [](const Camera& camera) { return matrix_of(camera.view); },
            "World to eye space, (4, 4) float32.")
        .def_property_readonly(
            "projection", [](const Camera& camera) { return matrix_of(camera.projection); },
            "Eye to clip space, (4, 4) float32.");
    module.def(
        "frame", &frame_model, py::arg("model"), py::kw_only(), py::arg("size") = Size{1024, 768},
        py::arg("up") = "y", py::arg("fov") = 40.0F, py::arg("projection") = "perspective",
        py::arg("view") = py::none(),
        "A view in which a mesh, or that of a file, just fits: from the front, right and\n"
        "above, or from \"front\", \"back\", \"left\", \"right\", \"top\", \"bottom\",\n"
        "\"isometric\", \"dimetric\" or \"AZIMUTH,ELEVATION\" in degrees. up: \"x\", \"y\" or\n"
        "\"z\". Raises UsageError for an empty mesh.");
}

} // namespace lineatlas::python
