#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frame_output.hpp"
#include "lineatlas/sheet.hpp"
#include "lineatlas/vector.hpp"
#include "path_file.hpp"

namespace lineatlas {

/// How all drawings of one command are made.
struct VectorFrame {
    Style style;
    VectorOptions paths;
    SvgOptions svg; ///< for DXF and PDF too, see PathFileOptions
    JsonOptions json;
    std::string description; ///< the camera is added to it
    /// Checks a drawing before it is written to a file, and returns its result in a line. Empty:
    /// drawings are not checked.
    std::function<std::string(const VectorDrawing& drawing, const Camera& camera,
                              const std::filesystem::path& path)>
        certify{};
};

/// A note on how much of a drawing is thinned (VectorDrawing::thinned_share). Empty below a
/// thousandth.
std::string note_of_thinned(double share);

/// Frames as paths, by extension.
class VectorOutput final : public FrameOutput {
  public:
    /// `find` finds what is visible of `lines`, which must outlive this object.
    VectorOutput(VectorFrame frame, const LineSet& lines, FindLines find);

    bool draw(const Camera& camera, const std::filesystem::path& path) override;
    void finish() override {}
    bool is_whole(const std::filesystem::path& path, glm::ivec2 size) override;
    /// The note of the frame with the largest thinned share.
    std::string note() const override { return note_of_thinned(thinned_share_); }

  private:
    VectorFrame frame_;
    const LineSet& lines_;
    FindLines find_;
    double thinned_share_ = 0;
};

} // namespace lineatlas
