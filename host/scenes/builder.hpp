#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas::scenes {

using Group = std::uint32_t;
using Outline = std::vector<glm::vec2>;
using Path = std::vector<glm::vec3>;

/// The distance between neighbouring parts, so that both keep their edges. Two parts that touch
/// would fight for the same pixels, and two that pass through each other would show no line where
/// they meet.
constexpr float gap = 0.004F;

/// The faces of a box; a box that misses some is open there.
enum Faces : unsigned {
    minus_x = 1,
    plus_x = 2,
    minus_y = 4,
    plus_y = 8,
    minus_z = 16,
    plus_z = 32,
    all_faces = 63,
    open_below = all_faces & ~minus_y,
};

// Placement.
glm::mat4 move(glm::vec3 by);
glm::mat4 turn(float radians, glm::vec3 axis = {0, 1, 0});
/// Puts the x-y plane of an outline on the ground: (x, y, z) becomes (x, z, -y).
glm::mat4 lay_flat();
/// Maps the y axis onto the line from `from` to `to`, keeping lengths.
glm::mat4 along(glm::vec3 from, glm::vec3 to);

/// A number in [0, 1) that depends only on the arguments. It is the same on all platforms, unlike
/// the distributions of <random>.
float hash01(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0);

Outline rectangle(glm::vec2 lo, glm::vec2 hi);
Outline circle(glm::vec2 centre, float radius, int segments, float phase = 0);
/// A rounded rectangle, counter-clockwise, with `segments` per corner.
Outline rounded_rectangle(glm::vec2 lo, glm::vec2 hi, float radius, int segments);

/// Triangles of a polygon with holes, as indices into outline followed by the holes in order. The
/// outline is counter-clockwise, the holes either way round.
std::vector<glm::uvec3> triangulate(const Outline& outline, std::span<const Outline> holes);

/// Collects the parts of a scene. Vertices are shared inside a part and never between parts.
/// Every part takes a transform and a group, and is counter-clockwise from outside.
class MeshBuilder {
  public:
    Group group(std::string object, std::string material, glm::vec3 color);
    std::size_t triangle_count() const { return m_mesh.triangles.size(); }
    Mesh take();

    /// What is built while it lives is an object of its own, which may be moved; the rest is object
    /// 0. They nest.
    class OwnObject {
      public:
        explicit OwnObject(MeshBuilder& b) : m_builder(b), m_around(b.m_object) {
            b.m_object = ++b.m_last_object;
        }
        ~OwnObject() { m_builder.m_object = m_around; }
        OwnObject(const OwnObject&) = delete;
        OwnObject& operator=(const OwnObject&) = delete;

      private:
        MeshBuilder& m_builder;
        std::uint32_t m_around;
    };

    // Raw access, for shapes that are no standard part.
    std::uint32_t vertex(glm::vec3 position);
    glm::vec3 position(std::uint32_t index) const { return m_mesh.positions[index]; }
    /// Leaves out triangles that have no area (the poles of grids).
    void triangle(Group g, std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void quad(Group g, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
    std::vector<std::uint32_t> ring(const glm::mat4& at, std::span<const glm::vec3> points);
    /// The band between two polylines of vertices, which need not have equally many: each step
    /// takes the shorter diagonal. Seen from outside `a` runs to the right with `b` above it.
    void loft(Group g, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b,
              bool closed);

    // Parts.
    void box(const glm::mat4& at, Group g, glm::vec3 lo, glm::vec3 hi, unsigned faces = all_faces);
    void open_quad(const glm::mat4& at, Group g, glm::vec3 a, glm::vec3 b, glm::vec3 c,
                   glm::vec3 d);
    /// A prism of `outline` in the x-y plane, extruded from z0 to z1.
    void prism(const glm::mat4& at, Group g, const Outline& outline, float z0, float z1,
               std::span<const Outline> holes = {});
    /// A surface of `profile` (radius, height) turned about the y axis, from bottom to top for an
    /// outside surface. A radius of 0 makes a tip. `staggered` turns every other ring by half a
    /// step.
    void lathe(const glm::mat4& at, Group g, std::span<const glm::vec2> profile, int segments,
               bool staggered = false);
    /// A round bar with flat ends.
    void rod(Group g, glm::vec3 from, glm::vec3 to, float radius, int segments, bool capped = true);
    /// A bent round bar.
    void tube(const glm::mat4& at, Group g, std::span<const glm::vec3> path, float radius,
              int segments, bool closed = false);
    /// A rope, triangular so that it stays two or three lines however near it is seen.
    void rope(Group g, glm::vec3 from, glm::vec3 to, float radius, int lengths, float sag = 0);
    /// A surface over [0, 1]^2; its front side is where du x dv points.
    void panel(const glm::mat4& at, Group g, int nu, int nv,
               const std::function<glm::vec3(float, float)>& surface);
    /// As panel(), with a group per row in v, for a material line between rows.
    void patch(const glm::mat4& at, int nu, int nv,
               const std::function<glm::vec3(float, float)>& surface,
               const std::function<Group(int)>& group_of_row);
    /// The band between two polylines of equal length (a plank, a cloth of a sail).
    void strip(const glm::mat4& at, Group g, std::span<const glm::vec3> lower,
               std::span<const glm::vec3> upper);

  private:
    Mesh m_mesh;
    std::uint32_t m_object = 0, m_last_object = 0;
};

} // namespace lineatlas::scenes
