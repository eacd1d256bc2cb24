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
    glm::dvec3 normal{1, 0, 0}; ///< unit vector; the part of the model on the side that it points
                                ///< to is gone
    double at = 0; ///< the plane's distance from zero along it, in the file's coordinates
    bool on = true;

    bool operator==(const Cut&) const = default;
};

/// The axis, 0 to 2, that the plane lies across; nothing for other planes.
std::optional<int> axis_of(const Cut& cut);
/// The same plane with the other side gone.
Cut flipped(const Cut& cut);

/// The cut as `lineatlas draw --section` takes it.
std::string text_of(const Cut& cut);
/// The cut of such a text. `bounds`: those of the model. `origin`: their origin in the file's
/// coordinates. A plane without a side takes away the side that its axis points to. Throws
/// UsageError.
Cut cut_from(std::string_view text, const Bounds& bounds, glm::dvec3 origin);

/// The least and the largest `Cut::at` at which a plane of one normal meets the model.
struct Reach {
    double low = 0, high = 0;
};
Reach reach_along(glm::dvec3 normal, const Bounds& bounds, glm::dvec3 origin);

/// The point of the plane nearest to the middle of the model, where the view has its handle.
glm::dvec3 middle_of(const Cut& cut, const Bounds& bounds, glm::dvec3 origin);
/// A rectangle in the plane, about the model.
std::array<glm::dvec3, 4> outline_of(const Cut& cut, const Bounds& bounds, glm::dvec3 origin);
/// How far a point on the line through `handle` along `normal` moves if it is dragged from one ray
/// to another. 0 for a line that is seen end on.
double way_along(glm::dvec3 normal, glm::dvec3 handle, const Ray& from, const Ray& to);

/// The part of a mesh that cuts leave. A cut that would take nothing or everything is left out,
/// with a note.
struct CutMesh {
    Mesh mesh;
    std::vector<SectionPlane> planes; ///< the planes of the cuts, as the tool takes them
    std::vector<std::string> notes;
};
CutMesh apply_cuts(Mesh mesh, const std::vector<Cut>& cuts, glm::dvec3 origin);

/// Whether planes have taken the point away.
bool is_cut_away(glm::dvec3 point, std::span<const SectionPlane> planes);

} // namespace lineatlas::viewer
