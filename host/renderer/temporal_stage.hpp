#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compute/stages/silhouette_chains.hpp"
#include "frame.hpp"

namespace lineatlas {

/// What two consecutive frames must have in common for the second to use results of the first.
struct LastFrame {
    /// Makes `frame` the last one.
    void take(const Frame& frame);
    /// Pixels by which points of the model have typically moved from the last frame to `frame`.
    /// None if `frame` has other samples, or has moved so far that nobody follows a line.
    std::optional<float> motion_to(const Frame& frame) const;

    Camera camera{};
    std::uint32_t probes = 0;
    int depth_scale = 0;
    float step = 0;
    std::vector<glm::mat4> transforms{}; ///< of the objects
    std::uint64_t shape_version = 0;
};

/// `temporal`: the visibility of samples is averaged with that of the frame before, where little
/// has moved, so that lines don't sparkle.
class TemporalStage {
  public:
    explicit TemporalStage(compute::Stages& stages) : stages_(stages), device_(stages.device()) {}

    /// Whether frames are averaged with those before them.
    static bool wanted(const Frame& frame);
    /// Gives up the tables, before another line set or another atlas.
    void release();
    /// Forgets the last frame: what follows is not averaged with it.
    void forget() {
        last_.reset();
        motion_.reset();
    }

    /// Call before the segments of a frame are found.
    void begin_frame(const Frame& frame);
    /// LastFrame::motion_to() the current frame; none if it does not follow the last one.
    std::optional<float> motion() const { return motion_; }
    /// The argument of SilhouetteChains::follow(); null if the frame does not follow the last one.
    compute::Buffer* positions_before() const { return motion_ ? positions_.get() : nullptr; }
    /// Averages the samples of `atlas`, in the order of `chains`, and keeps them for the next
    /// frame.
    void average(Frame& frame, const compute::SegmentAtlas& atlas,
                 compute::SilhouetteChains& chains);

  private:
    void make_tables(const compute::SegmentTable& table, std::size_t atlas_bytes);
    /// Empties the table of positions, for a frame without silhouettes.
    void forget_chains(const compute::SegmentTable& table);

    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    std::optional<LastFrame> last_;
    std::optional<float> motion_;
    // Tables of the last frame.
    compute::Table alpha_{device_, compute::table::alpha_before},
        offsets_{device_, compute::table::offsets_before},
        ranges_{device_, compute::table::ranges_before};
    compute::Table positions_{device_,
                              compute::table::positions_before}; ///< of candidates, see ChainOrder
};

} // namespace lineatlas
