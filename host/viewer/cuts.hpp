#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/section.hpp"
#include "navigation.hpp"

namespace lineatlas::viewer {

/// A plane that cuts the model.
struct Cut {
    glm::dvec3 normal{1, 0, 0}; ///< unit vector; what lies on the side that it points to is gone
    double at = 0; ///< the plane's distance from zero along it, in the file's coordinates
    bool on = true;

    bool operator==(const Cut&) const = default;
};

/// 0 to 2 where the plane lies across an axis.
std::optional<int> axis_of(const Cut& cut);
/// The same plane; the other side is gone.
Cut flipped(const Cut& cut);

/// As in `lineatlas draw --section`.
std::string text_of(const Cut& cut);
/// `bounds`: of the model, `origin`: of these, in the file's coordinates. A plane without a side
/// takes what lies along its axis. Throws UsageError.
Cut cut_from(std::string_view text, const Bounds& bounds, glm::dvec3 origin);

/// The least and the largest `Cut::at` at which a plane of that normal meets the model.
struct Reach {
    double low = 0, high = 0;
};
Reach reach_along(glm::dvec3 normal, const Bounds& bounds, glm::dvec3 origin);

/// Where the plane passes the middle of the model; there the view has its handle.
glm::dvec3 middle_of(const Cut& cut, const Bounds& bounds, glm::dvec3 origin);
/// A rectangle in the plane, about the model.
std::array<glm::dvec3, 4> outline_of(const Cut& cut, const Bounds& bounds, glm::dvec3 origin);
/// How far a point of the line through `handle` along `normal` goes that is dragged from one ray to
/// another; 0 for a line that is looked along.
double way_along(glm::dvec3 normal, glm::dvec3 handle, const Ray& from, const Ray& to);

/// What the cuts leave of a mesh. One that would take nothing or all of it is left out, with a
/// note.
struct CutMesh {
    Mesh mesh;
    std::vector<SectionPlane> planes; ///< that cut it, as the tool would take them
    std::vector<std::string> notes;
};
CutMesh apply_cuts(Mesh mesh, const std::vector<Cut>& cuts, glm::dvec3 origin);

/// Whether planes have taken the point away.
bool is_cut_away(glm::dvec3 point, std::span<const SectionPlane> planes);

} // namespace lineatlas::viewer
