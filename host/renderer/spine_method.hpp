#pragma once

#include "frame.hpp"
#include "glpasses/depth_pass.hpp"
#include "glpasses/spine_pass.hpp"

namespace lineatlas {

/// The spine test (§3): one depth pass and one pass over all segments.
class SpineMethod {
  public:
    FrameStats draw(Frame& frame);

  private:
    gl::DepthPass depth_pass_;
    gl::SpinePass spine_pass_;
};

} // namespace lineatlas
