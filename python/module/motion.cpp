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
             "Moves the objects (separate_objects; else the whole model): an (n, 4, 4) array of\n"
             "affine matrices, one each, from where they were made. Which edges are creases stays\n"
             "as it is. What is drawn next shows it; nothing is found anew.")
        .def(
            "set_positions", &set_positions, py::arg("positions"),
            "Gives the mesh other positions, as many as it has and about Mesh.origin as they are:\n"
            "it bends and stretches, but keeps its triangles and which of its edges are lines.\n"
            "What is drawn next shows it.")
        .def("hide", &hide, py::arg("objects"),
             "Shows all objects but these, by their numbers in `objects`; [] shows all. The\n"
             "others' lines are not drawn and hide nothing.")
        .def(
            "add", &add, py::arg("model"), py::kw_only(), py::arg("progress") = py::none(),
            "Adds another model, found with the same options, and gives the numbers of its\n"
            "objects. It costs what it has, not what was there before. Positions, triangles and\n"
            "groups of its mesh are counted on from those before. Where its origin is another, it\n"
            "stands beside them as the places say that were given.")
        .def("remove", &remove, py::arg("object"),
             "Takes an object out; the others keep their numbers, and add() gives its own again.")
        .def_property_readonly("objects", &objects,
                               "Names of what moves on its own; empty without separate_objects.");
}

} // namespace lineatlas::python
