#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arguments.hpp"
#include "arrays.hpp"
#include "base/exact_bounds.hpp"
#include "bindings.hpp"
#include "io/model_types.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/scenes.hpp"
#include "lineatlas/volume.hpp"
#include "model.hpp"
#include "process.hpp"
#include "progress.hpp"
#include "views.hpp"

namespace lineatlas::python {
namespace {

using GroupOrName = std::variant<MeshGroup, std::string>;
using Groups = std::optional<std::vector<GroupOrName>>;

using ColorArgument = Argument<std::optional<Triple>, "color", "three numbers">;
using GroupsArgument = Argument<Groups, "groups", "a list of Group and names of materials">;
using EdgesByKind = std::optional<std::map<std::string, py::object>>;
using EdgesArgument =
    Argument<EdgesByKind, "known_edges", "a dictionary of kinds of edges and arrays of pairs">;
using LinesArgument = Argument<py::iterable, "polylines", "a list of lines">;

MeshGroup make_group(std::string object, std::string material, const std::optional<Triple>& color) {
    MeshGroup group{.object = std::move(object), .material = std::move(material)};
    if (color) group.color = vector_of(*color);
    return group;
}

/// Adds groups for materials without names. Each gets its number as name.
void add_numbered_groups(Mesh& mesh, const std::vector<std::uint32_t>& numbers) {
    const float* corner = mesh.positions.empty() ? nullptr : &mesh.positions[0].x;
    const std::uint32_t* index = mesh.triangles.empty() ? nullptr : &mesh.triangles[0].x;
    Mesh grouped = make_mesh({.positions = {corner, mesh.positions.size() * 3},
                              .indices = {index, mesh.triangles.size() * 3},
                              .materials = numbers});
    mesh.triangle_group = std::move(grouped.triangle_group);
    mesh.groups = std::move(grouped.groups);
}

void add_groups(Mesh& mesh, const py::object& triangle_group, const Groups& groups) {
    if (triangle_group.is_none()) {
        if (groups) throw UsageError("groups need triangle_group, which says what belongs to them");
        return;
    }
    constexpr std::size_t any = std::size_t{1} << 32;
    const std::size_t limit = groups ? groups->size() : any;
    std::vector<std::uint32_t> numbers = indices_from(triangle_group, "triangle_group", limit);
    if (numbers.size() != mesh.triangles.size()) {
        throw UsageError("triangle_group has " + std::to_string(numbers.size()) +
                         " entries, but there are " + std::to_string(mesh.triangles.size()) +
                         " triangles");
    }
    if (numbers.empty()) return;
    if (!groups) return add_numbered_groups(mesh, numbers);
    for (const GroupOrName& group : *groups) {
        const auto* name = std::get_if<std::string>(&group);
        mesh.groups.push_back(name != nullptr ? make_group({}, *name, {})
                                              : std::get<MeshGroup>(group));
    }
    mesh.triangle_group = std::move(numbers);
}

/// Adds a polyline, given by indices of positions or by points.
void add_polyline(Mesh& mesh, std::vector<glm::dvec3>& positions, py::handle line) {
    if (holds_integers(line)) {
        mesh.polylines.push_back(indices_from(line, "polylines", positions.size()));
        return;
    }
    const std::vector<glm::dvec3> points = exact_points_from(line, "polylines");
    std::vector<std::uint32_t>& own = mesh.polylines.emplace_back(points.size());
    std::iota(own.begin(), own.end(), static_cast<std::uint32_t>(positions.size()));
    positions.insert(positions.end(), points.begin(), points.end());
}

/// Sets the positions. If they lie far from zero, the model gets an origin, as models of files do.
void place(Model& model, std::span<const glm::dvec3> positions) {
    Mesh& mesh = model.mesh;
    ExactBounds bounds;
    for (const glm::uvec3& t : mesh.triangles)
        bounds.add_drawable(positions, std::array{t.x, t.y, t.z});
    for (const auto& line : mesh.polylines) bounds.add_drawable(positions, line);
    const glm::dvec3 origin = origin_for(bounds);
    mesh.positions.reserve(positions.size());
    for (const glm::dvec3& position : positions) mesh.positions.emplace_back(position - origin);
    if (origin == glm::dvec3{0}) return;
    model.origin = {origin.x, origin.y, origin.z};
    model.notes.push_back(note_of_origin(origin));
}

/// Warns that float positions this far from zero lack digits.
void warn_of_lost_digits(glm::dvec3 origin) {
    const glm::dvec3 distance = glm::abs(origin);
    const auto farthest = static_cast<float>(std::max({distance.x, distance.y, distance.z}));
    const float step = std::nextafter(farthest, 2 * farthest) - farthest;
    warn_user(fmt::format("positions are float32, which far from zero holds steps of {:.3g} only; "
                          "give float64",
                          step));
}

/// The names of KnownEdge::Kind, in the order of the enumeration.
constexpr std::array known_edge_kinds{"sharp", "smooth", "seam", "free", "wire", "marked"};

void add_known_edges(Mesh& mesh, const EdgesByKind& edges) {
    if (!edges) return;
    for (const auto& [name, pairs] : *edges) {
        const auto found = std::ranges::find(known_edge_kinds, name);
        if (found == known_edge_kinds.end()) {
            throw UsageError(fmt::format("known_edges: there is no kind \"{}\"; there is {}", name,
                                         fmt::join(known_edge_kinds, ", ")));
        }
        const auto kind = static_cast<KnownEdge::Kind>(found - known_edge_kinds.begin());
        for (const auto& [from, to] : pairs_from(pairs, "known_edges", mesh.positions.size())) {
            mesh.known_edges.push_back(
                {.from = from,
                 .to = to,
                 .kind = kind,
                 .edge = static_cast<std::uint32_t>(mesh.known_edges.size())});
        }
    }
}

/// The known edges of a model as Python's dictionary, with the kinds that occur.
py::dict known_edges(const Model& model) {
    std::map<KnownEdge::Kind, std::vector<std::uint32_t>> ends;
    for (const KnownEdge& edge : model.mesh.known_edges)
        ends[edge.kind].insert(ends[edge.kind].end(), {edge.from, edge.to});
    py::dict kinds;
    for (auto& [kind, numbers] : ends) {
        const auto count = static_cast<py::ssize_t>(numbers.size()) / 2;
        kinds[known_edge_kinds[static_cast<std::size_t>(kind)]] =
            array_of(std::move(numbers), {count, 2});
    }
    return kinds;
}

/// Numbers of objects, one per element; empty for None.
std::vector<std::uint32_t> objects_from(const py::object& numbers, const char* name,
                                        std::size_t count) {
    constexpr std::size_t any = std::size_t{1} << 32;
    if (numbers.is_none()) return {};
    std::vector<std::uint32_t> objects = indices_from(numbers, name, any);
    if (objects.size() == count) return objects;
    throw UsageError(std::string{name} + " has " + std::to_string(objects.size()) +
                     " entries, but there are " + std::to_string(count));
}

std::vector<glm::uvec3> triangles_in_order(std::size_t corners) {
    if (corners % 3 != 0) {
        throw UsageError(
            "positions: without triangles they are three corners each, but there are " +
            std::to_string(corners));
    }
    std::vector<glm::uvec3> triangles;
    for (std::size_t i = 0; i < corners; i += 3) {
        const auto first = static_cast<std::uint32_t>(i);
        triangles.emplace_back(first, first + 1, first + 2);
    }
    return triangles;
}

std::shared_ptr<Model> make_model(const py::object& positions, const py::object& triangles,
                                  const py::object& triangle_group, const GroupsArgument& groups,
                                  const LinesArgument& polylines, const EdgesArgument& known,
                                  const py::object& triangle_object,
                                  const py::object& polyline_object) {
    auto model = std::make_shared<Model>();
    Mesh& mesh = model->mesh;
    std::vector<glm::dvec3> points = exact_points_from(positions, "positions");
    const std::size_t corners = points.size();
    for (const py::handle line : *polylines) add_polyline(mesh, points, line);
    if (!triangles.is_none())
        mesh.triangles = triangles_from(triangles, "triangles", corners);
    else if (mesh.polylines.empty())
        mesh.triangles = triangles_in_order(corners);
    place(*model, points);
    add_groups(mesh, triangle_group, *groups);
    add_known_edges(mesh, *known);
    mesh.triangle_object = objects_from(triangle_object, "triangle_object", mesh.triangles.size());
    mesh.polyline_object = objects_from(polyline_object, "polyline_object", mesh.polylines.size());
    const auto [x, y, z] = model->origin;
    const glm::dvec3 origin{x, y, z};
    if (origin != glm::dvec3{0} && holds_floats(positions)) warn_of_lost_digits(origin);
    return model;
}

std::shared_ptr<Model> load(const std::filesystem::path& path, const LoadOptions& options,
                            const py::object& progress) {
    LoadedMesh loaded =
        released(progress, [&](const Progress& asked) { return load_mesh(path, options, asked); });
    return std::make_shared<Model>(
        Model{.mesh = std::move(loaded.mesh),
              .notes = std::move(loaded.notes),
              .origin = {loaded.origin.x, loaded.origin.y, loaded.origin.z},
              .parts = std::move(loaded.parts)});
}

py::array rows_of(const py::object& self, const glm::vec3* rows, std::size_t count) {
    return view_of(reinterpret_cast<const float*>(rows), {static_cast<py::ssize_t>(count), 3},
                   self);
}

py::object positions(const py::object& self) {
    const Mesh& mesh = self.cast<const Model&>().mesh;
    return rows_of(self, mesh.positions.data(), mesh.positions.size());
}

py::object triangles(const py::object& self) {
    const Mesh& mesh = self.cast<const Model&>().mesh;
    return view_of(reinterpret_cast<const std::uint32_t*>(mesh.triangles.data()),
                   {static_cast<py::ssize_t>(mesh.triangles.size()), 3}, self);
}

py::object numbers_of(const py::object& self, const std::vector<std::uint32_t> Mesh::*numbers) {
    const std::vector<std::uint32_t>& values = self.cast<const Model&>().mesh.*numbers;
    return view_of(values.data(), {static_cast<py::ssize_t>(values.size())}, self);
}

py::object triangle_group(const py::object& self) {
    return numbers_of(self, &Mesh::triangle_group);
}

py::object triangle_object(const py::object& self) {
    return numbers_of(self, &Mesh::triangle_object);
}

py::object polyline_object(const py::object& self) {
    return numbers_of(self, &Mesh::polyline_object);
}

py::list polylines(const py::object& self) {
    py::list lines;
    for (const std::vector<std::uint32_t>& line : self.cast<const Model&>().mesh.polylines)
        lines.append(view_of(line.data(), {static_cast<py::ssize_t>(line.size())}, self));
    return lines;
}

py::list notes(const Model& model) {
    py::list lines;
    for (const std::string& note : model.notes) lines.append(readable(note));
    return lines;
}

std::string describe(const Model& model) {
    const Mesh& mesh = model.mesh;
    return "<lineatlas.Mesh: " + std::to_string(mesh.positions.size()) + " positions, " +
           std::to_string(mesh.triangles.size()) + " triangles, " +
           std::to_string(mesh.polylines.size()) + " polylines, " +
           std::to_string(mesh.groups.size()) + " groups>";
}

struct PythonScene {
    std::string name;
    std::shared_ptr<Model> mesh;
    std::function<View(float)> view;
};

PythonScene make_python_scene(const Word<"name">& name) {
    const Released released;
    Scene scene = make_scene(*name);
    return {scene.name, std::make_shared<Model>(Model{.mesh = std::move(scene.mesh)}),
            std::move(scene.view)};
}

void bind_scene(py::module_& module) {
    py::class_<PythonScene>(module, "Scene",
                            "A built-in model with the camera path it is measured on.")
        .def_readonly("name", &PythonScene::name, "What scene() was asked for.")
        .def_readonly("mesh", &PythonScene::mesh, "The model, y up.")
        .def(
            "view", [](const PythonScene& scene, Real<"t"> t) { return scene.view(t); },
            py::arg("t") = 0.0F, "The view at t, 0 to 1, along the camera path.");
    module.def("scene", &make_python_scene, py::arg("name"),
               fmt::format("Builds a scene, one of {}.", fmt::join(scene_names(), ", ")).c_str());
    py::list names;
    for (const std::string_view name : scene_names()) names.append(py::str(std::string{name}));
    module.attr("SCENES") = py::tuple(names);
}

} // namespace

std::shared_ptr<const Model> model_of(const ModelOrPath& given) {
    if (const auto* path = std::get_if<std::filesystem::path>(&given))
        return load(*path, {}, py::none());
    return std::get<std::shared_ptr<Model>>(given);
}

void bind_mesh(py::module_& module) {
    py::class_<MeshGroup>(module, "Group",
                          "What triangles belong to. An edge between two groups is a line.")
        .def(py::init([](Word<"object"> object, Word<"material"> material, ColorArgument color) {
                 return make_group(std::move(object.value), std::move(material.value), color);
             }),
             py::arg("object") = "", py::arg("material") = "", py::arg("color") = py::none())
        .def_property_readonly(
            "object", [](const MeshGroup& group) { return readable(group.object); },
            "Name of the object; may be empty.")
        .def_property_readonly(
            "material", [](const MeshGroup& group) { return readable(group.material); },
            "Name of the material; may be empty.")
        .def_property_readonly(
            "color",
            [](const MeshGroup& group) {
                return group.color ? std::optional{tuple_of(*group.color)} : std::nullopt;
            },
            "Red, green and blue, 0 to 1, sRGB-coded; None where unknown.");

    py::class_<Model, std::shared_ptr<Model>> mesh(
        module, "Mesh",
        "Triangles and polylines to draw the lines of. It can't be changed.\n\n"
        "positions: (n, 3) real numbers, about `origin` if they lie far from zero. triangles: (m, "
        "3) indices; without them, and without\n"
        "polylines, each three positions are a triangle. triangle_group: (m,) indices into\n"
        "groups, or any numbers where groups are not named; groups: Group or names of materials.\n"
        "polylines: lines to be drawn as they are, each (k,) indices or (k, 3) points.\n"
        "known_edges: what is known of edges, as {kind: (k, 2) indices}. \"marked\": creases\n"
        "whatever the angle. With any of \"sharp\" (creases), \"smooth\" (where two faces go over\n"
        "into each other), \"free\" (boundaries) and \"seam\" (no line), edges that are not named\n"
        "are within a face, and angles say nothing.\n"
        "triangle_object, polyline_object: the number of the object that each belongs to; objects\n"
        "move on their own (Renderer(separate_objects=True)). Without them groups of one name\n"
        "are an object.\n\n"
        "Arrays may have any real type and memory order; they are copied. Equal positions are "
        "welded\n"
        "when lines are found. Raises UsageError for wrong shapes, indices out of range and\n"
        "numbers that are not finite, TypeError for what is no array of numbers.");
    mesh.def(py::init(&make_model), py::arg("positions"), py::arg("triangles") = py::none(),
             py::kw_only(), py::arg("triangle_group") = py::none(), py::arg("groups") = py::none(),
             py::arg("polylines") = py::tuple(), py::arg("known_edges") = py::none(),
             py::arg("triangle_object") = py::none(), py::arg("polyline_object") = py::none())
        .def_property_readonly("positions", &positions, "(n, 3) float32, read-only, not copied.")
        .def_property_readonly("triangles", &triangles, "(m, 3) uint32, read-only, not copied.")
        .def_property_readonly("triangle_group", &triangle_group,
                               "(m,) uint32 indices into groups, or empty; read-only, not copied.")
        .def_property_readonly("triangle_object", &triangle_object,
                               "(m,) uint32 numbers of objects, or empty; read-only, not copied.")
        .def_property_readonly("polyline_object", &polyline_object, "The same of polylines.")
        .def_property_readonly(
            "groups", [](const Model& model) { return model.mesh.groups; },
            "What triangle_group refers to.")
        .def_property_readonly("polylines", &polylines,
                               "(k,) uint32 indices of positions for each; read-only, not copied.")
        .def_property_readonly("known_edges", &known_edges,
                               "(k, 2) uint32 indices of positions for each kind that there is.")
        .def_property_readonly("notes", &notes,
                               "What was repaired or left out when the file was read.")
        .def_readonly(
            "origin", &Model::origin,
            "The origin that was subtracted from all positions. It is zero unless these lie so\n"
            "far from zero, compared with their size, that float32 would lose digits.\n"
            "Points, views and matrices, and a style's focus at a point of the model, are\n"
            "relative to it.")
        .def_property_readonly(
            "volume", [](const Model& model) { return enclosed_volume(model.mesh); },
            "The volume inside the triangles, in cubes of the unit; negative if they are inside "
            "out,\nNone if they are not closed.")
        .def("__repr__", &describe);
    bind_section(mesh);
    bind_explode(mesh);
    module.def(
        "load",
        [](const Argument<std::filesystem::path, "path", "a path">& path,
           Real<"deflection"> deflection, Real<"pixels"> pixels, Real<"read_memory"> read_memory,
           Real<"read_seconds"> read_seconds, const py::object& progress) {
            return load(path,
                        {.deflection = deflection,
                         .pixels = pixels,
                         .read_memory = read_memory,
                         .read_seconds = read_seconds},
                        progress);
        },
        py::arg("path"), py::kw_only(), py::arg("deflection") = 0.0F, py::arg("pixels") = 1280.0F,
        py::arg("read_memory") = 0.0F, py::arg("read_seconds") = 0.0F,
        py::arg("progress") = py::none(),
        ("Reads a file of one of these types: " + model_type_names() +
         ".\nRaises FileError.\n\n"
         "STEP, IGES and BREP: deflection is how far chords may be off curved faces, in\n"
         "millimetres; 0: a quarter of a pixel of a drawing in which the model's diagonal has\n"
         "`pixels` pixels. They are read by a process of their own, so that damaged files cannot\n"
         "end this one; read_memory (GiB) and read_seconds\n"
         "limit it, 0: 2 GiB and 32 times the file's size, a minute and a second for each MB.\n\n"
         "progress: called with the share that is done, 0 to 1; Cancelled is raised once it "
         "returns\n"
         "False.")
            .c_str());
    bind_scene(module);
}

} // namespace lineatlas::python
