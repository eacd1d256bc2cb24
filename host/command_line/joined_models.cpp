#include "joined_models.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "io/model_types.hpp"
#include "io/part_paths.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t none = ModelPart::none;

std::uint32_t count_of_objects(const Mesh& mesh) {
    std::uint32_t count = 0;
    for (const auto* objects : {&mesh.triangle_object, &mesh.polyline_object})
        for (const std::uint32_t object : *objects) count = std::max(count, object + 1);
    return count;
}

/// Adds a part for the lines of a file that does not say which parts lines belong to.
void add_part_of_lines(LoadedMesh& loaded) {
    Mesh& mesh = loaded.mesh;
    if (mesh.polylines.empty() || !mesh.polyline_object.empty()) return;
    const std::uint32_t object = count_of_objects(mesh);
    mesh.polyline_object.assign(mesh.polylines.size(), object);
    loaded.parts.push_back({.name = "lines", .object = object});
}

/// Makes parts and objects for a file without a tree, from its groups by name.
void make_parts_of_groups(LoadedMesh& loaded) {
    PartPaths paths = part_paths(loaded);
    for (std::uint32_t i = 0; i < paths.paths.size(); ++i)
        loaded.parts.push_back({.name = paths.paths[i].whole(), .object = i});
    loaded.mesh.triangle_object = std::move(paths.of_triangle);
    loaded.mesh.polyline_object.clear();
}

/// Puts all parts of a file below a part with the file's name. If the file has a single part
/// without a name, that part gets the name.
void plant(LoadedMesh& loaded, const std::string& name) {
    if (loaded.parts.empty()) make_parts_of_groups(loaded);
    add_part_of_lines(loaded);
    std::vector<ModelPart>& parts = loaded.parts;
    if (parts.size() == 1 && parts[0].name.empty()) {
        parts[0].name = name;
        return;
    }
    for (ModelPart& part : parts) part.parent = part.parent == none ? 0 : part.parent + 1;
    parts.insert(parts.begin(), ModelPart{.name = name});
}

/// Adds the kinds of edges that extract_lines() finds, in the form of a file's known edges.
void add_known_edges(Mesh& mesh) {
    if (mesh.triangles.empty()) return;
    const LineSet lines =
        extract_lines(mesh, {.lines = mask_of(LineKind::crease) | mask_of(LineKind::boundary)});
    std::uint32_t number = 0;
    const std::array kinds{std::pair{LineKind::crease, KnownEdge::Kind::sharp},
                           std::pair{LineKind::boundary, KnownEdge::Kind::free}};
    for (std::size_t i = 0; i < lines.sources.size(); ++i) {
        const LineSource& source = lines.sources[i];
        for (const auto& [kind, known] : kinds)
            if ((lines.segments[i].tag & LA_TAG_KIND_MASK) == static_cast<std::uint32_t>(kind) &&
                source.from != LineSource::none && source.to != LineSource::none)
                mesh.known_edges.push_back({source.from, source.to, known, number++});
    }
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& values) {
    to.insert(to.end(), values.begin(), values.end());
}

/// Joins models one after another.
class Joining {
  public:
    Joining(const std::vector<NamedModel>& models) {
        for (const NamedModel& model : models) {
            knows_edges_ = knows_edges_ || !model.loaded.mesh.known_edges.empty();
            if (!result_.unit) result_.unit = model.loaded.unit;
            if (!result_.up) result_.up = model.loaded.up;
        }
        result_.origin = models.front().loaded.origin * scale_of(models.front().loaded);
    }

    void add(NamedModel model) {
        LoadedMesh& loaded = model.loaded;
        for (const std::string& note : loaded.notes)
            result_.notes.push_back(model.name + ": " + note);
        if (loaded.up && *loaded.up != *result_.up) stand_upright(model, *result_.up);
        if (knows_edges_ && loaded.mesh.known_edges.empty()) add_known_edges(loaded.mesh);
        plant(loaded, model.name);
        add_positions(model);
        add_groups(model);
        const auto corners = static_cast<std::uint32_t>(first_position_);
        result_.mesh.precision =
            std::max(result_.mesh.precision,
                     static_cast<float>(scale_of(loaded) * double{loaded.mesh.precision}));
        add_normals(loaded.mesh);
        add_surfaces(loaded);
        const std::uint32_t objects = objects_;
        objects_ += count_of_objects(loaded.mesh);
        add_parts(loaded, objects);
        Mesh& mesh = result_.mesh;
        for (const glm::uvec3 t : loaded.mesh.triangles) mesh.triangles.push_back(t + corners);
        for (const std::uint32_t object : loaded.mesh.triangle_object)
            mesh.triangle_object.push_back(object + objects);
        for (std::vector<std::uint32_t>& line : loaded.mesh.polylines) {
            for (std::uint32_t& position : line) position += corners;
            mesh.polylines.push_back(std::move(line));
        }
        for (const std::uint32_t object : loaded.mesh.polyline_object)
            mesh.polyline_object.push_back(object + objects);
        loaded.mesh.polyline_kind.resize(loaded.mesh.polylines.size(), PolylineKind::file);
        append(mesh.polyline_kind, loaded.mesh.polyline_kind);
        add_edges(model, corners);
    }

    LoadedMesh take() { return std::move(result_); }

  private:
    /// Turns a model with another upward axis by a quarter, so that its front stays in front.
    void stand_upright(NamedModel& model, glm::vec3 up) {
        LoadedMesh& loaded = model.loaded;
        const glm::dvec3 from = *loaded.up, to = up, side = glm::cross(from, to);
        if (glm::dot(from, to) != 0)
            return result_.notes.push_back(model.name +
                                           " stands upside down; it stays as its file has it");
        const glm::dmat3 turn = glm::outerProduct(to, from) - glm::outerProduct(from, to) +
                                glm::outerProduct(side, side);
        const auto turned = [&](auto& v) { v = turn * glm::dvec3{v}; };
        std::ranges::for_each(loaded.mesh.positions, turned);
        std::ranges::for_each(loaded.mesh.corner_normals, turned);
        turned(loaded.origin);
        for (PlacedSurface& surface : loaded.mesh.surfaces.surfaces)
            surface.model_from_shape = turn * surface.model_from_shape;
        for (std::optional<EdgeCurve>& curve : loaded.mesh.edge_curves)
            if (curve) curve = EdgeCurve{turn * curve->center, turn * curve->u, turn * curve->v};
        result_.notes.push_back(model.name + " has another upward axis; it is turned upright");
    }

    double scale_of(const LoadedMesh& loaded) const {
        return loaded.unit && result_.unit ? *loaded.unit / *result_.unit : 1;
    }

    /// The vector to add to a model's scaled positions.
    glm::dvec3 move_of(const LoadedMesh& loaded) const {
        return scale_of(loaded) * loaded.origin - result_.origin;
    }

    void add_positions(const NamedModel& model) {
        std::vector<glm::vec3>& positions = result_.mesh.positions;
        first_position_ = positions.size();
        const double scale = scale_of(model.loaded);
        if (scale != 1)
            result_.notes.push_back(fmt::format(
                "{} has another unit of length: it is scaled by {:g}", model.name, scale));
        const glm::dvec3 moved = move_of(model.loaded);
        for (const glm::vec3 p : model.loaded.mesh.positions)
            positions.emplace_back(scale * glm::dvec3{p} + moved);
    }

    /// Adds normals, before the triangles are added. Models without normals get zeros.
    void add_normals(const Mesh& mesh) {
        std::vector<glm::vec3>& normals = result_.mesh.corner_normals;
        if (normals.empty() && mesh.corner_normals.empty()) return;
        normals.resize(3 * result_.mesh.triangles.size());
        append(normals, mesh.corner_normals);
        normals.resize(3 * (result_.mesh.triangles.size() + mesh.triangles.size()));
    }

    /// Adds surfaces, before the triangles are added. Triangles without one get none.
    void add_surfaces(const LoadedMesh& loaded) {
        KnownSurfaces& all = result_.mesh.surfaces;
        const KnownSurfaces& own = loaded.mesh.surfaces;
        if (all.empty() && own.empty()) return;
        const auto fill = [&](std::size_t triangles) {
            all.of_triangle.resize(triangles, KnownSurfaces::none);
            all.parameters.resize(triangles);
        };
        fill(result_.mesh.triangles.size());
        const auto first_shape = static_cast<std::uint32_t>(all.shapes.size());
        const auto first = static_cast<std::uint32_t>(all.surfaces.size());
        append(all.shapes, own.shapes);
        const double scale = scale_of(loaded);
        for (PlacedSurface surface : own.surfaces) {
            surface.shape += first_shape;
            surface.model_from_shape *= scale;
            surface.model_from_shape[3] += move_of(loaded);
            all.surfaces.push_back(surface);
        }
        for (const std::uint32_t surface : own.of_triangle)
            all.of_triangle.push_back(surface == KnownSurfaces::none ? surface : surface + first);
        append(all.parameters, own.parameters);
        fill(result_.mesh.triangles.size() + loaded.mesh.triangles.size());
    }

    void add_groups(NamedModel& model) {
        Mesh& mesh = model.loaded.mesh;
        if (mesh.triangle_group.empty()) {
            mesh.groups = {{.object = model.name, .material = {}}};
            mesh.triangle_group.assign(mesh.triangles.size(), 0);
        }
        const auto first = static_cast<std::uint32_t>(result_.mesh.groups.size());
        append(result_.mesh.groups, mesh.groups);
        for (const std::uint32_t group : mesh.triangle_group)
            result_.mesh.triangle_group.push_back(group + first);
    }

    void add_parts(const LoadedMesh& loaded, std::uint32_t objects) {
        const auto first = static_cast<std::uint32_t>(result_.parts.size());
        const std::uint32_t shapes = shapes_;
        for (ModelPart part : loaded.parts) {
            if (part.parent != none) part.parent += first;
            if (part.object != none) part.object += objects;
            if (part.shape != none) {
                part.shape += shapes;
                shapes_ = std::max(shapes_, part.shape + 1);
            }
            result_.parts.push_back(std::move(part));
        }
    }

    void add_edges(const NamedModel& model, std::uint32_t corners) {
        const std::uint32_t first = edges_;
        for (KnownEdge edge : model.loaded.mesh.known_edges) {
            edge.from += corners;
            edge.to += corners;
            edge.edge += first;
            edges_ = std::max(edges_, edge.edge + 1);
            result_.mesh.known_edges.push_back(edge);
        }
        const std::vector<std::uint32_t>& entities = model.loaded.mesh.edge_entities;
        if (!entities.empty()) {
            result_.mesh.edge_entities.resize(first);
            append(result_.mesh.edge_entities, entities);
        }
        const std::vector<std::optional<EdgeCurve>>& curves = model.loaded.mesh.edge_curves;
        if (curves.empty()) return;
        result_.mesh.edge_curves.resize(first);
        const double scale = scale_of(model.loaded);
        const glm::dvec3 moved = move_of(model.loaded);
        for (std::optional<EdgeCurve> curve : curves) {
            if (curve)
                curve = EdgeCurve{.center = scale * curve->center + moved,
                                  .u = scale * curve->u,
                                  .v = scale * curve->v};
            result_.mesh.edge_curves.push_back(curve);
        }
        edges_ = std::max(edges_, static_cast<std::uint32_t>(result_.mesh.edge_curves.size()));
    }

    LoadedMesh result_;
    bool knows_edges_ = false;
    std::size_t first_position_ = 0;
    std::uint32_t objects_ = 0, shapes_ = 0, edges_ = 0; ///< numbers given so far
};

/// The upward axis that the file says, or the usual one of its type.
glm::vec3 up_of(const LoadedMesh& loaded, const std::filesystem::path& file) {
    const bool z = usual_up(file) == UsualUp::z;
    return loaded.up.value_or(z ? glm::vec3{0, 0, 1} : glm::vec3{0, 1, 0});
}

/// Gives each model its upward axis if files disagree about it. Otherwise one axis is guessed for
/// all of them.
void say_up(std::vector<NamedModel>& models, std::span<const std::filesystem::path> files) {
    std::vector<glm::vec3> axes;
    for (std::size_t i = 0; i < files.size(); ++i)
        axes.push_back(up_of(models[i].loaded, files[i]));
    if (std::ranges::adjacent_find(axes, std::not_equal_to{}) == axes.end()) return;
    for (std::size_t i = 0; i < files.size(); ++i) models[i].loaded.up = axes[i];
}

/// The file's name, with a number if other files have the same name.
std::string name_among(std::set<std::string>& names, const std::filesystem::path& file) {
    const std::string usual = file.filename().string();
    std::string name = usual;
    for (int number = 2; !names.insert(name).second; ++number)
        name = fmt::format("{} ({})", usual, number);
    return name;
}

} // namespace

LoadedMesh join_models(std::vector<NamedModel> models) {
    Joining joining{models};
    for (NamedModel& model : models) joining.add(std::move(model));
    return joining.take();
}

LoadedMesh load_models_isolated(std::span<const std::filesystem::path> files,
                                const ReadLimits& limits, const LoadOptions& options) {
    if (files.size() == 1) return load_mesh_isolated(files.front(), limits, options);
    std::set<std::string> names;
    std::vector<NamedModel> models;
    for (const std::filesystem::path& file : files)
        models.push_back({name_among(names, file), load_mesh_isolated(file, limits, options)});
    say_up(models, files);
    return join_models(std::move(models));
}

} // namespace lineatlas
