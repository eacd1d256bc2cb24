// The functions that ../lineatlas.js calls. Arguments are numbers, and addresses of numbers in the
// module's memory. Larger results stay in the module; functions return their addresses. A function
// that may fail returns true if it succeeded, or an address that is 0 if it failed. la_message()
// then gives the reason.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/framing.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/mesh.hpp"
#include "lineatlas/section.hpp"
#include "lineatlas/style_files.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"

#include "io/own_readers.hpp"

#define EXPORT(name) __attribute__((export_name(#name))) extern "C"

/// The page's progress function. Gets the share that is done; returns 0 to stop.
__attribute__((import_module("lineatlas"), import_name("progress"))) extern "C" int
la_progress(float done);

namespace {

using namespace lineatlas;

constexpr std::uint32_t none = 0xFFFFFFFF;

std::string message;
bool cancelled = false;
constexpr const char* no_memory = "lineatlas: out of memory; 4 GiB is all that WebAssembly has";
std::string text; ///< the last written drawing

/// Calls `action`. False if it threw; `message` is then the exception's.
template <class Action>
bool guarded(const Action& action) {
    cancelled = false;
    try {
        action();
        return true;
    } catch (const Cancelled& stop) {
        cancelled = true;
        message = stop.what();
    } catch (const std::bad_alloc&) {
        message = no_memory;
    } catch (const std::length_error&) { // a list longer than any memory
        message = no_memory;
    } catch (const std::exception& error) {
        message = error.what();
    }
    return false;
}

bool go_on(float done) {
    return la_progress(done) != 0;
}

/// The part of a model that comes from one mesh of the page.
struct Part {
    std::uint32_t first_position = 0, first_triangle = 0;
};

/// A model that is being put together, and then its lines.
struct Model {
    Mesh mesh;
    std::vector<Part> parts;
    std::uint32_t position_count = 0; ///< positions of the page; those of cuts follow
    bool is_cut = false;
    std::vector<SectionPlane> sections;
    std::vector<std::string> notes;
    LineSet lines;
    std::optional<LineVisibility> visibility;
};

/// The visible lines of a camera.
struct Seen {
    Camera camera;
    std::vector<Interval> intervals;
    std::vector<OutlinePart> outlines;
};

template <class Number>
std::span<const Number> numbers(const Number* first, std::uint32_t count) {
    return {first, first == nullptr ? 0 : count};
}

/// A matrix from 16 numbers by columns.
template <class Matrix>
Matrix matrix_of(const float* columns) {
    Matrix matrix{1};
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = columns[i];
    return matrix;
}

glm::dvec3 transformed(const glm::dmat4& matrix, glm::vec3 point) {
    return matrix * glm::dvec4{point, 1};
}

/// Transforms the mesh. A matrix that mirrors also reverses the triangles, so that they show the
/// same side.
void place(Mesh& mesh, const float* columns) {
    const auto matrix = matrix_of<glm::dmat4>(columns);
    for (glm::vec3& position : mesh.positions) position = transformed(matrix, position);
    if (glm::determinant(glm::dmat3{matrix}) >= 0) return;
    for (glm::uvec3& triangle : mesh.triangles) std::swap(triangle.y, triangle.z);
}

/// Appends the mesh to the model.
void append(Model& model, Mesh mesh, std::string name) {
    Mesh& all = model.mesh;
    const auto positions = static_cast<std::uint32_t>(all.positions.size());
    const auto groups = static_cast<std::uint32_t>(all.groups.size());
    const auto part = static_cast<std::uint32_t>(model.parts.size());
    model.parts.push_back({positions, static_cast<std::uint32_t>(all.triangles.size())});
    if (mesh.groups.empty()) {
        mesh.groups.emplace_back();
        mesh.triangle_group.assign(mesh.triangles.size(), 0);
    }
    for (MeshGroup& group : mesh.groups) {
        if (group.object.empty()) group.object = name;
        all.groups.push_back(std::move(group));
    }
    all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const glm::uvec3& triangle : mesh.triangles) all.triangles.push_back(triangle + positions);
    for (const std::uint32_t group : mesh.triangle_group)
        all.triangle_group.push_back(groups + group);
    all.triangle_object.insert(all.triangle_object.end(), mesh.triangles.size(), part);
}

/// Takes the first name from a list in which each name ends in a zero byte.
std::string take_name(std::string_view& names) {
    const std::size_t end = std::min(names.find('\0'), names.size());
    std::string name{names.substr(0, end)};
    names.remove_prefix(std::min(end + 1, names.size()));
    return name;
}

/// Sets the groups of a mesh. `names` has an object and a material per group, `materials` a group
/// per triangle.
void set_groups(Mesh& mesh, std::string_view names, std::span<const std::uint32_t> materials) {
    while (!names.empty()) {
        std::string object = take_name(names);
        mesh.groups.push_back({.object = std::move(object), .material = take_name(names)});
    }
    if (materials.size() != mesh.triangles.size())
        throw UsageError("mesh: there are " + std::to_string(mesh.triangles.size()) +
                         " triangles and " + std::to_string(materials.size()) + " materials");
    for (const std::uint32_t material : materials)
        if (material >= mesh.groups.size())
            throw UsageError("mesh: there is no group " + std::to_string(material) + " among " +
                             std::to_string(mesh.groups.size()));
    mesh.triangle_group.assign(materials.begin(), materials.end());
}

/// The content of a file as arrays.
struct Loaded {
    LoadedMesh model;
    std::string notes, groups; ///< one line each; an object and a material per group
    std::vector<std::uint32_t> polylines,
        polyline_ends; ///< vertices; number of vertices up to each end
};
std::unique_ptr<Loaded> loaded;

std::string extension_of(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    std::string extension{dot == name.npos ? std::string_view{} : name.substr(dot)};
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

LoadedMesh load(SourceFile file) {
    const std::string name = file.path, extension = extension_of(name);
    if (file.bytes.empty()) throw read_error(name, "the file is empty");
    if (!has_own_reader(extension)) {
        refuse_other_types(file, extension);
        throw read_error(name, "unknown mesh type \"" + printable(extension) +
                                   "\"; known are .obj, .ply, .stl and .off");
    }
    return finish(read_own(std::move(file), extension, {}, ProgressPart::none()), name);
}

/// The arrays of a model for the page.
std::unique_ptr<Loaded> as_arrays(LoadedMesh model) {
    auto made = std::make_unique<Loaded>();
    for (const std::string& note : model.notes) made->notes += note + '\n';
    for (const MeshGroup& group : model.mesh.groups)
        made->groups += group.object + '\0' + group.material + '\0';
    for (const std::vector<std::uint32_t>& line : model.mesh.polylines) {
        made->polylines.insert(made->polylines.end(), line.begin(), line.end());
        made->polyline_ends.push_back(static_cast<std::uint32_t>(made->polylines.size()));
    }
    made->model = std::move(model);
    return made;
}

/// An index of the page: the part, and the index within it.
struct PartIndex {
    std::uint32_t part = none, index = none;
};

PartIndex page_vertex(const Model& model, std::uint32_t position) {
    if (position >= model.position_count) return {};
    const auto after =
        std::ranges::upper_bound(model.parts, position, {}, &Part::first_position) - 1;
    return {static_cast<std::uint32_t>(after - model.parts.begin()),
            position - after->first_position};
}

/// A triangle as the page knows it. After a cut the model has other triangles than the page.
PartIndex page_triangle(const Model& model, std::uint32_t triangle) {
    if (triangle == none) return {};
    const std::uint32_t part = model.mesh.triangle_object[triangle];
    return {part, model.is_cut ? none : triangle - model.parts[part].first_triangle};
}

/// The source of a line, in indices of the page.
struct PageSource {
    std::uint32_t part = none, from = none, to = none, triangle = none;
};

PageSource page_source(const Model& model, const LineSource& source) {
    const PartIndex from = page_vertex(model, source.from), to = page_vertex(model, source.to);
    const PartIndex face = page_triangle(model, source.triangle);
    const bool has_edge = from.part != none && from.part == to.part;
    return {.part = has_edge ? from.part : face.part,
            .from = has_edge ? from.index : none,
            .to = has_edge ? to.index : none,
            .triangle = face.index};
}

/// The pieces of lines as arrays for the page.
struct Segments {
    std::vector<float> positions, screen;
    std::vector<std::uint32_t> edges, parts;
    std::vector<std::uint8_t> kinds, visible;

    void clear() { *this = {}; }
};
Segments segments;

void add_segment(const Model& model, const Interval& interval, float height) {
    const Segment& segment = model.lines.segments[interval.segment];
    const PageSource source = page_source(model, model.lines.sources[interval.segment]);
    for (const float* point : {interval.start_world, interval.end_world})
        segments.positions.insert(segments.positions.end(), point, point + 3);
    for (const float* point : {interval.start, interval.end}) {
        segments.screen.push_back(point[0]);
        segments.screen.push_back(height - point[1]);
    }
    segments.edges.insert(segments.edges.end(), {source.from, source.to});
    segments.parts.push_back(source.part);
    segments.kinds.push_back(static_cast<std::uint8_t>(segment.tag & LA_TAG_KIND_MASK));
    segments.visible.push_back((interval.flags & LA_INTERVAL_VISIBLE) != 0 ? 1 : 0);
}

/// A camera from the page's data. `matrices`: 16 numbers of the view, then 16 of the projection, by
/// columns.
Camera camera_of(const float* matrices, int width, int height, int zero_to_one) {
    Camera camera;
    camera.view = matrix_of<glm::mat4>(matrices);
    camera.projection = matrix_of<glm::mat4>(matrices + 16);
    camera.size = {width, height};
    camera.clip.zero_to_one = zero_to_one != 0;
    return camera;
}

void put_matrices(const Camera& camera, float* matrices) {
    for (int i = 0; i < 16; ++i) {
        matrices[i] = camera.view[i / 4][i % 4];
        matrices[16 + i] = camera.projection[i / 4][i % 4];
    }
}

/// The default style with changed settings, one "key=value" per line.
Style style_of(std::string_view settings) {
    Style style;
    while (!settings.empty()) {
        const std::size_t end = std::min(settings.find('\n'), settings.size());
        apply_setting(style, settings.substr(0, end));
        settings.remove_prefix(std::min(end + 1, settings.size()));
    }
    return style;
}

VectorDrawing drawing_of(const Model& model, const Seen& seen, const Style& style) {
    return make_vector_drawing(model.lines, seen.camera, seen.intervals, style,
                               {.mesh = &model.mesh, .outlines = seen.outlines});
}

std::optional<Page> page_of(double width, double height) {
    if (!(width > 0)) return std::nullopt;
    return Page{{width, Unit::mm}, {height, Unit::mm}};
}

} // namespace

EXPORT(la_allocate) void* la_allocate(std::size_t bytes) {
    return std::malloc(std::max<std::size_t>(bytes, 1));
}
EXPORT(la_free) void la_free(void* memory) {
    std::free(memory);
}
EXPORT(la_message) const char* la_message() {
    return message.data();
}
EXPORT(la_message_size) std::size_t la_message_size() {
    return message.size();
}
EXPORT(la_cancelled) int la_cancelled() {
    return cancelled ? 1 : 0;
}

EXPORT(la_make_model) Model* la_make_model() {
    Model* model = nullptr;
    guarded([&] {
        message.reserve(4096); // for messages when memory runs out
        model = new Model;
    });
    return model;
}
EXPORT(la_free_model) void la_free_model(Model* model) {
    delete model;
}

/// Reads a file in memory. The extension of its name gives the type. la_loaded() and the functions
/// after it return its content, until la_drop_loaded().
EXPORT(la_load)
bool la_load(const char* bytes, std::uint32_t size, const char* name, std::uint32_t name_size) {
    return guarded([&] {
        loaded = as_arrays(load({.path = {name, name_size}, .bytes = {bytes, size}}));
    });
}
/// The start of a list of the file: 0 positions, 1 indices, 2 materials, 3 groups, 4 notes, 5
/// vertices of polylines, 6 ends of polylines, 7 the origin.
EXPORT(la_loaded) const void* la_loaded(int list) {
    const Mesh& mesh = loaded->model.mesh;
    const std::array<const void*, 8> lists{mesh.positions.data(),        mesh.triangles.data(),
                                           mesh.triangle_group.data(),   loaded->groups.data(),
                                           loaded->notes.data(),         loaded->polylines.data(),
                                           loaded->polyline_ends.data(), &loaded->model.origin};
    return lists[static_cast<std::size_t>(list)];
}
/// The length of that list.
EXPORT(la_loaded_size) std::size_t la_loaded_size(int list) {
    const Mesh& mesh = loaded->model.mesh;
    const std::array<std::size_t, 8> sizes{3 * mesh.positions.size(),    3 * mesh.triangles.size(),
                                           mesh.triangle_group.size(),   loaded->groups.size(),
                                           loaded->notes.size(),         loaded->polylines.size(),
                                           loaded->polyline_ends.size(), 3};
    return sizes[static_cast<std::size_t>(list)];
}
EXPORT(la_drop_loaded) void la_drop_loaded() {
    loaded.reset();
}

EXPORT(la_add_mesh)
bool la_add_mesh(Model* model, const char* name, std::uint32_t name_size, const float* positions,
                 std::uint32_t position_count, std::uint32_t stride, const std::uint32_t* indices,
                 std::uint32_t index_count, const std::uint32_t* materials,
                 std::uint32_t material_count, const char* groups, std::uint32_t groups_size,
                 const float* matrix) {
    return guarded([&] {
        const auto given = numbers(materials, material_count);
        const bool named = groups_size > 0;
        Mesh mesh = make_mesh({.positions = numbers(positions, position_count),
                               .stride = stride,
                               .indices = numbers(indices, index_count),
                               .materials = named ? std::span<const std::uint32_t>{} : given});
        if (named) set_groups(mesh, {groups, groups_size}, given);
        if (matrix != nullptr) place(mesh, matrix);
        append(*model, std::move(mesh), std::string{name, name_size});
    });
}

/// Adds a polyline by points to the last mesh.
EXPORT(la_add_polyline)
bool la_add_polyline(Model* model, const float* points, std::uint32_t point_count,
                     const float* matrix) {
    return guarded([&] {
        Mesh& mesh = model->mesh;
        const auto place = matrix == nullptr ? glm::dmat4{1} : matrix_of<glm::dmat4>(matrix);
        std::vector<glm::vec3> line;
        for (std::uint32_t i = 0; i < point_count; ++i)
            line.emplace_back(
                transformed(place, {points[3 * i], points[3 * i + 1], points[3 * i + 2]}));
        add_polyline(mesh, line);
        mesh.polyline_object.push_back(static_cast<std::uint32_t>(model->parts.size()) - 1);
    });
}

/// Adds a polyline by vertices to the last mesh.
EXPORT(la_join_vertices)
bool la_join_vertices(Model* model, const std::uint32_t* vertices, std::uint32_t count) {
    return guarded([&] {
        Mesh& mesh = model->mesh;
        const std::uint32_t first = model->parts.back().first_position;
        std::vector<std::uint32_t> line;
        for (const std::uint32_t vertex : numbers(vertices, count)) {
            if (vertex >= mesh.positions.size() - first)
                throw UsageError("mesh: a polyline has the vertex " + std::to_string(vertex) +
                                 ", but there are " +
                                 std::to_string(mesh.positions.size() - first));
            line.push_back(first + vertex);
        }
        mesh.polylines.push_back(std::move(line));
        mesh.polyline_object.push_back(static_cast<std::uint32_t>(model->parts.size()) - 1);
    });
}

EXPORT(la_add_section)
bool la_add_section(Model* model, const double* point_and_normal) {
    return guarded([&] {
        const double* n = point_and_normal;
        model->sections.push_back({.point = {n[0], n[1], n[2]}, .normal = {n[3], n[4], n[5]}});
    });
}

/// Extracts the lines. crease: radians, or NaN for the default of LineOptions::crease. hatching:
/// the spacing; 0: the default; below 0: none.
EXPORT(la_extract)
bool la_extract(Model* model, std::uint32_t kinds, float crease, std::uint32_t silhouettes,
                int separate, double hatching) {
    return guarded([&] {
        model->visibility.reset();
        model->position_count = static_cast<std::uint32_t>(model->mesh.positions.size());
        model->is_cut = !model->sections.empty();
        if (model->is_cut) {
            Section section = cut_mesh(model->mesh, model->sections,
                                       {.spacing = std::max(hatching, 0.0), .none = hatching < 0});
            model->mesh = std::move(section.mesh);
            model->notes = std::move(section.notes);
            model->sections.clear();
        }
        model->lines =
            extract_lines(model->mesh,
                          {.lines = kinds,
                           .crease = std::isnan(crease) ? std::nullopt : std::optional{crease},
                           .separate_objects = separate != 0,
                           .silhouettes = static_cast<Silhouettes>(silhouettes)},
                          go_on);
        model->visibility.emplace(model->lines, DeviceOptions{.compute = "cpp"});
    });
}

EXPORT(la_segment_count) std::uint32_t la_segment_count(const Model* model) {
    return static_cast<std::uint32_t>(model->lines.segments.size());
}
/// Six floats: the least coordinates, then the greatest.
EXPORT(la_bounds) const Bounds* la_bounds(const Model* model) {
    return &model->lines.bounds;
}
/// Writes the cuts that did not close to `text`, one line each.
EXPORT(la_notes) bool la_notes(const Model* model) {
    return guarded([&] {
        text.clear();
        for (const std::string& note : model->notes) text += note + '\n';
    });
}

EXPORT(la_hide)
bool la_hide(Model* model, const std::uint32_t* parts, std::uint32_t count) {
    return guarded([&] { model->visibility->set_hidden(numbers(parts, count)); });
}

/// Writes the matrices of a view that shows the whole model. direction: as for view_direction();
/// empty: from the front, right and above.
EXPORT(la_frame)
bool la_frame(const Model* model, float* matrices, int width, int height, const char* direction,
              std::uint32_t direction_size, float up_x, float up_y, float up_z, float fov_y,
              int parallel) {
    return guarded([&] {
        if (model->lines.vertices.empty()) throw UsageError("lines: there is nothing to show");
        const std::vector<glm::vec3> points = framing_of(model->lines).points;
        const glm::vec3 up{up_x, up_y, up_z};
        const Projection projection =
            parallel != 0 ? Projection::orthographic : Projection::perspective;
        const View view = direction_size == 0
                              ? frame_points(points, {width, height}, up, fov_y, projection)
                              : frame_points_from(view_direction({direction, direction_size}, up),
                                                  points, {width, height}, fov_y, projection);
        put_matrices(make_camera(view, {width, height}, model->lines.bounds), matrices);
    });
}

EXPORT(la_find)
Seen* la_find(Model* model, const float* matrices, int width, int height, int zero_to_one,
              std::uint32_t kinds, int hidden, int outlines) {
    std::unique_ptr<Seen> seen;
    const bool found = guarded([&] {
        seen = std::make_unique<Seen>();
        seen->camera = camera_of(matrices, width, height, zero_to_one);
        seen->intervals = model->visibility->find(
            seen->camera, {.lines = kinds, .hidden = hidden != 0, .outlines = outlines != 0},
            go_on);
        if (outlines != 0) seen->outlines = model->visibility->outlines();
    });
    return found ? seen.release() : nullptr;
}
EXPORT(la_free_seen) void la_free_seen(Seen* seen) {
    delete seen;
}
EXPORT(la_seen_count) std::uint32_t la_seen_count(const Seen* seen) {
    return static_cast<std::uint32_t>(seen->intervals.size());
}

/// Fills `segments`, which lasts until la_drop_segments().
EXPORT(la_segments) bool la_segments(const Model* model, const Seen* seen) {
    return guarded([&] {
        segments.clear();
        const auto height = static_cast<float>(seen->camera.size.y);
        for (const Interval& interval : seen->intervals) add_segment(*model, interval, height);
    });
}
EXPORT(la_segments_positions) const float* la_segments_positions() {
    return segments.positions.data();
}
EXPORT(la_segments_screen) const float* la_segments_screen() {
    return segments.screen.data();
}
EXPORT(la_segments_edges) const std::uint32_t* la_segments_edges() {
    return segments.edges.data();
}
EXPORT(la_segments_parts) const std::uint32_t* la_segments_parts() {
    return segments.parts.data();
}
EXPORT(la_segments_kinds) const std::uint8_t* la_segments_kinds() {
    return segments.kinds.data();
}
EXPORT(la_segments_visible) const std::uint8_t* la_segments_visible() {
    return segments.visible.data();
}
EXPORT(la_drop_segments) void la_drop_segments() {
    segments.clear();
}

/// Writes the drawing to `text` as a file. format: 0 SVG, 1 DXF, 2 JSON. page: millimetres; 0: the
/// picture's own size.
EXPORT(la_write)
bool la_write(const Model* model, const Seen* seen, int format, const char* settings,
              std::uint32_t settings_size, const char* title, std::uint32_t title_size,
              double page_width, double page_height, double margin, int tags) {
    return guarded([&] {
        text = {};
        const VectorDrawing drawing =
            drawing_of(*model, *seen, style_of({settings, settings_size}));
        const std::optional<Page> page = page_of(page_width, page_height);
        const Length around{margin, Unit::mm};
        if (format == 0)
            text = to_svg(drawing, {.units = page ? Unit::mm : Unit::px,
                                    .page = page,
                                    .margin = around,
                                    .tags = tags != 0,
                                    .title = std::string{title, title_size}});
        else if (format == 1)
            text = to_dxf(drawing, {.page = page, .margin = around});
        else
            text = to_json(drawing, {.tags = tags != 0});
    });
}
EXPORT(la_text) const char* la_text() {
    return text.data();
}
EXPORT(la_text_size) std::size_t la_text_size() {
    return text.size();
}
EXPORT(la_drop_text) void la_drop_text() {
    text = {};
}

/// The result of la_pick().
struct Picked {
    std::uint32_t kind = none; ///< LineKind; none: a face
    std::uint32_t part = none, from = none, to = none, triangle = none;
    float x = 0, y = 0, distance = 0;
    std::array<float, 3> world{};
};
static Picked picked;

/// The result; nullptr if nothing is there or the call failed. `message` is not empty if it failed.
/// x, y: pixels from the upper left corner.
EXPORT(la_pick)
const Picked* la_pick(Model* model, const float* matrices, int width, int height, int zero_to_one,
                      float x, float y, float radius, std::uint32_t kinds) {
    const Picked* result = nullptr;
    message.clear();
    guarded([&] {
        const auto rows = static_cast<float>(height);
        const std::optional<Pick> pick = model->visibility->pick(
            camera_of(matrices, width, height, zero_to_one), {x, rows - y}, radius, kinds);
        if (!pick) return;
        picked = {.x = pick->position.x,
                  .y = rows - pick->position.y,
                  .distance = pick->distance,
                  .world = {pick->world.x, pick->world.y, pick->world.z}};
        const bool is_line = pick->segment != Pick::none;
        const LineSource source =
            is_line ? model->lines.sources[pick->segment]
                    : LineSource{.triangle = model->lines.triangle_sources[pick->triangle]};
        if (is_line) picked.kind = static_cast<std::uint32_t>(*pick->kind);
        const PageSource of_page = page_source(*model, source);
        picked.part = of_page.part;
        picked.from = of_page.from;
        picked.to = of_page.to;
        picked.triangle = of_page.triangle;
        result = &picked;
    });
    return result;
}
