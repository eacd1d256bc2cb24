#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The places of a model's objects, and how far they move on the screen, as far as the host knows
/// without the vertices.
class SceneMotion {
  public:
    explicit SceneMotion(const LineSet& lines);

    /// These three throw UsageError and change nothing, see Renderer.
    void set_transforms(std::span<const glm::mat4> world_from_object);
    void set_positions(std::uint32_t first, std::span<const glm::vec3> positions);
    void set_hidden(std::span<const std::uint32_t> objects);
    /// Replaces an object by another, shown and where it was made, or by none. `number` may be that
    /// of the next object.
    void set_object(std::uint32_t number, const LineSet& lines, const Bounds& box);

    std::span<const LineObject> objects() const { return objects_; }
    std::uint32_t vertex_count() const { return vertex_count_; }
    /// A matrix per object. The matrix of a hidden object takes all of it to one point far away,
    /// where its triangles cover nothing and its lines are points (kernels/project_clip.cl).
    const std::vector<glm::mat4>& transforms() const { return shown_; }
    /// Bounds of the whole model at its current places, hidden objects included.
    const Bounds& bounds() const { return bounds_; }
    /// Counts changes of positions and of hidden objects. Frames before and after such a change are
    /// not averaged.
    std::uint64_t shape_version() const { return shape_version_; }

    /// How far points of the model have moved on the screen: the median, in pixels; infinite if
    /// none can be seen in both pictures.
    float typical_motion(const Camera& from, std::span<const glm::mat4> transforms_from,
                         const Camera& to) const;
    /// Per object 1 if its own motion on the screen is more than `most_pixels`; empty if no object
    /// has moved so far.
    std::vector<std::uint8_t> jumped(std::span<const glm::mat4> transforms_from, const Camera& to,
                                     float most_pixels) const;

  private:
    /// One of the vertices by which the motion of a picture is judged.
    struct Landmark {
        std::uint32_t vertex, object;
        glm::vec3 position;
    };
    void update();
    /// Takes some of an object's vertices as landmarks, as far apart in the list as those of other
    /// objects.
    void add_landmarks(std::uint32_t object, std::span<const glm::vec3> vertices);

    std::vector<LineObject> objects_; ///< one if nothing moves on its own
    std::uint32_t vertex_count_;
    std::vector<Bounds> boxes_; ///< per object, as it was made
    std::vector<glm::mat4> transforms_;
    std::vector<std::uint8_t> hidden_; ///< per object 0 or 1
    std::vector<glm::mat4> shown_;     ///< transforms()
    glm::mat4 away_;                   ///< the matrix of hidden objects
    std::vector<Landmark> landmarks_;
    std::size_t between_landmarks_ = 1, next_landmark_ = 0; ///< vertices
    Bounds bounds_;
    std::uint64_t shape_version_ = 0;
};

} // namespace lineatlas
