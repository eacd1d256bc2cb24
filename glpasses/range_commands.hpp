#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/limits.hpp"
#include "objects.hpp"

namespace lineatlas::gl {

/// A piece of a list of triangles.
struct TriangleRange {
    std::uint32_t first, count;
};

/// Draws pieces of a list of triangles so that shaders know the number of each triangle:
/// gl_PrimitiveID starts at 0 in every range, and where the range starts is an attribute per
/// instance that is read from its draw command, of which base_instance picks the range's.
class RangeCommands {
  public:
    RangeCommands() : buffer_(Buffer::create()) {}

    /// Makes `attribute` of a vertex array the first index of the range, from `binding`.
    static void describe(const VertexArray& array, GLuint attribute, GLuint binding);
    /// Takes these ranges; returns false if there is nothing to draw.
    bool take(std::span<const TriangleRange> ranges, const Purpose& purpose);
    /// Draws them with the bound vertex array, which gets the commands at `binding`.
    void draw(const VertexArray& array, GLuint binding) const;

  private:
    /// As glMultiDrawElementsIndirect() reads it.
    struct Command {
        GLuint count, instance_count, first_index;
        GLint base_vertex;
        GLuint base_instance;
    };

    Buffer buffer_;
    std::vector<Command> commands_;
};

} // namespace lineatlas::gl
