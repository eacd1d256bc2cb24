#pragma once

#include "stages.hpp"

namespace lineatlas::test {

/// The oracles on the state of a frame, with the settings of FrameStages.
class FrameOracles {
  public:
    explicit FrameOracles(const LineSet& lines) : segments_(lines.segments) {}

    void scan(FrameState& state) const;
    void halo(const Camera& camera, FrameState& state) const;
    void filter(const Camera& camera, FrameState& state) const;
    void density(const Camera& camera, FrameState& state) const;

  private:
    const std::vector<Segment>& segments_;
    StageSettings settings_;
};

} // namespace lineatlas::test
