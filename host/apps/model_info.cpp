#include "model_info.hpp"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "base/printable.hpp"
#include "core/up_axis.hpp"
#include "io/model_types.hpp"
#include "io/odd_triangles.hpp"
#include "io/part_paths.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/volume.hpp"
#include "style/colors.hpp"

namespace lineatlas::apps {
namespace {

using Json = nlohmann::ordered_json;

/// Names of the values of KnownEdge::Kind that files have.
constexpr std::array edge_names{"sharp", "smooth", "seam", "free", "wire"};

template <class Vector>
Json list(const Vector& v) {
    return {v.x, v.y, v.z};
}

Json box_json(const Bounds& box, glm::dvec3 origin) {
    return {{"min", list(glm::dvec3{box.min} + origin)},
            {"max", list(glm::dvec3{box.max} + origin)}};
}

/// A value rounded to the digits of a float. Further digits of a sum of products mean nothing.
double rounded(double value) {
    return number_from(fmt::format("{:.7g}", value)).value_or(value);
}

/// The materials of a mesh that have a name or a colour, each once.
class Materials {
  public:
    static constexpr std::size_t none = -1;

    explicit Materials(const Mesh& mesh) : of_group_(mesh.groups.size(), none) {
        std::map<std::pair<std::string, std::string>, std::size_t> known;
        for (std::size_t i = 0; i < mesh.groups.size(); ++i) {
            const MeshGroup& group = mesh.groups[i];
            const std::string color = group.color ? hex_color(*group.color) : "";
            if (group.material.empty() && color.empty()) continue;
            const auto [at, is_new] = known.try_emplace({group.material, color}, known.size());
            of_group_[i] = at->second;
            if (is_new)
                list_.push_back({{"name", group.material},
                                 {"color", group.color ? Json(color) : Json(nullptr)}});
        }
        std::vector<std::size_t> triangles(known.size(), 0);
        for (const std::uint32_t group : mesh.triangle_group)
            if (of_group_[group] != none) ++triangles[of_group_[group]];
        for (std::size_t i = 0; i < triangles.size(); ++i) list_[i]["triangles"] = triangles[i];
    }

    /// The place of a triangle's material in the list, or none.
    std::size_t of(const Mesh& mesh, std::size_t triangle) const {
        return mesh.triangle_group.empty() ? none : of_group_[mesh.triangle_group[triangle]];
    }
    const Json& list() const { return list_; }

  private:
    std::vector<std::size_t> of_group_;
    Json list_ = Json::array();
};

/// What a part, or the whole model, consists of.
struct Counts {
    std::size_t triangles = 0, polylines = 0;
    std::set<std::size_t> materials{}; ///< places in Materials::list()
    std::array<std::size_t, edge_names.size()> edges{};
    std::vector<glm::uvec3> corners{}; ///< of the triangles of a part

    void put_into(Json& json, bool knows_edges) const {
        json["triangles"] = triangles;
        if (polylines > 0) json["polylines"] = polylines;
        if (!materials.empty()) json["materials"] = materials;
        if (!knows_edges) return;
        for (std::size_t kind = 0; kind < edges.size(); ++kind)
            json["edges"][edge_names[kind]] = edges[kind];
    }
};

/// Counts per object. Edges of the file count once, however many pieces they have.
std::vector<Counts> count_parts(const LoadedMesh& loaded, const PartPaths& paths,
                                const Materials& materials) {
    const Mesh& mesh = loaded.mesh;
    std::vector<Counts> counts(paths.paths.size());
    std::vector<std::uint32_t> part_of_position(mesh.positions.size(), PartPaths::none);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::uint32_t part = paths.of_triangle[i];
        ++counts[part].triangles;
        counts[part].corners.push_back(mesh.triangles[i]);
        const std::size_t material = materials.of(mesh, i);
        if (material != Materials::none) counts[part].materials.insert(material);
        for (int corner = 0; corner < 3; ++corner)
            part_of_position[mesh.triangles[i][corner]] = part;
    }
    for (std::size_t i = 0; i < paths.of_polyline.size(); ++i) {
        const std::uint32_t part = paths.of_polyline[i];
        if (part == PartPaths::none) continue;
        ++counts[part].polylines;
        for (const std::uint32_t position : mesh.polylines[i]) part_of_position[position] = part;
    }
    std::set<std::uint32_t> known;
    for (const KnownEdge& edge : mesh.known_edges) {
        const std::uint32_t part = part_of_position[edge.from];
        if (part != PartPaths::none && known.insert(edge.edge).second)
            ++counts[part].edges[static_cast<std::size_t>(edge.kind)];
    }
    return counts;
}

/// The volume in cubes of the model's unit; null for an open surface.
Json volume_of(const Mesh& mesh, std::span<const glm::uvec3> triangles) {
    const std::optional<double> volume = enclosed_volume(mesh.positions, triangles);
    return volume ? Json(rounded(*volume)) : Json(nullptr);
}

Json box_of(const Mesh& mesh, std::span<const glm::uvec3> triangles, glm::dvec3 origin) {
    Bounds box;
    for (const glm::uvec3& triangle : triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            box.min = glm::min(box.min, mesh.positions[triangle[corner]]);
            box.max = glm::max(box.max, mesh.positions[triangle[corner]]);
        }
    }
    return box_json(box, origin);
}

void put_into(Json& part, const LoadedMesh& loaded, const Counts& counts) {
    counts.put_into(part, !loaded.mesh.known_edges.empty());
    if (counts.corners.empty()) return;
    part["box"] = box_of(loaded.mesh, counts.corners, loaded.origin);
    part["volume"] = volume_of(loaded.mesh, counts.corners);
}

/// Adds notes about the volume that the triangles enclose, if it is odd.
void add_notes_of_volume(const Json& volume, std::vector<std::string>& notes) {
    if (volume.is_null())
        notes.push_back("the surface is not closed, so it has no volume");
    else if (volume < 0)
        notes.push_back("the surface is turned inside out, so its volume is negative");
}

/// The item number of each path of the model's parts.
std::vector<std::uint32_t> items_of(const LoadedMesh& loaded, const PartPaths& paths) {
    std::vector<std::uint32_t> items(paths.paths.size(), 0);
    std::uint32_t last = 0;
    if (loaded.parts.empty()) {
        for (std::uint32_t& item : items) item = ++last;
        return items;
    }
    std::map<std::uint32_t, std::uint32_t> known; // by shape
    for (const ModelPart& part : loaded.parts) {
        if (part.object >= items.size()) continue;
        const bool is_shared = part.shape != ModelPart::none && known.contains(part.shape);
        items[part.object] = is_shared ? known[part.shape] : ++last;
        if (part.shape != ModelPart::none) known[part.shape] = items[part.object];
    }
    return items;
}

Json parts_of(const LoadedMesh& loaded, const Materials& materials) {
    const PartPaths paths = part_paths(loaded);
    const std::vector<std::uint32_t> items = items_of(loaded, paths);
    const std::vector<Counts> counts = count_parts(loaded, paths, materials);
    Json parts = Json::array();
    if (loaded.parts.empty()) {
        for (std::size_t i = 0; i < paths.paths.size(); ++i) {
            Json part{{"name", paths.paths[i].whole()}, {"parent", nullptr}, {"item", items[i]}};
            put_into(part, loaded, counts[i]);
            parts.push_back(std::move(part));
        }
        return parts;
    }
    for (const ModelPart& each : loaded.parts) {
        Json part{{"name", each.name}, {"parent", nullptr}};
        if (each.parent != ModelPart::none) part["parent"] = each.parent;
        if (each.shape != ModelPart::none) part["shape"] = each.shape;
        if (each.object < items.size()) part["item"] = items[each.object];
        if (each.object < counts.size()) put_into(part, loaded, counts[each.object]);
        parts.push_back(std::move(part));
    }
    return parts;
}

/// "428 sharp, 76 seam"
std::string edges_text(const Json& edges) {
    std::string text;
    for (const auto& [kind, count] : edges.items())
        if (count != 0)
            text +=
                fmt::format("{}{} {}", text.empty() ? "" : ", ", count.get<std::size_t>(), kind);
    return text.empty() ? "none" : text;
}

std::string name_text(const Json& named) {
    constexpr std::size_t longest = 200;
    const auto name = named["name"].get<std::string>();
    return name.empty() ? "-" : printable(name, longest);
}

std::string point_text(const Json& point) {
    return fmt::format("{:.6g},{:.6g},{:.6g}", point[0].get<double>(), point[1].get<double>(),
                       point[2].get<double>());
}

} // namespace

Json describe_model(const std::string& file, const LoadedMesh& loaded, const LineSet& lines) {
    const Mesh& mesh = loaded.mesh;
    Json info{{"file", file}, {"format", loaded.format}, {"unit_mm", nullptr}};
    if (loaded.unit) info["unit_mm"] = *loaded.unit;
    info["up"] = list(loaded.up.value_or(guess_up(mesh, usual_up(file))));
    info["up_is_guessed"] = !loaded.up;
    const Bounds box = bounds_of(mesh);
    info["box"] = box_json(box, loaded.origin);
    info["volume"] = volume_of(mesh, mesh.triangles);
    Counts all{.triangles = mesh.triangles.size(), .polylines = mesh.polylines.size()};
    std::set<std::uint32_t> known;
    for (const KnownEdge& edge : mesh.known_edges)
        if (known.insert(edge.edge).second) ++all.edges[static_cast<std::size_t>(edge.kind)];
    all.put_into(info, !mesh.known_edges.empty());
    for (std::size_t kind = 0; kind < line_kind_names.size(); ++kind)
        info["segments"][std::string{line_kind_names[kind]}] = lines.kind_counts[kind];
    const Materials materials{mesh};
    info["materials"] = materials.list();
    info["parts"] = parts_of(loaded, materials);
    std::vector<std::string> notes = loaded.notes;
    add_notes(lines.odd, notes);
    if (!mesh.triangles.empty()) add_notes_of_volume(info["volume"], notes);
    info["notes"] = notes;
    return info;
}

std::vector<std::uint32_t> item_numbers(const LoadedMesh& loaded) {
    const PartPaths paths = part_paths(loaded);
    const std::vector<std::uint32_t> items = items_of(loaded, paths);
    std::vector<std::uint32_t> result;
    result.reserve(paths.of_triangle.size());
    for (const std::uint32_t part : paths.of_triangle) result.push_back(items[part]);
    return result;
}

std::string to_text(const Json& info) {
    const auto& up = info["up"];
    std::string text = fmt::format(
        "{}: {}, {} triangles, unit {}, up {}{}\nbox {} to {}, volume {}\nsegments: {}\n",
        info["file"].get<std::string>(), info["format"].get<std::string>(),
        info["triangles"].get<std::size_t>(),
        info["unit_mm"].is_null() ? "not said"
                                  : fmt::format("{:.6g} mm", info["unit_mm"].get<double>()),
        point_text(up), info["up_is_guessed"].get<bool>() ? " as it looks" : "",
        point_text(info["box"]["min"]), point_text(info["box"]["max"]),
        info["volume"].is_null() ? "open" : fmt::format("{:.6g}", info["volume"].get<double>()),
        edges_text(info["segments"]));
    if (info.contains("edges")) text += "edges: " + edges_text(info["edges"]) + '\n';
    for (const Json& material : info["materials"])
        text += fmt::format("material {}: {}, {} triangles\n", name_text(material),
                            material["color"].is_null() ? "no colour"
                                                        : material["color"].get<std::string>(),
                            material["triangles"].get<std::size_t>());
    std::vector<std::size_t> levels;
    for (const Json& part : info["parts"]) {
        levels.push_back(part["parent"].is_null() ? 0
                                                  : levels[part["parent"].get<std::size_t>()] + 1);
        text += fmt::format("{:{}}{}", "", 2 * (levels.back() + 1), name_text(part));
        if (part.contains("triangles"))
            text += fmt::format(": {} triangles", part["triangles"].get<std::size_t>());
        if (part.contains("edges")) text += ", edges " + edges_text(part["edges"]);
        text += '\n';
    }
    for (const Json& note : info["notes"])
        text += fmt::format("note: {}\n", note.get<std::string>());
    return text;
}

} // namespace lineatlas::apps
