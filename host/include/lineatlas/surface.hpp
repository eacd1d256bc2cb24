#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "lineatlas/export.hpp"

/// @file
/// Surfaces of exact geometry, as files of STEP, IGES and BREP have them.
/// @code{.cpp}
/// KnownSurfaces known; // a cylinder of radius 1 about z
/// known.shapes.push_back({.axis = {0, 0, 1}, .curve = {.point = {1, 0, 0}, .u = {0, 0, 1}}});
/// known.surfaces.push_back({.shape = 0});
/// @endcode

namespace lineatlas {

/// Degree and knots of a B-spline in one direction.
struct SplineDirection {
    std::uint32_t degree = 0;    ///< 1 to most_degree
    std::vector<double> knots{}; ///< ascending, repeated by multiplicity: degree + 1 + poles
                                 ///< numbers

    static constexpr std::uint32_t most_degree = 25; ///< the highest degree that CAD programs write

    /// The number of poles.
    std::uint32_t poles() const { return static_cast<std::uint32_t>(knots.size()) - degree - 1; }
};

/// A curve that a surface is made of.
struct SurfaceCurve {
    /// What a SurfaceCurve is.
    enum class Kind : std::uint32_t {
        line,    ///< point + t u
        ellipse, ///< point + cos(t) u + sin(t) v
        spline,  ///< a B-spline, rational where weights differ
    };
    Kind kind = Kind::line;          ///< which of the members below define the curve
    glm::dvec3 point{0};             ///< of a line or an ellipse
    glm::dvec3 u{0};                 ///< of a line or an ellipse
    glm::dvec3 v{0};                 ///< of an ellipse
    SplineDirection along{};         ///< of a spline
    std::vector<glm::dvec4> poles{}; ///< of a spline: x, y, z times the weight, and the weight
};

/// A surface of exact geometry, by two parameters u and v.
struct SurfaceShape {
    /// What a SurfaceShape is.
    enum class Kind : std::uint32_t {
        revolution, ///< the curve at v, turned by u about the axis: cylinders, cones, spheres, tori
        extrusion,  ///< the curve at u, and v times the axis beyond
        spline,     ///< a net of poles, rational where weights differ
    };
    Kind kind = Kind::revolution;    ///< which of the members below define the surface
    glm::dvec3 point{0};             ///< of a revolution, on the axis
    glm::dvec3 axis{0};              ///< direction of a revolution (a unit vector) or of an
                                     ///< extrusion
    SurfaceCurve curve{};            ///< of a revolution or an extrusion
    SplineDirection along_u{};       ///< of a spline
    SplineDirection along_v{};       ///< of a spline
    std::vector<glm::dvec4> poles{}; ///< of a spline, as SurfaceCurve::poles, along v first
    double offset = 0;               ///< distance of the surface from all of that, towards du x dv
};

/// The surface of a face.
struct PlacedSurface {
    std::uint32_t shape = 0;  ///< index into KnownSurfaces::shapes
    std::uint32_t entity = 0; ///< number of the face in the file, as #12 of STEP; 0: not known
    bool turned = false;      ///< du x dv points inwards
    glm::dmat4x3 model_from_shape{glm::dmat4{1.0}}; ///< the place of the shape in the model
};

/// The surfaces that curved triangles approximate, as a file of exact geometry has them.
struct KnownSurfaces {
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< of a triangle that has none

    std::vector<SurfaceShape> shapes;       ///< each once, even if several faces have it
    std::vector<PlacedSurface> surfaces;    ///< of faces
    std::vector<std::uint32_t> of_triangle; ///< index into `surfaces` or `none`; or empty
    /// Per triangle u and v of its three corners; zero where it has no surface.
    std::vector<std::array<glm::dvec2, 3>> parameters;

    /// Adds the surface and the parameters of one more triangle.
    void add_triangle(std::uint32_t surface, const std::array<glm::dvec2, 3>& corners) {
        of_triangle.push_back(surface);
        parameters.push_back(corners);
    }
    bool empty() const { return of_triangle.empty(); } ///< no triangle has one
};

/// True if `known` is consistent and fits a mesh of so many triangles: indices are in range, tables
/// of splines fit each other, knots ascend, weights are above 0, and all numbers are finite.
LINEATLAS_API bool is_sound(const KnownSurfaces& known, std::size_t triangles);

} // namespace lineatlas
