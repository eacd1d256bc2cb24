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

/// Draws pieces of a list of triangles so that shaders know the number of each triangle.
/// gl_PrimitiveID starts at 0 in every range. The start of the range is an attribute per instance,
/// read from the range's draw command, which base_instance picks.
class RangeCommands {
  public:
    RangeCommands() : buffer_(Buffer::create()) {}

    /// Makes `attribute` of a vertex array the first index of the range. It is read from `binding`.
    static void describe(const VertexArray& array, GLuint attribute, GLuint binding);
    /// Makes draw commands for these ranges. Returns false if there is nothing to draw.
    bool take(std::span<const TriangleRange> ranges, const Purpose& purpose);
    /// Draws the ranges with the bound vertex array, which gets the commands at `binding`.
    void draw(const VertexArray& array, GLuint binding) const;

  private:
    /// A command in the layout of glMultiDrawElementsIndirect().
    struct Command {
        GLuint count, instance_count, first_index;
        GLint base_vertex;
        GLuint base_instance;
    };

    Buffer buffer_;
    std::vector<Command> commands_;
};

} // namespace lineatlas::gl
