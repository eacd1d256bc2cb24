#pragma once

#include <span>
#include <string>
#include <vector>

#include "parts.hpp"
#include "plane_cut.hpp"

namespace lineatlas {

/// A closed way around solid material, or around a hole in it.
struct CutLoop {
    std::vector<std::uint32_t> points; ///< positions, each once
    std::vector<glm::dvec2> flat;      ///< the same on the plane
    double area = 0;                   ///< above 0: counter-clockwise

    bool holds(glm::dvec2 at) const;
};

/// The face of one part where a plane cuts it, of outlines one within the other.
struct CutFace {
    std::uint32_t part;
    std::uint32_t triangle; ///< one beside the face
    std::vector<CutLoop> loops;
};

struct CutFaces {
    std::vector<CutFace> closed;
    std::vector<CutStep> open; ///< steps of parts whose cut does not close
    struct Gap {
        std::uint32_t part;
        glm::vec3 at; ///< one of the ends of the gap
        std::size_t count;
    };
    std::vector<Gap> gaps; ///< per part
};

/// Joins the steps of a cut to faces. A hollow that is connected to nothing belongs to the part
/// around it.
CutFaces find_faces(const PlaneCut& cut, const PlaneFrame& plane);

/// The triangles of a face, towards the plane's normal.
std::vector<glm::uvec3> face_triangles(const CutFace& face,
                                       const std::vector<glm::vec3>& positions);

} // namespace lineatlas
