#pragma once

#include "stages.hpp"

namespace lineatlas::compute {

/// The tables of the stage, see kernels/carry.cl for what each holds.
struct CarryTables {
    Device* device;
    /// In: of the frame before. Out: of this one. LA_MEMORY_WORDS uint32 per candidate, 0 at first.
    Table memory{*device, table::carry_memory};
    // Scratch: a uint32 per silhouette and one more.
    Table lengths{*device, table::carry_lengths}, found{*device, table::carry_found},
        kept{*device, table::carry_kept}, breaks{*device, table::carry_breaks},
        means{*device, table::carry_means}, pieces{*device, table::carry_pieces},
        list{*device, table::carry_list}, shifts{*device, table::carry_shifts};
    Table recalled{*device, table::carry_recalled}; ///< scratch: two uint32 per silhouette
    Table carried{*device, table::carried};         ///< out: two int32 per silhouette, 1/256 pixels

    void make_room(std::uint32_t candidates, std::uint32_t silhouettes);
};

/// The silhouettes of a frame.
struct CarryArgs {
    SegmentTable table;  ///< with origins
    std::uint32_t first; ///< first segment that is a silhouette
    std::uint32_t count; ///< of them, above 0
    ClippedTable clipped;
    glm::vec2 viewport;  ///< pixels
    std::uint32_t frame; ///< number of this frame, above 1
    float limit;         ///< pixels by which a coordinate may shift; 0: none may
    const CarryTables& tables;
};

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
