#include <fmt/core.h>
#include <pybind11/stl.h>

#include "drawer.hpp"
#include "process.hpp"
#include "views.hpp"

// Finds the line or face at a point of a picture.
namespace lineatlas::python {
namespace {

using MaybeIndex = std::optional<std::uint32_t>;

/// A Pick with indices of the mesh and with y from the top of the picture.
struct PickedPoint {
    MaybeIndex kind{}, segment{}, path{}, triangle{}, group{};
    std::optional<std::array<std::uint32_t, 2>> edge{};
    std::uint32_t object = 0;
    glm::vec2 position{0};
    float distance = 0;
    glm::vec3 world{0};
};

MaybeIndex index_of(std::uint32_t index) {
    return index != Pick::none ? MaybeIndex{index} : std::nullopt;
}

PickedPoint in_the_mesh(const Pick& pick, const ModelLines& subject, float height) {
    const LineSet& lines = subject.lines;
    const Mesh& mesh = subject.model->mesh;
    PickedPoint found{.segment = index_of(pick.segment),
                      .object = pick.object,
                      .position = {pick.position.x, height - pick.position.y},
                      .distance = pick.distance,
                      .world = pick.world};
    if (pick.segment != Pick::none) {
        const LineSource& source = lines.sources[pick.segment];
        found.kind = static_cast<std::uint32_t>(*pick.kind);
        found.path = lines.segments[pick.segment].path;
        found.triangle = index_of(source.triangle);
        if (source.from != LineSource::none && source.to != LineSource::none)
            found.edge = {source.from, source.to};
    } else {
        found.triangle = lines.triangle_sources[pick.triangle];
    }
    if (found.triangle && *found.triangle < mesh.triangle_group.size())
        found.group = mesh.triangle_group[*found.triangle];
    return found;
}

std::optional<PickedPoint> pick(Drawer& drawer, Real<"x"> x, Real<"y"> y, Real<"radius"> radius,
                                const SizeArgument& size, const MaybeView& view,
                                const UpArgument& up) {
    std::optional<PickedPoint> point;
    std::string of_framing;
    {
        const Released released;
        std::shared_ptr<const ModelLines> subject = drawer.subject();
        const auto [camera, framed] = camera_of(view, size, up, subject->lines);
        of_framing = framed;
        const auto height = static_cast<float>((*size)[1]);
        const std::optional<Pick> found = drawer.pick(camera, {*x, height - *y}, radius, subject);
        if (found) point = in_the_mesh(*found, *subject, height);
    }
    warn_user(of_framing);
    return point;
}

std::string describe(const PickedPoint& found) {
    const std::string at =
        fmt::format("({:.6g}, {:.6g}, {:.6g})", found.world.x, found.world.y, found.world.z);
    return found.segment
               ? fmt::format("<lineatlas.Pick: {} of object {} at {}>",
                             line_kind_names.at(*found.kind), found.object, at)
               : fmt::format("<lineatlas.Pick: face of object {} at {}>", found.object, at);
}

} // namespace

void bind_picking(py::module_& module, py::class_<Drawer>& renderer) {
    py::class_<PickedPoint>(module, "Pick", "What is seen at a point: a line, or else a face.")
        .def_readonly("kind", &PickedPoint::kind, "LineKind of a line; None: it is a face.")
        .def_readonly("segment", &PickedPoint::segment, "As the field of intervals; or None.")
        .def_readonly("path", &PickedPoint::path, "As the field of intervals; or None.")
        .def_readonly(
            "edge", &PickedPoint::edge,
            "The two positions of a line's edge, as indices into mesh.positions; or None.")
        .def_readonly("triangle", &PickedPoint::triangle,
                      "Index into mesh.triangles, for a line of a triangle with its edge; or None.")
        .def_readonly("group", &PickedPoint::group,
                      "The group of the triangle, an index into mesh.groups; or None.")
        .def_readonly("object", &PickedPoint::object,
                      "Number in Renderer.objects; 0 where there are none.")
        .def_property_readonly(
            "position",
            [](const PickedPoint& found) {
                return std::tuple{found.position.x, found.position.y};
            },
            "Its place in the picture: pixels from the upper left corner.")
        .def_readonly("distance", &PickedPoint::distance,
                      "Pixels from there to the point asked for; 0 for a face.")
        .def_property_readonly(
            "world", [](const PickedPoint& found) { return tuple_of(found.world); },
            "The point of the model that is seen there.")
        .def("__repr__", &describe);
    renderer.def("pick", &pick, py::arg("x"), py::arg("y"), py::arg("radius") = 4.0F, py::kw_only(),
                 py::arg("size") = usual_size, py::arg("view") = py::none(), py::arg("up") = "y",
                 "The nearest visible line within `radius` pixels of a point, or else the face\n"
                 "there, as a Pick; or None. The point is in pixels from the upper left corner.\n"
                 "Needs no picture. size, view, up: as of draw().");
}

} // namespace lineatlas::python
