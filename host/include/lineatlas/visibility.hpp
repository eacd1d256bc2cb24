#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/device_options.hpp"
#include "lineatlas/export.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/pick.hpp"
#include "lineatlas/progress.hpp"
#include "segment_table.h"

/// @file
/// Visible parts of lines by the exact method, without GL and OpenCL.
/// @code{.cpp}
/// LineVisibility visibility{lines};
/// for (const Interval& piece : visibility.find(camera, {.hidden = true}))
///     if ((piece.flags & LA_INTERVAL_VISIBLE) != 0U) std::cout << piece.segment << '\n';
/// @endcode

namespace lineatlas {

class Assembly;

/// Which pieces of lines LineVisibility finds.
struct VisibilityOptions {
    LineKindMask lines = usual_line_kinds; ///< kinds to find, of those extracted
    bool hidden = false; ///< also hidden pieces; all pieces together are every line in the picture
    /// Pixels, 0.01 to 10000: a line of one segment that is shorter is left out, as with
    /// FrameOptions::step.
    float step = 2;
    bool outlines = false;     ///< find what LineVisibility::outlines() returns
    float outline_depth = 6;   ///< for the same, pixels, at least 0: thinner bodies have no outline
    float centre_overhang = 0; ///< Style::centre_overhang, pixels, at least 0
};

/// Finds the visible pieces of lines by the exact method (Method::exact): the same intervals as a
/// Renderer, without a picture. Needs neither GL nor an OpenCL driver. It runs as C++ on all cores,
/// which starts at once, unless DeviceOptions or LINEATLAS_DEVICE name another device.
///
/// An object takes one call at a time. Different objects may work at the same time on different
/// threads.
///
/// All calls throw Error.
class LINEATLAS_API LineVisibility {
  public:
    /// For lines and triangles that hide them, as Renderer::set_lines() takes them. Throws
    /// UsageError for a backend that does not exist, if DeviceOptions::interop is set, and for
    /// lines that Renderer::set_lines() does not take. Throws DeviceError if the machine has no
    /// such device.
    explicit LineVisibility(const LineSet& lines, const DeviceOptions& options = {});
    ~LineVisibility();
    /// A moved-from object may only be assigned to or destroyed.
    LineVisibility(LineVisibility&&) noexcept;
    LineVisibility& operator=(LineVisibility&&) noexcept; ///< the same

    /// @name Lines and objects
    /// @code{.cpp}
    /// visibility.set_lines(lines);
    /// visibility.set_transforms(std::vector<glm::mat4>(lines.objects.size(), glm::mat4{1}));
    /// visibility.set_hidden(std::vector<std::uint32_t>{3, 7});
    /// @endcode
    /// @{

    /// The compute backend in use, for people.
    std::string description() const;

    /// Replaces lines and triangles, on the same device. Throws as the constructor does.
    void set_lines(const LineSet& lines);

    /// The same with the parts of an assembly, at the places where they were made.
    void set_lines(const Assembly& parts);

    /// Moves objects (LineSet::objects) as Renderer::set_transforms() does, and throws as it does.
    /// Later calls of find() and pick() use the new places. After set_lines() objects are where
    /// they were made.
    void set_transforms(std::span<const glm::mat4> world_from_object);
    /// Changes shapes as Renderer::set_positions() does, and throws as it does.
    void set_positions(std::uint32_t first, std::span<const glm::vec3> positions);
    /// Hides these objects and shows all others, as Renderer::set_hidden() does, and throws as it
    /// does.
    void set_hidden(std::span<const std::uint32_t> objects);

    /// @}
    /// @name What a camera sees
    /// @code{.cpp}
    /// const auto found = visibility.find(camera, {.hidden = true, .outlines = true});
    /// const VectorDrawing drawing =
    ///     make_vector_drawing(lines, camera, found, style, {.outlines = visibility.outlines()});
    /// @endcode
    /// @{

    /// The visible pieces of the lines that `camera` sees, in order of LineSet::segments and along
    /// each; with VisibilityOptions::hidden the hidden ones too. They equal those of
    /// Renderer::read_intervals() after a frame by Method::exact, bit by bit on one device. Throws
    /// UsageError for a camera that Renderer::draw() does not take, DeviceError if there is too
    /// little memory, Cancelled if `progress`, which is called before each stage, returns false.
    std::vector<Interval> find(const Camera& camera, const VisibilityOptions& options = {},
                               const Progress& progress = {});

    /// What `camera` shows at `position`, in pixels from the lower left corner of its viewport: the
    /// nearest visible line of these kinds within `radius` pixels, or else the face there, or
    /// nothing. Throws UsageError for a camera that find() does not take, a position that is not
    /// finite and a radius that is not from 0 to 1000.
    std::optional<Pick> pick(const Camera& camera, glm::vec2 position, float radius,
                             LineKindMask lines = all_line_kinds);

    /// The parts of the visible pieces of the last find() that have the background on one side, and
    /// on the other side a body that is VisibilityOptions::outline_depth deep. The background is
    /// where no face hides an infinitely far point half a pixel beside the line. In the order of
    /// the pieces. Empty unless VisibilityOptions::outlines asked for them.
    const std::vector<OutlinePart>& outlines() const;
    /// @}

  private:
    class LINEATLAS_LOCAL State;
    std::unique_ptr<State> state_;
};

} // namespace lineatlas
