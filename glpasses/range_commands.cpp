#include "range_commands.hpp"

#include <cstddef>

#include "storage.hpp"

namespace lineatlas::gl {

void RangeCommands::describe(const VertexArray& array, GLuint attribute, GLuint binding) {
    glEnableVertexArrayAttrib(array.id(), attribute);
    glVertexArrayAttribIFormat(array.id(), attribute, 1, GL_UNSIGNED_INT,
                               offsetof(Command, first_index));
    glVertexArrayAttribBinding(array.id(), attribute, binding);
    glVertexArrayBindingDivisor(array.id(), binding, 1);
}

bool RangeCommands::take(std::span<const TriangleRange> ranges, const Purpose& purpose) {
    commands_.clear();
    for (const TriangleRange& range : ranges) {
        if (range.count == 0) continue;
        commands_.push_back({.count = range.count * 3,
                             .instance_count = 1,
                             .first_index = range.first * 3,
                             .base_vertex = 0,
                             .base_instance = static_cast<GLuint>(commands_.size())});
    }
    if (commands_.empty()) return false;
    refill(buffer_, commands_.size() * sizeof(Command), commands_.data(), purpose);
    return true;
}

void RangeCommands::draw(const VertexArray& array, GLuint binding) const {
    glVertexArrayVertexBuffer(array.id(), binding, buffer_.id(), 0, sizeof(Command));
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer_.id());
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr,
                                static_cast<GLsizei>(commands_.size()), 0);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

} // namespace lineatlas::gl
