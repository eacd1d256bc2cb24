#pragma once

#include "stages.hpp"

namespace lineatlas::compute {

/// Texture coordinates of silhouettes that are carried over from frame to frame: the tables of the
/// stage `carry`, which grow when a frame needs more. Frames without such textures cost nothing.
class CarriedCoordinates {
  public:
    /// `stages` must outlive it.
    explicit CarriedCoordinates(Stages& stages) : stages_(stages), tables_{&stages.device()} {}

    /// Gives up its tables and its memory of the frame before.
    void release();
    /// The next frame does not follow the last one.
    void forget() { frame_ += 2; }
    /// Finds the coordinates of a frame's silhouettes, which stand from `first` on in chains.
    /// Without silhouettes it remembers nothing. `limit`: see CarryArgs.
    void find(const SegmentTable& table, std::uint32_t first, const ClippedTable& clipped,
              glm::vec2 viewport, float limit);
    /// Writes the coordinates into runs of that frame.
    void apply(const RunTable& runs);

  private:
    Stages& stages_;
    std::uint32_t frame_ = 2;
    std::uint32_t first_ = 0, count_ = 0; ///< silhouettes of the last frame
    Buffer* arcs_ = nullptr;              ///< of that frame
    CarryTables tables_;
};

} // namespace lineatlas::compute
