#pragma once

#include <string>

#include "frame_output.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas::apps {

/// How all drawings of one command are made.
struct VectorFrame {
    FrameOptions options;
    VectorOptions paths;
    SvgOptions svg;
    JsonOptions json;
    std::string description; ///< is completed by the camera's
};

/// Frames as paths, SVG or JSON by extension.
class VectorOutput final : public FrameOutput {
  public:
    /// The line set is that of the renderer; both must outlive it.
    VectorOutput(VectorFrame frame, const LineSet& lines, Renderer& renderer);

    void draw(const Camera& camera, const std::filesystem::path& path) override;
    void finish() override {}
    bool is_whole(const std::filesystem::path& path, glm::ivec2 size) override;

    /// Finds the frame's intervals and reads them.
    FrameStats find(const Camera& camera, const FrameOptions& options);

  private:
    VectorFrame frame_;
    const LineSet& lines_;
    Renderer& renderer_;
    std::vector<Interval> intervals_; ///< of the last frame
};

} // namespace lineatlas::apps
