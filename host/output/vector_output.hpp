#pragma once

#include <functional>
#include <string>

#include "frame_output.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/vector.hpp"
#include "path_file.hpp"

namespace lineatlas {

/// How all drawings of one command are made.
struct VectorFrame {
    FrameOptions options;
    VectorOptions paths;
    SvgOptions svg; ///< of DXF and PDF too: see PathFileOptions
    JsonOptions json;
    std::string description; ///< is completed by the camera's
    /// Checks a drawing before it is written to a file, and says in a line what it found; empty:
    /// drawings are not checked.
    std::function<std::string(const VectorDrawing& drawing, const Camera& camera,
                              const std::filesystem::path& path)>
        certify{};
};

/// Frames as paths, by extension.
class VectorOutput final : public FrameOutput {
  public:
    /// The line set is that of the renderer; both must outlive it.
    VectorOutput(VectorFrame frame, const LineSet& lines, Renderer& renderer);

    bool draw(const Camera& camera, const std::filesystem::path& path) override;
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

} // namespace lineatlas
