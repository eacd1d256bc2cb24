#pragma once

#include "clipped_lines.hpp"
#include "glpasses/atlas_pass.hpp"
#include "glpasses/interop/connect.hpp"
#include "lineatlas/renderer.hpp"
#include "renderer/backdrop.hpp"
#include "renderer/depth_stage.hpp"
#include "renderer/pen_textures.hpp"
#include "renderer/scene_buffers.hpp"

namespace lineatlas::bench {

/// The spine test at the centre of every sample. It is drawn without samples, so the same shader
/// functions are run once more, on the same depth, into an atlas.
class SpineSampler {
  public:
    /// Needs a current GL context and `lines` for its whole life.
    explicit SpineSampler(const LineSet& lines);

    /// As Renderer::read_samples(), with the runs of spine_runs().
    Renderer::Samples sample(const ClippedLines& lines, const Camera& camera,
                             const FrameOptions& options);

  private:
    /// With the numbers of own faces, as probes that know surfaces want them.
    std::vector<ClippedSegment> numbered(std::vector<ClippedSegment> clipped) const;

    const LineSet& lines_;
    interop::Connection connection_;
    SceneBuffers scene_;
    std::vector<std::uint32_t> numbers_; ///< per triangle
    DepthStage depth_;
    PenTextures pens_;
    Backdrop backdrop_;
    gl::AtlasPass pass_{"spine_samples.frag"};
};

} // namespace lineatlas::bench
