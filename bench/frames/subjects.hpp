#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/lines.hpp"
#include "measure.hpp"

namespace lineatlas::bench {

/// The lines and views that a row of the table is measured on.
struct Subject {
    std::string name;
    LineSet lines;
    LineKindMask kinds; ///< drawn
    std::vector<Viewpoint> viewpoints;
    /// Called before each frame. Moves or changes the model.
    std::function<void(Renderer& renderer, std::size_t frame)> animate{};
};

/// A built-in scene with its fixed lines; with silhouettes too if the name ends in "+s".
Subject scene_subject(const std::string& name, glm::ivec2 size, std::size_t frames);

/// A mesh from a file with its fixed lines, on an orbit that frames it; with silhouettes too if
/// `silhouettes`.
Subject model_subject(const std::filesystem::path& path, glm::vec3 up, bool silhouettes,
                      glm::ivec2 size, std::size_t frames);

/// These kinds of lines of a mesh, on an orbit that frames it.
Subject orbit_subject(const std::string& name, const Mesh& mesh, LineKindMask kinds, glm::vec3 up,
                      glm::ivec2 size, std::size_t frames);

/// Two subjects for the cost of hidden segments. The first is the ship before a wall. The second
/// has two more ships behind the wall. These are enlarged about the eye, so that each of their
/// segments covers the same pixels, and has as many samples, as the original segment. The camera
/// turns on the spot, so this holds in every frame.
std::vector<Subject> hidden_subjects(glm::ivec2 size, std::size_t frames);

/// Two subjects for the cost of a distant model, with all its lines in few pixels: the ship on an
/// orbit that frames it, and from 20 times as far.
std::vector<Subject> far_subjects(glm::ivec2 size, std::size_t frames);

/// Subjects for the cost of changes. Of the office: at rest; with 500 objects that sway and turn in
/// every frame; with every second object hidden in every second frame; with a clevis that is added
/// and removed by turns. Of a cloth of 45,000 triangles with silhouettes: at rest and in waves.
std::vector<Subject> moving_subjects(glm::ivec2 size, std::size_t frames);

} // namespace lineatlas::bench
