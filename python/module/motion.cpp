#include <algorithm>

#include <pybind11/stl.h>

#include "arguments.hpp"
#include "arrays.hpp"
#include "drawer.hpp"
#include "lineatlas/error.hpp"
#include "process.hpp"
#include "progress.hpp"

// Functions that move, deform and hide parts of a renderer's model.
namespace lineatlas::python {
namespace {

void set_transforms(Drawer& drawer, const py::object& world_from_object) {
    std::vector<glm::mat4> matrices = matrices_from(world_from_object, "world_from_object");
    const Released released;
    drawer.set_transforms(std::move(matrices));
}

void set_positions(Drawer& drawer, const py::object& positions) {
    const std::vector<glm::vec3> points = points_from(positions, "positions");
    const std::size_t count = drawer.subject()->model->mesh.positions.size();
    if (points.size() != count) {
        throw UsageError("positions has " + std::to_string(points.size()) +
                         " rows, but the mesh has " + std::to_string(count) + " positions");
    }
    const Released released;
    drawer.set_positions(points);
}

void hide(Drawer& drawer, const py::object& objects) {
    const std::size_t count = std::max<std::size_t>(drawer.subject()->lines.objects.size(), 1);
    std::vector<std::uint32_t> hidden = indices_from(objects, "objects", count);
    const Released released;
    drawer.set_hidden(std::move(hidden));
}

std::vector<std::uint32_t> add(Drawer& drawer, const ModelArgument& model,
                               const py::object& progress) {
    const std::shared_ptr<const Model> part = model_of(model);
    return released(progress, [&](const Progress& asked) { return drawer.add(*part, asked); });
}

using ObjectNumber = Argument<std::uint32_t, "object", "the number of an object">;

void remove(Drawer& drawer, const ObjectNumber& object) {
    const Released released;
    drawer.remove(*object);
}

py::list objects(Drawer& drawer) {
    py::list names;
    for (const LineObject& object : drawer.subject()->lines.objects)
        names.append(readable(object.name));
    return names;
}

} // namespace

void bind_motion(py::class_<Drawer>& renderer) {
    renderer
        .def("set_transforms", &set_transforms, py::arg("world_from_object"),
             "Moves the objects, or without separate_objects the whole model. Takes an (n, 4, 4)\n"
             "array of affine matrices, one per object, that apply to the places where objects\n"
             "were made. The next drawing shows the change. Creases stay as they were found.")
        .def("set_positions", &set_positions, py::arg("positions"),
             "Replaces the positions of the mesh: as many as it has, relative to Mesh.origin. The\n"
             "mesh keeps its triangles, and its lines stay on the same edges. The next drawing\n"
             "shows the change.")
        .def("hide", &hide, py::arg("objects"),
             "Hides these objects, by their numbers in `objects`, and shows all others; [] shows\n"
             "all. Hidden objects have no lines and hide nothing.")
        .def("add", &add, py::arg("model"), py::kw_only(), py::arg("progress") = py::none(),
             "Adds a model with the same options and returns the numbers of its objects. The time\n"
             "depends on the added model alone. Its positions, triangles and groups are numbered\n"
             "after those of earlier models. It stands at its right place, even if its origin\n"
             "differs.")
        .def(
            "remove", &remove, py::arg("object"),
            "Removes an object. Other objects keep their numbers; add() may reuse the removed one.")
        .def_property_readonly("objects", &objects,
                               "Names of the objects; empty without separate_objects.");
}

} // namespace lineatlas::python
