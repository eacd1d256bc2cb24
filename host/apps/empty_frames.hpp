#pragma once

#include <cstddef>
#include <string>

#include "lineatlas/lines.hpp"
#include "output/frame_output.hpp"

namespace lineatlas::apps {

/// Passes frames on to `output`, and notes which frames have no line and why.
class EmptyFrames final : public FrameOutput {
  public:
    /// `lines`: the lines that `output` draws; they must outlive this object. `kinds`: the kinds
    /// that are drawn.
    EmptyFrames(FrameOutput& output, const LineSet& lines, LineKindMask kinds)
        : output_(output), lines_(lines), kinds_(kinds) {}

    bool draw(const Camera& camera, const std::filesystem::path& path) override;
    void finish() override { output_.finish(); }
    bool is_whole(const std::filesystem::path& path, glm::ivec2 size) override {
        return output_.is_whole(path, size);
    }
    /// One line about all empty frames; empty if there is none.
    std::string report() const;

  private:
    FrameOutput& output_;
    const LineSet& lines_;
    LineKindMask kinds_;
    std::size_t frames_ = 0, empty_ = 0;
    std::filesystem::path first_; ///< the first empty frame
    std::string cause_;           ///< why that frame is empty
};

} // namespace lineatlas::apps
