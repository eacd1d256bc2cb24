#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clipped_lines.hpp"
#include "segment_table.h"

// Changes between consecutive frames of a slow camera move that the true drawing does not have.
namespace lineatlas::bench {

/// A point of a line in two frames: the centre of a sample in the later frame, and the same point
/// of the model in the earlier frame.
struct Match {
    std::uint32_t segment;
    std::uint32_t sample; ///< of the segment, in the later frame
    float before;         ///< position in the earlier frame, in samples of the segment
};

/// Points that move by more than this from frame to frame are left out.
inline constexpr double fastest_pixels = 1;

/// All points for which both frames have samples.
std::vector<Match> match_points(const ClippedLines& now, const ClippedLines& before,
                                glm::ivec2 viewport);

/// The strokes of a frame with their texture coordinates.
class StrokeArcs {
  public:
    StrokeArcs(std::span<const Run> runs, std::size_t segment_count);

    /// The texture coordinate in pixels at a position in samples of the segment; nothing where no
    /// stroke is drawn.
    std::optional<double> at(std::uint32_t segment, double position) const;

  private:
    std::vector<Run> runs_; ///< by segment, then along it
    std::vector<std::uint32_t> first_;
};

/// The runs of the method spine, whose texture coordinate is 0 in the middle of every segment
/// (§3.1). Only the members that StrokeArcs reads are set.
std::vector<Run> spine_runs(const ClippedLines& lines, std::span<const std::uint8_t> alpha,
                            glm::ivec2 viewport);

/// The alpha of a method in one frame, and the truth. Spans are in sample order.
struct FrameView {
    const ClippedLines& clipped;
    std::span<const std::uint8_t> alpha; ///< 0 to 255
    std::span<const float> truth;        ///< 0 to 1
    const StrokeArcs& arcs;
};

struct MotionFigures {
    std::uint64_t points = 0;
    double sparkle_sum = 0;          ///< of |change of alpha - change of alpha*|
    std::uint64_t stroke_points = 0; ///< points with strokes in both frames
    double crawl_sum = 0;            ///< of |change of the texture coordinate|, pixels
    std::uint64_t crawling = 0; ///< of stroke_points, those that change by half a pixel or more

    void add(const MotionFigures& other);
    std::optional<double> sparkle() const;
    std::optional<double> crawl() const;
    std::optional<double> crawling_share() const;
};

/// Figures in total and per line kind.
struct KindMotion {
    MotionFigures all;
    std::array<MotionFigures, LA_KIND_COUNT> kinds;

    void add(const KindMotion& other);
};

/// Compares the matched points of two frames. Values of the earlier frame are interpolated between
/// centres of samples, as strokes do.
KindMotion compare_frames(const LineSet& lines, std::span<const Match> matches,
                          const FrameView& now, const FrameView& before);

} // namespace lineatlas::bench
