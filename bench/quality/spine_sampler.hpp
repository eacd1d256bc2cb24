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

/// The method spine at the centre of every sample. The method itself has no samples. So this class
/// runs the same shader functions on the same depth once more, into an atlas.
class SpineSampler {
  public:
    /// Needs a current GL context. The context and `lines` must outlive this object.
    explicit SpineSampler(const LineSet& lines);

    /// The samples as of Renderer::read_samples(), with the runs of spine_runs().
    Renderer::Samples sample(const ClippedLines& lines, const Camera& camera,
                             const FrameOptions& options);

  private:
    /// The segments with numbers of own faces, as probes of smooth surfaces need them.
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
