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

namespace lineatlas {

class Assembly;

/// Which pieces of lines LineVisibility finds.
struct VisibilityOptions {
    LineKindMask lines = usual_line_kinds; ///< of the kinds extracted
    bool hidden = false; ///< hidden pieces too: together the whole of every line in the picture
    /// Pixels, 0.01 to 10000: a line of one segment that is shorter is left out, as
    /// FrameOptions::step has it.
    float step = 2;
    bool outlines = false;     ///< for LineVisibility::outlines()
    float outline_depth = 6;   ///< for the same, pixels, at least 0: thinner bodies have no outline
    float centre_overhang = 0; ///< Style::centre_overhang, pixels, at least 0
};

/// What is visible of lines, by the exact method (Method::exact): the intervals that a Renderer
/// finds, without a picture. Needs neither GL nor an OpenCL driver: it runs as C++ on all cores,
/// which starts at once, unless DeviceOptions or LINEATLAS_DEVICE name another device.
///
/// One call at a time; different ones may work at the same time on different threads.
///
/// All calls throw Error.
class LINEATLAS_API LineVisibility {
  public:
    /// For lines and triangles that hide them, as Renderer::set_lines() takes them. Throws
    /// UsageError for a backend that does not exist, for DeviceOptions::interop and for lines that
    /// Renderer::set_lines() does not take, DeviceError where the machine has no such device.
    explicit LineVisibility(const LineSet& lines, const DeviceOptions& options = {});
    ~LineVisibility();
    /// What is moved from can only be assigned to or destroyed.
    LineVisibility(LineVisibility&&) noexcept;
    LineVisibility& operator=(LineVisibility&&) noexcept; ///< the same

    /// The compute backend in use, for people.
    std::string description() const;

    /// Other lines and triangles, on the same device. Throws as the constructor does.
    void set_lines(const LineSet& lines);

    /// The same of the parts of an assembly, where they were made.
    void set_lines(const Assembly& parts);

    /// Moves objects (LineSet::objects) as Renderer::set_transforms() does, and throws as it does.
    /// find() and pick() see it from then on; other lines stand where they were made.
    void set_transforms(std::span<const glm::mat4> world_from_object);
    /// Changes shapes as Renderer::set_positions() does, and throws as it does.
    void set_positions(std::uint32_t first, std::span<const glm::vec3> positions);
    /// Shows all objects but these as Renderer::set_hidden() does, and throws as it does.
    void set_hidden(std::span<const std::uint32_t> objects);

    /// The visible pieces of the lines that `camera` sees, in order of LineSet::segments and along
    /// each; with VisibilityOptions::hidden the hidden ones too. They are those of
    /// Renderer::read_intervals() of a frame of Method::exact, bit by bit on one device. Throws
    /// UsageError for a camera that Renderer::draw() does not take, DeviceError where memory does
    /// not suffice, Cancelled where `progress` says so: it is asked before each stage.
    std::vector<Interval> find(const Camera& camera, const VisibilityOptions& options = {},
                               const Progress& progress = {});

    /// What `camera` shows at `position`, in pixels from the lower left corner of its viewport: of
    /// the visible lines of these kinds the nearest that is no farther than `radius` pixels, or
    /// else the face there, or nothing. Throws UsageError for a camera that find() does not take, a
    /// position that is not finite and a radius that is not from 0 to 1000.
    std::optional<Pick> pick(const Camera& camera, glm::vec2 position, float radius,
                             LineKindMask lines = all_line_kinds);

    /// Which parts of the visible pieces of the last find() have the background on one side, and a
    /// body VisibilityOptions::outline_depth deep on the other: half a pixel beside them no face is
    /// before what is infinitely far. In the order of the pieces. None unless
    /// VisibilityOptions::outlines asked for them.
    const std::vector<OutlinePart>& outlines() const;

  private:
    class LINEATLAS_LOCAL State;
    std::unique_ptr<State> state_;
};

} // namespace lineatlas
