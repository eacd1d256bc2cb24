#pragma once

#include <array>
#include <memory>

#include "stages.hpp"

namespace lineatlas::compute {

/// Texture coordinates of silhouettes that are carried over from frame to frame: the tables of the
/// stage `carry`, which grow when a frame needs more. Frames that ask for none cost nothing.
class CarriedCoordinates {
  public:
    /// `stages` must outlive it.
    explicit CarriedCoordinates(Stages& stages) : stages_(stages), device_(stages.device()) {}

    /// Gives up its tables, and what it remembers.
    void release();
    /// The next frame does not follow the last one.
    void forget() { frame_ += 2; }
    /// Finds the coordinates of a frame whose silhouettes stand from `first` on, in chains; without
    /// any it remembers nothing. `limit`: see CarryArgs.
    void find(const SegmentTable& table, std::uint32_t first, const ClippedTable& clipped,
              glm::vec2 viewport, float limit);
    /// Puts them into runs of that frame.
    void apply(Buffer& runs, Buffer& record, std::uint32_t run_capacity);
    std::uint64_t bytes() const; ///< of all its tables

  private:
    void make_room(std::unique_ptr<Buffer>& buffer, std::uint64_t words);

    template <class Self>
    static auto tables(Self& self) {
        return std::array{&self.memory_, &self.lengths_, &self.found_,  &self.kept_,
                          &self.breaks_, &self.means_,   &self.pieces_, &self.recalled_,
                          &self.list_,   &self.shifts_,  &self.carried_};
    }

    Stages& stages_;
    Device& device_; ///< of stages_
    std::uint32_t frame_ = 2;
    std::uint32_t first_ = 0, count_ = 0; ///< silhouettes of the last frame
    Buffer* arcs_ = nullptr;              ///< of that frame
    std::unique_ptr<Buffer> memory_;      ///< per candidate
    std::unique_ptr<Buffer> lengths_, found_, kept_, breaks_, means_, pieces_; // that grow
    std::unique_ptr<Buffer> recalled_, list_, shifts_, carried_;
};

} // namespace lineatlas::compute
