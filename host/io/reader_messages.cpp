#include "reader_messages.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "base/printable.hpp"
#include "reader_protocol.hpp"
#include "sound.hpp"

namespace lineatlas {
namespace {

void send(ReaderOutput& output, const SplineDirection& along) {
    output.value(along.degree);
    output.values(along.knots);
}

void send(ReaderOutput& output, const SurfaceShape& shape) {
    output.value(shape.kind);
    output.value(shape.point);
    output.value(shape.axis);
    output.value(shape.curve.kind);
    output.value(shape.curve.point);
    output.value(shape.curve.u);
    output.value(shape.curve.v);
    send(output, shape.curve.along);
    output.values(shape.curve.poles);
    send(output, shape.along_u);
    send(output, shape.along_v);
    output.values(shape.poles);
    output.value(shape.offset);
}

void send(ReaderOutput& output, const KnownSurfaces& known) {
    output.value(std::uint64_t{known.shapes.size()});
    for (const SurfaceShape& shape : known.shapes) send(output, shape);
    output.value(std::uint64_t{known.surfaces.size()});
    for (const PlacedSurface& surface : known.surfaces) {
        output.value(surface.shape);
        output.value(surface.entity);
        output.value(surface.turned);
        output.value(surface.model_from_shape);
    }
    output.values(known.of_triangle);
    output.values(known.parameters);
}

void send(ReaderOutput& output, const Mesh& mesh) {
    output.values(mesh.positions);
    output.values(mesh.triangles);
    output.values(mesh.triangle_group);
    output.value(std::uint64_t{mesh.groups.size()});
    for (const MeshGroup& group : mesh.groups) {
        output.text(group.object);
        output.text(group.material);
        output.value(group.color.has_value());
        output.value(group.color.value_or(glm::vec3{0}));
    }
    output.value(std::uint64_t{mesh.polylines.size()});
    for (const auto& polyline : mesh.polylines) output.values(polyline);
    output.values(mesh.triangle_object);
    output.values(mesh.polyline_object);
    output.values(mesh.known_edges);
    output.value(std::uint64_t{mesh.edge_curves.size()});
    for (const std::optional<EdgeCurve>& curve : mesh.edge_curves) {
        output.value(curve.has_value());
        if (curve) output.value(*curve);
    }
    output.values(mesh.edge_entities);
    output.values(mesh.corner_normals);
    send(output, mesh.surfaces);
    output.value(mesh.precision);
}

MeshGroup receive_group(ReaderProcess& process) {
    MeshGroup group{.object = process.text(), .material = process.text()};
    const bool colored = process.value<std::uint8_t>() != 0;
    const auto color = process.value<glm::vec3>();
    if (colored) group.color = color;
    return group;
}

ModelPart receive_part(ReaderProcess& process) {
    ModelPart part{.name = process.text()};
    part.parent = process.value<std::uint32_t>();
    part.object = process.value<std::uint32_t>();
    part.shape = process.value<std::uint32_t>();
    return part;
}

SplineDirection receive_direction(ReaderProcess& process) {
    SplineDirection along{.degree = process.value<std::uint32_t>(), .knots = {}};
    along.knots = process.values<double>();
    return along;
}

SurfaceShape receive_shape(ReaderProcess& process) {
    SurfaceShape shape{.kind = process.value<SurfaceShape::Kind>()};
    shape.point = process.value<glm::dvec3>();
    shape.axis = process.value<glm::dvec3>();
    shape.curve.kind = process.value<SurfaceCurve::Kind>();
    shape.curve.point = process.value<glm::dvec3>();
    shape.curve.u = process.value<glm::dvec3>();
    shape.curve.v = process.value<glm::dvec3>();
    shape.curve.along = receive_direction(process);
    shape.curve.poles = process.values<glm::dvec4>();
    shape.along_u = receive_direction(process);
    shape.along_v = receive_direction(process);
    shape.poles = process.values<glm::dvec4>();
    shape.offset = process.value<double>();
    return shape;
}

KnownSurfaces receive_surfaces(ReaderProcess& process) {
    KnownSurfaces known;
    known.shapes = process.list([&] { return receive_shape(process); });
    known.surfaces = process.list([&] {
        PlacedSurface surface{.shape = process.value<std::uint32_t>()};
        surface.entity = process.value<std::uint32_t>();
        surface.turned = process.value<std::uint8_t>() != 0;
        surface.model_from_shape = process.value<glm::dmat4x3>();
        return surface;
    });
    known.of_triangle = process.values<std::uint32_t>();
    known.parameters = process.values<std::array<glm::dvec2, 3>>();
    return known;
}

Mesh receive_mesh(ReaderProcess& process) {
    Mesh mesh;
    mesh.positions = process.values<glm::vec3>();
    mesh.triangles = process.values<glm::uvec3>();
    mesh.triangle_group = process.values<std::uint32_t>();
    mesh.groups = process.list([&] { return receive_group(process); });
    mesh.polylines = process.list([&] { return process.values<std::uint32_t>(); });
    mesh.triangle_object = process.values<std::uint32_t>();
    mesh.polyline_object = process.values<std::uint32_t>();
    mesh.known_edges = process.values<KnownEdge>();
    mesh.edge_curves = process.list([&]() -> std::optional<EdgeCurve> {
        if (process.value<std::uint8_t>() == 0) return std::nullopt;
        return process.value<EdgeCurve>();
    });
    mesh.edge_entities = process.values<std::uint32_t>();
    mesh.corner_normals = process.values<glm::vec3>();
    mesh.surfaces = receive_surfaces(process);
    mesh.precision = process.value<float>();
    return mesh;
}

} // namespace

void send(ReaderOutput& output, const LoadedMesh& loaded) {
    output.value(reader::Answer::read);
    output.value(std::uint64_t{loaded.notes.size()});
    for (const std::string& note : loaded.notes) output.text(note);
    output.value(loaded.origin);
    output.text(loaded.format);
    output.value(loaded.up.has_value());
    output.value(loaded.up.value_or(glm::vec3{0}));
    output.value(loaded.unit.value_or(0));
    output.value(loaded.deflection);
    output.value(std::uint64_t{loaded.parts.size()});
    for (const ModelPart& part : loaded.parts) {
        output.text(part.name);
        output.value(part.parent);
        output.value(part.object);
        output.value(part.shape);
    }
    send(output, loaded.mesh);
}

void send(ReaderOutput& output, const Image& image) {
    output.value(reader::Answer::read);
    output.value(image.size);
    output.value(image.channels);
    output.values(image.pixels);
}

LoadedMesh receive_model(ReaderProcess& process) {
    LoadedMesh loaded;
    loaded.notes = process.list([&] { return printable(process.text(), longest_message); });
    loaded.origin = process.value<glm::dvec3>();
    loaded.format = printable(process.text());
    const bool says_up = process.value<std::uint8_t>() != 0;
    const auto up = process.value<glm::vec3>();
    if (says_up) loaded.up = up;
    if (const auto unit = process.value<double>(); unit > 0) loaded.unit = unit;
    loaded.deflection = process.value<double>();
    loaded.parts = process.list([&] { return receive_part(process); });
    loaded.mesh = receive_mesh(process);
    if (!is_sound(loaded)) process.refuse();
    return loaded;
}

Image receive_picture(ReaderProcess& process) {
    Image image;
    image.size = process.value<glm::ivec2>();
    image.channels = process.value<int>();
    image.pixels = process.values<std::uint8_t>();
    if (!is_sound(image)) process.refuse();
    return image;
}

} // namespace lineatlas
