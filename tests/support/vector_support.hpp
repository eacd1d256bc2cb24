#pragma once

// Intervals and drawings of known shape, for the tests of host/vector.

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas::test {

/// A camera for which x and y of the model are pixels (y up) and z is the depth from 0 to 1.
Camera flat_camera(glm::ivec2 size = {200, 100});

/// A line set made by hand, path by path.
class Lines {
  public:
    /// Adds a path through points. Equal points are one vertex.
    void add(LineKind kind, const std::vector<glm::vec3>& points, bool closed = false);

    LineSet set;

  private:
    std::uint32_t vertex(glm::vec3 point);
};

/// Makes intervals as the readback does.
class Cuts {
  public:
    Cuts(const LineSet& lines, const Camera& camera);

    /// Adds a part of a segment. Its ends get fitting kinds: at 0 and 1 those of the path's
    /// vertices.
    void add(std::uint32_t segment, float from, float to, bool visible);
    /// Adds every segment, whole and visible.
    void add_all();

    std::vector<Interval> intervals;

  private:
    struct Place {
        glm::dvec2 window;
        double depth;
        glm::dvec3 world;
    };
    Place place(const Segment& segment, double share) const;
    std::uint32_t end_kind(const Segment& segment, float share) const;

    const LineSet& lines_;
    Camera camera_;
    std::vector<double> start_arcs_; ///< per segment
    std::vector<double> lengths_;
};

/// The longest span, in pixels, of any path along another one or along another part of itself:
/// within a quarter of a pixel of it and almost parallel.
double longest_overlap(const std::vector<VectorPath>& paths);

/// Length of all paths together.
double total_length(const std::vector<VectorPath>& paths);

/// Promises about paths that the drawing breaks, one a line; empty if there are none.
std::string flaws_of(const VectorDrawing& drawing);

} // namespace lineatlas::test
