#pragma once

#include "depth_stage.hpp"
#include "fill_stage.hpp"
#include "frame.hpp"
#include "glpasses/spine_pass.hpp"

namespace lineatlas {

/// The spine test (§3): one depth pass and one pass over all segments.
///
/// If a model has many segments, the depth pyramid drops those that are hidden as a whole before
/// they become strokes.
class SpineMethod {
  public:
    explicit SpineMethod(const interop::Connection& connection)
        : depth_(connection), fill_(connection) {}

    void set_scene(const SceneBuffers& scene) {
        depth_.set_scene(scene);
        fill_.set_scene();
    }
    FrameStats draw(Frame& frame);

  private:
    DepthStage depth_;
    FillStage fill_;
    gl::SpinePass spine_pass_;
};

} // namespace lineatlas
