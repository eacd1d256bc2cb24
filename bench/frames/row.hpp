#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/methods.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/depth_pass.hpp"
#include "report.hpp"
#include "subjects.hpp"

namespace lineatlas::bench {

/// A lone depth pass on buffers of its own. Like OGL, it draws every triangle, hidden or not.
class DepthOnly {
  public:
    explicit DepthOnly(const LineSet& lines);

    Contestant contestant(int scale);

  private:
    gl::Buffer vertices_, indices_;
    std::uint32_t triangle_count_;
    // One pass per scale, because a pass makes a new texture whenever its scale changes.
    gl::DepthPass passes_[2];
};

/// One way of drawing a row: a renderer of its own with these options. The subject sets the kinds
/// of line.
struct Drawn {
    std::string name;
    FrameOptions options;
};
FrameOptions method_options(const MethodSpec& spec);

/// The contestants of one row: the drawings, then the depth pass at 1x and at 2x. Each drawing has
/// a renderer of its own: a shared renderer would rebuild tables and textures whenever the next
/// frame has another method or quality. The canvas must outlive the row.
class Row {
  public:
    Row(const Subject& subject, std::span<const Drawn> drawings, const DeviceOptions& device,
        gl::Canvas& canvas);

    const std::vector<Contestant>& contestants() const { return contestants_; }
    /// Renderer::description(); empty without drawings.
    const std::string& description() const { return description_; }

    /// The row's figures. `measured` is in the order of the contestants.
    SceneResult result(std::span<const Measured> measured) const;

  private:
    SceneResult result_;
    std::vector<FrameProfile> profiles_;
    DepthOnly depth_;
    std::string description_;
    std::vector<std::unique_ptr<Renderer>> renderers_;
    std::vector<Contestant> contestants_;
};

} // namespace lineatlas::bench
