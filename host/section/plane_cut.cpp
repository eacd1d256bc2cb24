#include "plane_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "parts.hpp"
#include "place_grid.hpp"

namespace lineatlas {
namespace {

class PlaneCutter {
  public:
    PlaneCutter(const Mesh& mesh, const PartNumbers& parts, const PlaneFrame& plane,
                double rounding, const std::vector<bool>& uncut)
        : mesh_(mesh), parts_(parts.of_triangle), part_of_polyline_(parts.of_polyline),
          plane_(plane), uncut_(uncut), places_(place_numbers(mesh.positions, rounding)),
          is_uncut_place_(mesh.positions.size(), false), on_plane_(cut_.mesh.positions, rounding) {
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            if (!uncut[parts_[i]]) continue;
            for (int k = 0; k < 3; ++k) is_uncut_place_[places_[mesh.triangles[i][k]]] = true;
        }
        distances_.reserve(mesh.positions.size());
        for (const std::uint32_t place : places_) {
            const double distance = plane.distance(mesh.positions[place]);
            distances_.push_back(std::abs(distance) <= rounding ? 0 : distance);
        }
        cut_.mesh.positions = mesh.positions;
        cut_.mesh.groups = mesh.groups;
        cut_.mesh.precision = mesh.precision;
        cut_.mesh.surfaces.shapes = mesh.surfaces.shapes;
        cut_.mesh.surfaces.surfaces = mesh.surfaces.surfaces;
    }

    PlaneCut cut() {
        Sides all, cut_parts;
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            const glm::uvec3 given = mesh_.triangles[i];
            const glm::uvec3 corners{places_[given.x], places_[given.y], places_[given.z]};
            const int count = is_beyond(corners.x) + is_beyond(corners.y) + is_beyond(corners.z);
            all.note(count);
            if (!uncut_[parts_[i]]) cut_parts.note(count);
            if (count == 0 || uncut_[parts_[i]]) {
                keep({corner(i, 0), corner(i, 1), corner(i, 2)}, i);
            } else if (count < 3) {
                clip(corners, i);
            }
        }
        for (std::size_t i = 0; i < mesh_.polylines.size(); ++i) clip_polyline(i);
        for (const KnownEdge& edge : mesh_.known_edges) clip_known_edge(edge);
        cut_.mesh.edge_curves = mesh_.edge_curves;
        cut_.mesh.edge_entities = mesh_.edge_entities;
        cut_.misses = !all.both();
        cut_.cuts_none = !cut_parts.both();
        return std::move(cut_);
    }

  private:
    /// The sides of the plane on which triangles are.
    struct Sides {
        bool below = false, above = false;

        /// `beyond`: how many of a triangle's corners are beyond the plane.
        void note(int beyond) {
            below |= beyond < 3;
            above |= beyond > 0;
        }
        bool both() const { return below && above; }
    };

    bool is_beyond(std::uint32_t position) const { return distances_[position] >= 0; }

    /// A corner of a triangle before or after the cut.
    struct Corner {
        std::uint32_t position = 0;
        glm::vec3 normal{0};      ///< from Mesh::corner_normals
        glm::dvec2 parameters{0}; ///< from Mesh::surfaces
    };

    Corner corner(std::uint32_t triangle, int number) const {
        Corner result{.position = places_[mesh_.triangles[triangle][number]]};
        const auto k = static_cast<std::uint32_t>(number);
        if (!mesh_.corner_normals.empty()) result.normal = mesh_.corner_normals[3 * triangle + k];
        if (!mesh_.surfaces.empty()) result.parameters = mesh_.surfaces.parameters[triangle][k];
        return result;
    }

    void keep(const std::array<Corner, 3>& corners, std::uint32_t triangle) {
        const glm::uvec3 positions{corners[0].position, corners[1].position, corners[2].position};
        if (positions.x == positions.y || positions.y == positions.z || positions.z == positions.x)
            return;
        cut_.mesh.triangles.push_back(positions);
        if (!mesh_.corner_normals.empty())
            for (const Corner& each : corners) cut_.mesh.corner_normals.push_back(each.normal);
        if (!mesh_.surfaces.empty())
            cut_.mesh.surfaces.add_triangle(
                mesh_.surfaces.of_triangle[triangle],
                {corners[0].parameters, corners[1].parameters, corners[2].parameters});
        cut_.parts.of_triangle.push_back(parts_[triangle]);
        if (!mesh_.triangle_group.empty())
            cut_.mesh.triangle_group.push_back(mesh_.triangle_group[triangle]);
        if (!mesh_.triangle_object.empty())
            cut_.mesh.triangle_object.push_back(mesh_.triangle_object[triangle]);
    }

    /// The share of an edge between its end below the plane and the plane.
    double share(std::uint32_t below, std::uint32_t beyond) const {
        return distances_[below] / (distances_[below] - distances_[beyond]);
    }

    /// The position where an edge goes through the plane, the same for all triangles that share the
    /// edge.
    std::uint32_t cut_point(std::uint32_t below, std::uint32_t beyond) {
        below = places_[below];
        beyond = places_[beyond];
        const bool is_corner = distances_[beyond] == 0;
        const std::uint64_t key = std::uint64_t{is_corner ? beyond : below} << 32U | beyond;
        const auto entry = points_.emplace(key, beyond);
        std::uint32_t& number = entry.first->second;
        if (const bool is_new = entry.second; !is_new) return number;
        const glm::dvec3 p{mesh_.positions[below]}, q{mesh_.positions[beyond]};
        const glm::vec3 at = is_corner ? mesh_.positions[beyond]
                                       : plane_.placed(glm::mix(p, q, share(below, beyond)));
        bool is_known = false;
        on_plane_.visit(at, [&](std::uint32_t point) {
            number = point;
            return is_known = true;
        });
        if (is_known) return number;
        if (!is_corner) {
            number = static_cast<std::uint32_t>(cut_.mesh.positions.size());
            cut_.mesh.positions.push_back(at);
        }
        on_plane_.add(number);
        return number;
    }

    Corner cut_corner(const Corner& below, const Corner& beyond) {
        Corner result{.position = cut_point(below.position, beyond.position)};
        const double way = share(below.position, beyond.position);
        result.parameters = glm::mix(below.parameters, beyond.parameters, way);
        if (below.normal == glm::vec3{0} || beyond.normal == glm::vec3{0}) return result;
        const glm::vec3 normal = glm::mix(below.normal, beyond.normal, static_cast<float>(way));
        const float length = glm::length(normal);
        if (length > 0) result.normal = normal / length;
        return result;
    }

    void clip(glm::uvec3 corners, std::uint32_t triangle) {
        std::array<Corner, 4> polygon{};
        std::size_t size = 0;
        std::uint32_t out = 0,
                      in = 0; // where the way around the triangle leaves the kept side, and where
                              // it comes back
        for (int i = 0; i < 3; ++i) {
            const Corner p = corner(triangle, i), q = corner(triangle, (i + 1) % 3);
            const bool leaves = is_beyond(q.position);
            if (!is_beyond(p.position)) polygon[size++] = p;
            if (is_beyond(p.position) == leaves) continue;
            const Corner point = leaves ? cut_corner(p, q) : cut_corner(q, p);
            (leaves ? out : in) = point.position;
            polygon[size++] = point;
        }
        const auto first = static_cast<std::uint32_t>(cut_.mesh.triangles.size());
        keep({polygon[0], polygon[1], polygon[2]}, triangle);
        if (size == 4) keep({polygon[0], polygon[2], polygon[3]}, triangle);
        if (out == in) return;
        const std::uint32_t part = parts_[triangle];
        const auto step = static_cast<std::uint32_t>(cut_.steps.size());
        if (!step_of_.emplace(key_of(part, corners), step).second) return;
        // The cut's own face goes the other way along this edge.
        cut_.steps.push_back({in, out, part, first});
        const auto other = step_of_.find(key_of(part, {corners.y, corners.x, corners.z}));
        if (other != step_of_.end())
            cut_.steps[other->second].two_sided = cut_.steps.back().two_sided = true;
    }

    /// A key that is the same for triangles with the same corners in the same sense.
    using TriangleKey = std::array<std::uint32_t, 4>;
    static TriangleKey key_of(std::uint32_t part, glm::uvec3 corners) {
        while (corners.x > corners.y || corners.x > corners.z)
            corners = {corners.y, corners.z, corners.x};
        return {part, corners.x, corners.y, corners.z};
    }

    void clip_polyline(std::size_t index) {
        const std::vector<std::uint32_t>& polyline = mesh_.polylines[index];
        const std::uint32_t owner = part_of_polyline_[index];
        const bool is_uncut = owner != no_part && uncut_[owner];
        std::vector<std::uint32_t> part;
        const auto finish = [&] {
            if (part.size() > 1) {
                cut_.mesh.polylines.push_back(part);
                cut_.parts.of_polyline.push_back(owner);
                if (!mesh_.polyline_kind.empty())
                    cut_.mesh.polyline_kind.push_back(mesh_.polyline_kind[index]);
                if (!mesh_.polyline_object.empty())
                    cut_.mesh.polyline_object.push_back(mesh_.polyline_object[index]);
            }
            part.clear();
        };
        for (std::size_t i = 0; i < polyline.size(); ++i) {
            const std::uint32_t at = polyline[i];
            if (is_uncut) {
                part.push_back(at);
                continue;
            }
            if (i > 0 && is_beyond(at) != is_beyond(polyline[i - 1])) {
                const std::uint32_t before = polyline[i - 1];
                part.push_back(is_beyond(at) ? cut_point(before, at) : cut_point(at, before));
                if (is_beyond(at)) finish();
            }
            if (!is_beyond(at)) part.push_back(at);
        }
        finish();
    }

    void clip_known_edge(KnownEdge edge) {
        edge.from = places_[edge.from];
        edge.to = places_[edge.to];
        if (is_uncut_place_[edge.from] && is_uncut_place_[edge.to]) {
            cut_.mesh.known_edges.push_back(edge);
            return;
        }
        if (is_beyond(edge.from) && is_beyond(edge.to)) return;
        if (is_beyond(edge.to)) edge.to = cut_point(edge.from, edge.to);
        if (is_beyond(edge.from)) edge.from = cut_point(edge.to, edge.from);
        cut_.mesh.known_edges.push_back(edge);
    }

    const Mesh& mesh_;
    const std::vector<std::uint32_t>& parts_; ///< per triangle
    const std::vector<std::uint32_t>& part_of_polyline_;
    const PlaneFrame& plane_;
    const std::vector<bool>& uncut_;
    std::vector<std::uint32_t> places_;
    std::vector<bool> is_uncut_place_; ///< a corner of an uncut part
    std::vector<double> distances_;
    std::unordered_map<std::uint64_t, std::uint32_t> points_;
    std::map<TriangleKey, std::uint32_t> step_of_;
    PlaneCut cut_;
    PlaceGrid on_plane_;
};

} // namespace

PlaneCut cut_by_plane(const Mesh& mesh, const PartNumbers& parts, const PlaneFrame& plane,
                      double rounding, const std::vector<bool>& uncut) {
    return PlaneCutter{mesh, parts, plane, rounding, uncut}.cut();
}

} // namespace lineatlas
