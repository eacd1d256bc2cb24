#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace lineatlas {

/// A box around exact positions, as a file or a program gives them.
struct ExactBounds {
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};

    void add(glm::dvec3 position) {
        min = glm::min(min, position);
        max = glm::max(max, position);
    }
    /// Adds the positions that `used` names, except those that cannot be drawn.
    void add_drawable(std::span<const glm::dvec3> positions, std::span<const std::uint32_t> used);
    /// The longest side of the box; below zero if the box is empty.
    double extent() const;
};

/// The largest coordinate that can be drawn. Floats hold it, and squares of its distance from
/// others.
inline constexpr double largest_drawable = 1e15;
/// The smallest extent of a model. Floats cannot hold the squares of lengths of a smaller one.
inline constexpr double smallest_extent = 1e-20;

bool is_finite(glm::dvec3 position);
bool is_drawable(glm::dvec3 position);

/// The origin to subtract from positions in the box, so that floats can hold the differences: zero
/// if the box lies within thirty times its size from zero, else a point near its middle. No
/// difference to a position that was a float is rounded.
glm::dvec3 origin_for(const ExactBounds& bounds);

/// The note for people about an origin that is not zero.
std::string note_of_origin(glm::dvec3 origin);

/// "1000,0,-20.5"
std::string written(glm::dvec3 position);

} // namespace lineatlas
