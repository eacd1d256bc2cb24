#include "parts.hpp"

#include <algorithm>
#include <iterator>

#include <glm/common.hpp>

#include "base/name_pattern.hpp"
#include "cuts.hpp"

namespace lineatlas::viewer {
namespace {

/// The name that is shown for a part without a name.
constexpr const char* unnamed = "(no name)";
/// A possible end of the pattern of a part that contains others.
constexpr std::string_view all_within = "/*";

/// Each part followed by those in it.
std::vector<std::uint32_t> order_of_tree(const std::vector<ModelPart>& parts) {
    std::vector<std::vector<std::uint32_t>> held(parts.size());
    std::vector<std::uint32_t> order, left;
    for (auto i = static_cast<std::uint32_t>(parts.size()); i-- > 0;)
        (parts[i].parent == ModelPart::none ? left : held[parts[i].parent]).push_back(i);
    while (!left.empty()) {
        order.push_back(left.back());
        left.pop_back();
        std::ranges::copy(held[order.back()], std::back_inserter(left));
    }
    return order;
}

} // namespace

std::string literal_pattern(const std::string& name) {
    std::string pattern;
    for (const char letter : name) {
        if (std::string_view{"*?[\\"}.find(letter) != std::string_view::npos) pattern += '\\';
        pattern += letter;
    }
    return pattern;
}

Parts::Parts(const LoadedMesh& loaded) : paths_(part_paths(loaded)) {
    if (paths_.paths.size() < 2) return;
    part_of_path_.assign(paths_.paths.size(), none);
    if (loaded.parts.empty()) {
        for (std::uint32_t i = 0; i < paths_.paths.size(); ++i) {
            part_of_path_[i] = i;
            all_.push_back({.name = paths_.paths[i].whole(), .bounds = {}});
        }
    } else {
        std::vector<std::uint32_t> place(loaded.parts.size(), none);
        for (const std::uint32_t i : order_of_tree(loaded.parts)) {
            const ModelPart& part = loaded.parts[i];
            place[i] = static_cast<std::uint32_t>(all_.size());
            all_.push_back({.name = part.name, .bounds = {}});
            if (part.object < part_of_path_.size()) part_of_path_[part.object] = place[i];
            if (part.parent == ModelPart::none) continue;
            Part& whole = all_[place[part.parent]];
            whole.holds_others = true;
            all_.back().parent = place[part.parent];
            all_.back().depth = whole.depth + 1;
        }
    }
    for (Part& part : all_)
        if (part.name.empty()) part.name = unnamed;
    const Mesh& mesh = loaded.mesh;
    objects_of_path_.resize(paths_.paths.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!mesh.triangle_group.empty())
            objects_of_path_[paths_.of_triangle[i]].insert(
                mesh.groups[mesh.triangle_group[i]].object);
        for (std::uint32_t part = part_of_path_[paths_.of_triangle[i]]; part != none;
             part = all_[part].parent) {
            Bounds& bounds = all_[part].bounds;
            for (int corner = 0; corner < 3; ++corner) {
                const glm::vec3 at = mesh.positions[mesh.triangles[i][corner]];
                bounds = {glm::min(bounds.min, at), glm::max(bounds.max, at)};
            }
        }
    }
}

std::vector<std::string> Parts::objects_of(std::uint32_t part) const {
    std::set<std::string> objects;
    for (std::size_t path = 0; path < part_of_path_.size(); ++path)
        if (is_in(part_of_path_[path], part))
            objects.insert(objects_of_path_[path].begin(), objects_of_path_[path].end());
    return {objects.begin(), objects.end()};
}

std::string Parts::path_of(std::uint32_t part) const {
    const std::uint32_t parent = all_[part].parent;
    return (parent == none ? "" : path_of(parent) + "/") + all_[part].name;
}

bool Parts::is_in(std::uint32_t part, std::uint32_t whole) const {
    while (part != none && part != whole) part = all_[part].parent;
    return part == whole;
}

bool Parts::is_among(std::uint32_t part, const PartNumbers& parts) const {
    for (; part != none; part = all_[part].parent)
        if (parts.contains(part)) return true;
    return false;
}

ShownParts Parts::alone(const PartNumbers& parts, const ShownParts& before) const {
    ShownParts shown{.only = parts};
    for (const std::uint32_t hidden : before.hidden)
        if (is_among(hidden, parts) && !parts.contains(hidden)) shown.hidden.insert(hidden);
    return shown;
}

std::vector<bool> Parts::shown_paths(const ShownParts& shown) const {
    std::vector<bool> paths;
    for (const std::uint32_t part : part_of_path_)
        paths.push_back(part == none ? shown.only.empty() : is_shown(part, shown));
    return paths;
}

Mesh Parts::shown(const Mesh& mesh, const ShownParts& shown) const {
    Mesh result = mesh;
    if (!all_.empty() && shown != ShownParts{})
        keep_parts(result, paths_, shown_paths(shown), shown.only.empty());
    return result;
}

std::optional<std::uint32_t> Parts::pick(const Mesh& mesh, const Ray& ray, const ShownParts& parts,
                                         std::span<const SectionPlane> planes) const {
    if (all_.empty()) return {};
    const std::vector<bool> shown = shown_paths(parts);
    const auto hit = first_hit(ray, mesh.positions, mesh.triangles, [&](const RayHit& at) {
        return shown[paths_.of_triangle[at.triangle]] && !is_cut_away(ray.at(at.distance), planes);
    });
    if (!hit) return {};
    const std::uint32_t part = part_of_path_[paths_.of_triangle[hit->triangle]];
    return part != none ? std::optional{part} : std::nullopt;
}

std::string Parts::pattern_of(std::uint32_t part) const {
    return literal_pattern(path_of(part));
}

PartNumbers Parts::matching(std::span<const std::string> patterns,
                            std::vector<std::string>& unknown) const {
    PartNumbers found;
    for (std::string pattern : patterns) {
        const std::string given = pattern;
        // The pattern first means the part itself, then the parts in it.
        if (pattern.ends_with(all_within)) pattern.resize(pattern.size() - all_within.size());
        bool any = false;
        for (std::uint32_t part = 0; part < all_.size(); ++part) {
            if (!matches(pattern, path_of(part)) && !matches(pattern, all_[part].name)) continue;
            any = true;
            if (!is_among(part, found)) found.insert(part);
        }
        if (!any) unknown.push_back(given);
    }
    return found;
}

} // namespace lineatlas::viewer
