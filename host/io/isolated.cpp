#include "isolated.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

#include "image_codec.hpp"
#include "image_loader.hpp"
#include "mesh_source.hpp"
#include "reader_protocol.hpp"

namespace lineatlas {

namespace {

constexpr std::string_view mesh_kind = "mesh";
constexpr std::string_view image_kind = "image";

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
    output.values(mesh.corner_normals);
    output.value(mesh.precision);
}

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

ReaderKind::Parse open_mesh(const std::filesystem::path& path, std::string_view settings) {
    LoadOptions options;
    const char* const end = settings.data() + settings.size();
    const auto deflection = std::from_chars(settings.data(), end, options.deflection);
    if (deflection.ptr != end) std::from_chars(deflection.ptr + 1, end, options.pixels);
    return [source = read_mesh_source(path), options](ReaderOutput& output) mutable {
        send(output, parse_mesh(std::move(source), options));
    };
}

ReaderKind::Parse open_picture(const std::filesystem::path& path, std::string_view) {
    SourceFile file = read_source(path);
    image_module(type_by_content(file.bytes)); // later there is no loading
    return [file = std::move(file)](ReaderOutput& output) { send(output, decode_image(file)); };
}

constexpr std::array kinds{ReaderKind{mesh_kind, open_mesh}, ReaderKind{image_kind, open_picture}};

Mesh receive_mesh(ReaderProcess& process) {
    Mesh mesh;
    mesh.positions = process.values<glm::vec3>();
    mesh.triangles = process.values<glm::uvec3>();
    mesh.triangle_group = process.values<std::uint32_t>();
    // Lists whose elements have no fixed size grow as they come.
    for (auto left = process.value<std::uint64_t>(); left > 0; --left) {
        MeshGroup group{.object = process.text(), .material = process.text()};
        const bool colored = process.value<std::uint8_t>() != 0;
        const auto color = process.value<glm::vec3>();
        if (colored) group.color = color;
        mesh.groups.push_back(std::move(group));
    }
    for (auto left = process.value<std::uint64_t>(); left > 0; --left)
        mesh.polylines.push_back(process.values<std::uint32_t>());
    mesh.triangle_object = process.values<std::uint32_t>();
    mesh.polyline_object = process.values<std::uint32_t>();
    mesh.known_edges = process.values<KnownEdge>();
    mesh.corner_normals = process.values<glm::vec3>();
    mesh.precision = process.value<float>();
    return mesh;
}

/// Numbers of objects: none, or one each, and no more of them than there may be.
bool fits(const std::vector<std::uint32_t>& objects, std::size_t count) {
    constexpr std::uint32_t most_objects = 1U << 24U;
    return objects.empty() ||
           (objects.size() == count && std::ranges::all_of(objects, [](std::uint32_t object) {
                return object < most_objects;
            }));
}

/// What load_mesh() promises.
bool is_sound(const Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    const auto is_finite = [](glm::vec3 v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    const auto is_vertex = [&](std::uint32_t index) { return index < vertices; };
    return !mesh.empty() && std::ranges::all_of(mesh.positions, is_finite) &&
           std::ranges::all_of(mesh.triangles,
                               [&](glm::uvec3 corners) {
                                   return is_vertex(corners.x) && is_vertex(corners.y) &&
                                          is_vertex(corners.z);
                               }) &&
           std::ranges::all_of(mesh.polylines,
                               [&](const std::vector<std::uint32_t>& polyline) {
                                   return std::ranges::all_of(polyline, is_vertex);
                               }) &&
           (mesh.triangle_group.empty() || mesh.triangle_group.size() == mesh.triangles.size()) &&
           std::ranges::all_of(mesh.triangle_group,
                               [&](std::uint32_t group) { return group < mesh.groups.size(); }) &&
           fits(mesh.triangle_object, mesh.triangles.size()) &&
           fits(mesh.polyline_object, mesh.polylines.size()) &&
           std::ranges::all_of(mesh.known_edges,
                               [&](const KnownEdge& edge) {
                                   return is_vertex(edge.from) && is_vertex(edge.to) &&
                                          edge.kind <= KnownEdge::Kind::free;
                               }) &&
           (mesh.corner_normals.empty() ||
            mesh.corner_normals.size() == 3 * mesh.triangles.size()) &&
           std::ranges::all_of(mesh.corner_normals, is_finite) && mesh.precision >= 0 &&
           std::isfinite(mesh.precision);
}

bool is_sound(const LoadedMesh& loaded) {
    const std::vector<ModelPart>& parts = loaded.parts;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].parent != ModelPart::none && parts[i].parent >= i) return false;
    return is_sound(loaded.mesh) && (!loaded.unit || std::isfinite(*loaded.unit)) &&
           std::isfinite(loaded.deflection);
}

bool is_sound(const Image& image) {
    const glm::ivec2 size = image.size;
    return size.x > 0 && size.y > 0 && image.channels >= 1 && image.channels <= 4 &&
           image.pixels.size() == static_cast<std::size_t>(size.x) *
                                      static_cast<std::size_t>(size.y) *
                                      static_cast<std::size_t>(image.channels);
}

} // namespace

ReadLimits limits_for_picture(const ReadLimits& limits) {
    // A picture of 4096 x 4096 floats. What is packed well need not be large to need far more, and
    // what is large need not be a picture: the size of the file says nothing.
    constexpr std::uint64_t usual_memory = std::uint64_t{512} << 20U;
    constexpr std::chrono::seconds usual_time{60};
    ReadLimits filled = limits;
    if (filled.memory == 0) filled.memory = usual_memory;
    if (filled.time.count() == 0) filled.time = usual_time;
    return filled;
}

std::optional<int> serve_as_reader(int argc, char** argv) {
    return serve_as_reader(argc, argv, kinds);
}

LoadedMesh load_mesh_isolated(const std::filesystem::path& path, const ReadLimits& limits,
                              const LoadOptions& options) {
    return serves_as_reader() ? load_mesh_by({}, path, limits, options) : load_mesh(path, options);
}

LoadedMesh load_mesh_by(const std::filesystem::path& program, const std::filesystem::path& path,
                        const ReadLimits& limits, const LoadOptions& options) {
    // As text: %.17g gives back the same numbers.
    std::array<char, 64> settings{};
    std::snprintf(settings.data(), settings.size(), "%.17g %.17g", options.deflection,
                  options.pixels);
    ReaderProcess process{mesh_kind, path, limits, settings.data(), program};
    LoadedMesh loaded;
    for (auto left = process.value<std::uint64_t>(); left > 0; --left)
        loaded.notes.push_back(process.text());
    loaded.origin = process.value<glm::dvec3>();
    loaded.format = process.text();
    const bool says_up = process.value<std::uint8_t>() != 0;
    const auto up = process.value<glm::vec3>();
    if (says_up) loaded.up = up;
    if (const auto unit = process.value<double>(); unit > 0) loaded.unit = unit;
    loaded.deflection = process.value<double>();
    for (auto left = process.value<std::uint64_t>(); left > 0; --left) {
        ModelPart part{.name = process.text()};
        part.parent = process.value<std::uint32_t>();
        part.object = process.value<std::uint32_t>();
        part.shape = process.value<std::uint32_t>();
        loaded.parts.push_back(std::move(part));
    }
    loaded.mesh = receive_mesh(process);
    if (!is_sound(loaded)) process.refuse();
    return loaded;
}

Image read_image_isolated(const std::filesystem::path& path, const ReadLimits& limits) {
    if (!serves_as_reader()) return read_image(path);
    ReaderProcess process{image_kind, path, limits_for_picture(limits)};
    Image image;
    image.size = process.value<glm::ivec2>();
    image.channels = process.value<int>();
    image.pixels = process.values<std::uint8_t>();
    if (!is_sound(image)) process.refuse();
    return image;
}

} // namespace lineatlas
