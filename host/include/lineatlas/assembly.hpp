#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lineatlas/export.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

struct AssemblyState;

/// Parts that come and go, together one line set. Each is an object, which moves and hides on its
/// own; nothing is welded or cut between them, as with LineOptions::separate_objects.
///
/// add() and remove() cost what the part costs, and Renderer::set_lines() after them does, too: the
/// tables have room for parts to come. When that is used up they are laid out anew, half as large
/// again as the parts that there are, as with a vector.
class LINEATLAS_API Assembly {
  public:
    Assembly();
    ~Assembly();
    Assembly(Assembly&&) noexcept;            ///< the other can only go or be set then
    Assembly& operator=(Assembly&&) noexcept; ///< likewise

    /// Adds the objects of a line set, or all of it as one where it has none, and gives their
    /// numbers in lines().objects: those of parts that are gone first, then the next. Throws
    /// UsageError for lines that Renderer::set_lines() does not take.
    std::vector<std::uint32_t> add(const LineSet& lines);

    /// Takes a part out. Its number stands for nothing until add() gives it again. Throws
    /// UsageError for a part that there is not.
    void remove(std::uint32_t object);

    /// All parts, for LineVisibility, make_vector_drawing() and all else that takes a line set;
    /// until the next add() or remove(). Between the parts is room: vertices that nothing uses,
    /// triangles without area and segments without length, which nothing draws. LineSet::sources
    /// and the like refer to the mesh of each part; there are no cut vertices, so move_vertices()
    /// is not for it. Which segment is whose may change with add(), numbers of objects do not.
    const LineSet& lines() const;

  private:
    friend class Renderer;
    std::unique_ptr<AssemblyState> state_;
};

} // namespace lineatlas
