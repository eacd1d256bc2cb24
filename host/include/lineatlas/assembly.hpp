#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lineatlas/export.hpp"
#include "lineatlas/lines.hpp"

/// @file
/// Lines of parts that come and go.
/// @code{.cpp}
/// Assembly scene;
/// scene.add(lines); // every object is a part
/// renderer.set_lines(scene);
/// const std::uint32_t bolt = scene.add(extract_lines(bolt_mesh)).front();
/// scene.remove(bolt);
/// renderer.set_lines(scene); // takes time for the changed parts only
/// @endcode

namespace lineatlas {

struct AssemblyState;

/// Parts that come and go and that together make one line set. Each part is an object, which moves
/// and hides on its own. Nothing is welded or cut between parts, as with
/// LineOptions::separate_objects.
///
/// The time of add(), remove() and the next Renderer::set_lines() depends on that part only,
/// because the tables have room for further parts. When the room is used up, the tables are laid
/// out anew with half as much room again, as with a vector.
class LINEATLAS_API Assembly {
  public:
    Assembly();
    ~Assembly();
    /// A moved-from assembly may only be assigned to or destroyed.
    Assembly(Assembly&&) noexcept;
    Assembly& operator=(Assembly&&) noexcept; ///< the same

    /// Adds the objects of a line set, or the whole line set as one object if it has none. Returns
    /// their numbers in lines().objects: first numbers of removed parts, then new ones. Throws
    /// UsageError for lines that Renderer::set_lines() does not take.
    std::vector<std::uint32_t> add(const LineSet& lines);

    /// Removes a part. Its number stands for no part until add() returns it again. Throws
    /// UsageError for a part that does not exist.
    void remove(std::uint32_t object);

    /// All parts as a line set, for LineVisibility, make_vector_drawing() and every other function
    /// that takes one; valid until the next add() or remove(). Room between the parts is filled
    /// with unused vertices, triangles without area and segments without length, which are never
    /// drawn. LineSet::sources and the like refer to the mesh of each part; there are no cut
    /// vertices, so move_vertices() cannot be used. Numbers of segments may change with add();
    /// numbers of objects do not.
    const LineSet& lines() const;

  private:
    friend class Renderer;
    std::unique_ptr<AssemblyState> state_;
};

} // namespace lineatlas
