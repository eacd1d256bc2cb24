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

/// What a row of the table is measured on.
struct Subject {
    std::string name;
    LineSet lines;
    LineKindMask kinds; ///< drawn
    std::vector<Viewpoint> viewpoints;
    /// Called before each frame: moves what moves.
    std::function<void(Renderer& renderer, std::size_t frame)> animate{};
};

/// A scene, its fixed lines only; with silhouettes if the name ends in "+s".
Subject scene_subject(const std::string& name, glm::ivec2 size, std::size_t frames);

/// A mesh from a file, seen on an orbit that frames it: its fixed lines, or silhouettes as well.
Subject model_subject(const std::filesystem::path& path, glm::vec3 up, bool silhouettes,
                      glm::ivec2 size, std::size_t frames);

/// These kinds of lines of a mesh, on an orbit that frames it.
Subject orbit_subject(const std::string& name, const Mesh& mesh, LineKindMask kinds, glm::vec3 up,
                      glm::ivec2 size, std::size_t frames);

/// What hidden segments cost. `once` is the ship before a wall. `thrice` is the same picture, with
/// two more ships behind the wall, enlarged about the eye so that each segment of theirs covers the
/// very pixels, and takes as many samples, as its original. The camera turns on the spot, so this
/// holds in every frame.
std::vector<Subject> hidden_subjects(glm::ivec2 size, std::size_t frames);

/// What a model costs that is far away, all its lines in few pixels: the ship on an orbit that
/// frames it, and from 20 times as far.
std::vector<Subject> far_subjects(glm::ivec2 size, std::size_t frames);

/// What changes cost: the office as it is, with 500 pieces of furniture that sway and turn in every
/// frame, and with half of its objects hidden in every other frame; a cloth of 45,000 triangles
/// with its silhouettes, at rest and in waves.
std::vector<Subject> moving_subjects(glm::ivec2 size, std::size_t frames);

} // namespace lineatlas::bench
