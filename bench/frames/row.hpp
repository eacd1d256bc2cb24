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

/// A depth pass alone that draws every triangle, hidden or not, as OGL does; on buffers of its own.
class DepthOnly {
  public:
    explicit DepthOnly(const LineSet& lines);

    Contestant contestant(int scale);

  private:
    gl::Buffer vertices_, indices_;
    std::uint32_t triangle_count_;
    // A pass per scale: one pass would make a new texture whenever the scale changes.
    gl::DepthPass passes_[2];
};

/// What a row draws with: a renderer of its own and these options, but for the kinds of line.
struct Drawn {
    std::string name;
    FrameOptions options;
};
FrameOptions method_options(const MethodSpec& spec);

/// Everything that takes part in one row: what is drawn, then the depth pass at 1x and at 2x. Each
/// has a renderer of its own: a shared one would rebuild tables and textures whenever its
/// next frame is of another method or quality. The canvas must live as long.
class Row {
  public:
    Row(const Subject& subject, std::span<const Drawn> drawings, const DeviceOptions& device,
        gl::Canvas& canvas);

    const std::vector<Contestant>& contestants() const { return contestants_; }
    /// See Renderer::description(); empty without methods.
    const std::string& description() const { return description_; }

    /// `measured` in the order of the contestants.
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
