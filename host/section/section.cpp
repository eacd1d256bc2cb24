#include "lineatlas/section.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "base/name_pattern.hpp"
#include "cut_curves.hpp"
#include "cut_faces.hpp"
#include "hatch_lines.hpp"
#include "lineatlas/error.hpp"
#include "parts.hpp"
#include "plane_cut.hpp"

namespace lineatlas {
namespace {

/// Rounding, as a share of the model's size. Corners nearer than this to a plane lie on it, and
/// corners nearer than this to each other are at one place, because floats are no finer.
constexpr double rounding = 1e-6;
constexpr double usual_spacing = 1.0 / 40; ///< share of the cut's size

double diagonal_of(const Bounds& bounds) {
    return glm::distance(glm::dvec3{bounds.min}, glm::dvec3{bounds.max});
}

/// The size of the model, or its largest coordinate if that is larger, because large coordinates
/// have a large rounding.
double reach_of(const Bounds& bounds) {
    const glm::dvec3 far =
        glm::max(glm::abs(glm::dvec3{bounds.min}), glm::abs(glm::dvec3{bounds.max}));
    return std::max({diagonal_of(bounds), far.x, far.y, far.z});
}

void check(std::span<const SectionPlane> planes, const Hatching& hatching) {
    if (planes.size() > most_sections)
        throw UsageError(fmt::format("sections: {} planes are too many; {} at most", planes.size(),
                                     most_sections));
    for (const SectionPlane& plane : planes) {
        const double length = glm::length(plane.normal);
        if (!(length > 0) || !std::isfinite(length) || !std::isfinite(glm::length(plane.point)))
            throw UsageError(
                "section: its normal must have a direction, and its point must be finite");
    }
    const bool spaced = hatching.spacing >= 0 && std::isfinite(hatching.spacing);
    if (!spaced || !std::isfinite(hatching.angle))
        throw UsageError("hatching: spacing must be from 0 on, and spacing and angle finite");
}

/// The diagonal of the box on the plane around all faces.
double size_of(std::span<const CutFace> faces) {
    glm::dvec2 low{INFINITY}, high{-INFINITY};
    for (const CutFace& face : faces) {
        for (const CutLoop& loop : face.loops) {
            for (const glm::dvec2 point : loop.flat) {
                low = glm::min(low, point);
                high = glm::max(high, point);
            }
        }
    }
    return glm::distance(low, high);
}

std::string name_of(const SectionPlane& plane) {
    if (!plane.name.empty()) return plane.name;
    const auto text = [](glm::dvec3 at) { return fmt::format("{:g},{:g},{:g}", at.x, at.y, at.z); };
    return text(plane.point) + "/" + text(plane.normal);
}

class Sectioner {
  public:
    Sectioner(const Mesh& mesh, const Hatching& hatching, std::span<const std::string> uncut)
        : hatching_(hatching), bounds_(bounds_of(mesh)), rounding_(rounding * reach_of(bounds_)),
          parts_(find_parts(mesh, place_numbers(mesh.positions, rounding_))),
          uncut_(parts_.name.size(), false) {
        for (const std::string& name : uncut) leave_whole(name);
        part_numbers_ = {.of_triangle = parts_.of_triangle, .of_polyline = uncut_lines(mesh)};
        section_.mesh = mesh;
    }

    void cut(const SectionPlane& plane) {
        const PlaneFrame frame{plane.point, plane.normal};
        PlaneCut cut = cut_by_plane(section_.mesh, part_numbers_, frame, rounding_, uncut_);
        if (cut.misses) refuse(plane, frame);
        if (cut.cuts_none)
            throw UsageError(fmt::format("section {} cuts nothing: all parts that it goes through "
                                         "are uncut",
                                         name_of(plane)));
        follow_curves(cut, frame);
        const CutFaces faces = find_faces(cut, frame);
        mesh_ = &cut.mesh;
        part_numbers_ = std::move(cut.parts);
        name_kinds();
        const double whole = size_of(faces.closed);
        for (const CutFace& face : faces.closed) add_face(face, frame, whole);
        for (const CutStep& step : faces.open)
            add_line({step.from, step.to}, PolylineKind::section, step.part, step.triangle);
        if (!faces.gaps.empty()) note(plane, faces.gaps);
        section_.mesh = std::move(cut.mesh);
    }

    Section take() { return std::move(section_); }

  private:
    void leave_whole(const std::string& name) {
        if (name.empty())
            throw UsageError("sections: the name of a part that stays whole must not be empty");
        bool is_known = false;
        for (std::size_t part = 0; part < uncut_.size(); ++part) {
            if (!names_part(name, parts_.name[part])) continue;
            uncut_[part] = is_known = true;
        }
        if (!is_known)
            throw UsageError(fmt::format("sections: no part is called \"{}\"; `lineatlas info` "
                                         "lists the parts",
                                         name));
    }

    /// Per line of the mesh a part of its object, if all parts of the object stay whole.
    std::vector<std::uint32_t> uncut_lines(const Mesh& mesh) const {
        std::vector<std::uint32_t> parts(mesh.polylines.size(), no_part);
        if (mesh.polyline_object.empty() || mesh.triangle_object.empty()) return parts;
        std::map<std::uint32_t, std::uint32_t> part_of_object;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const std::uint32_t part =
                uncut_[parts_.of_triangle[i]] ? parts_.of_triangle[i] : no_part;
            std::uint32_t& one =
                part_of_object.emplace(mesh.triangle_object[i], part).first->second;
            if (part == no_part) one = no_part;
        }
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto found = part_of_object.find(mesh.polyline_object[i]);
            if (found != part_of_object.end()) parts[i] = found->second;
        }
        return parts;
    }

    [[noreturn]] void refuse(const SectionPlane& plane, const PlaneFrame& frame) const {
        double low = INFINITY, high = -INFINITY;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::bvec3 upper{(corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0};
            const double at = frame.distance(glm::mix(bounds_.min, bounds_.max, upper));
            low = std::min(low, at);
            high = std::max(high, at);
        }
        const std::string name = name_of(plane);
        const bool touches = std::abs(low) <= rounding_; // all of it lies on the side cut away
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(frame.normal[axis]) != 1) continue;
            const std::string extent = fmt::format("which goes from {}={:g} to {:g}", "xyz"[axis],
                                                   bounds_.min[axis], bounds_.max[axis]);
            if (!touches)
                throw UsageError(fmt::format("section {} misses the model, {}", name, extent));
            throw UsageError(fmt::format("section {} cuts away all of the model, {}; {}{}={:g} "
                                         "keeps it",
                                         name, extent, frame.normal[axis] > 0 ? '-' : '+',
                                         "xyz"[axis], plane.point[axis]));
        }
        if (touches)
            throw UsageError(fmt::format("section {} cuts away all of the model; the opposite "
                                         "normal keeps it",
                                         name));
        throw UsageError(
            fmt::format("section {} misses the model, which lies from {:g} to {:g} along "
                        "its normal, seen from its point",
                        name, low, high));
    }

    void name_kinds() { mesh_->polyline_kind.resize(mesh_->polylines.size(), PolylineKind::file); }

    /// Adds a line of a part. `triangle`: one of the part.
    void add_line(std::vector<std::uint32_t> line, PolylineKind kind, std::uint32_t part,
                  std::uint32_t triangle) {
        mesh_->polylines.push_back(std::move(line));
        part_numbers_.of_polyline.push_back(part);
        mesh_->polyline_kind.push_back(kind);
        if (!mesh_->polyline_object.empty() && !mesh_->triangle_object.empty())
            mesh_->polyline_object.push_back(mesh_->triangle_object[triangle]);
    }

    /// Adds the triangles and the hatching of a face. `whole`: the size of all of the cut.
    void add_face(const CutFace& face, const PlaneFrame& frame, double whole) {
        Mesh& mesh = *mesh_;
        for (const glm::uvec3 triangle : face_triangles(face, mesh.positions)) {
            mesh.triangles.push_back(triangle);
            part_numbers_.of_triangle.push_back(face.part);
            if (!mesh.triangle_group.empty())
                mesh.triangle_group.push_back(mesh.triangle_group[face.triangle]);
            if (!mesh.triangle_object.empty())
                mesh.triangle_object.push_back(mesh.triangle_object[face.triangle]);
            if (!mesh.corner_normals.empty())
                mesh.corner_normals.insert(mesh.corner_normals.end(), 3, glm::vec3{0});
            if (!mesh.surfaces.empty()) mesh.surfaces.add_triangle(KnownSurfaces::none, {});
        }
        for (const CutLoop& loop : face.loops) {
            std::vector<std::uint32_t> line = loop.points;
            line.push_back(line.front());
            add_line(std::move(line), PolylineKind::section, face.part, face.triangle);
        }
        if (hatching_.none) return;
        const std::size_t number =
            numbers_.emplace(parts_.look[face.part], numbers_.size()).first->second;
        const double angle = hatch_angle(hatching_.angle, number);
        // Lines of small parts are closer than those of large parts, but by less than their sizes
        // differ.
        const double usual = usual_spacing * std::sqrt(whole * size_of(std::span{&face, 1}));
        const double spacing = hatching_.spacing > 0 ? hatching_.spacing : usual;
        for (const auto& [from, to] : hatch_lines(face, spacing, angle)) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.push_back(frame.space(from));
            mesh.positions.push_back(frame.space(to));
            add_line({first, first + 1}, PolylineKind::hatching, face.part, face.triangle);
        }
    }

    /// Writes a note that names the first gap, because there may be hundreds.
    void note(const SectionPlane& plane, const std::vector<CutFaces::Gap>& gaps) {
        const CutFaces::Gap& gap = gaps.front();
        const std::string& part = parts_.name[gap.part];
        std::string text =
            fmt::format("section {}: the cut{} does not close, at {:g},{:g},{:g}", name_of(plane),
                        part.empty() ? "" : " of \"" + part + "\"", gap.at.x, gap.at.y, gap.at.z);
        if (gap.count > 1) text += fmt::format(" and {} more places", gap.count - 1);
        if (gaps.size() > 1) text += fmt::format(", nor do {} other parts", gaps.size() - 1);
        section_.notes.push_back(text + "; left open");
    }

    Hatching hatching_;
    Bounds bounds_;
    double rounding_; ///< in the model's unit
    Parts parts_;
    PartNumbers part_numbers_;                     ///< of the mesh as it is cut so far
    std::vector<bool> uncut_;                      ///< per part whether it stays whole
    std::map<std::uint32_t, std::size_t> numbers_; ///< numbers of looks, in the order in which they
                                                   ///< are met
    Mesh* mesh_ = nullptr;                         ///< the mesh that is being closed
    Section section_;
};

} // namespace

Section cut_mesh(const Mesh& mesh, std::span<const SectionPlane> planes, const Hatching& hatching,
                 std::span<const std::string> uncut) {
    check(planes, hatching);
    Sectioner sectioner{mesh, hatching, uncut};
    for (const SectionPlane& plane : planes) sectioner.cut(plane);
    return sectioner.take();
}

} // namespace lineatlas
