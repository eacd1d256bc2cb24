#pragma once

#include <span>
#include <vector>

#include "edge_truth.hpp"
#include "lineatlas/io.hpp"

// How a drawing differs from the truth (docs/quality.md).
namespace lineatlas {

/// A straight piece of a line that is drawn as visible.
struct DrawnPiece {
    static constexpr std::uint32_t unknown = 0xFFFFFFFF; ///< it is not known which segment it shows
    glm::dvec2 from, to;             ///< pixels from the upper left corner, y down
    std::uint32_t segment = unknown; ///< in the truth's line set
};

/// A place where a drawing is wrong.
struct WrongPoint {
    glm::vec2 at;
    float pixels; ///< the length that it stands for
};

/// Lengths that are drawn and should not be, and lengths that should be drawn and are not.
struct DrawingErrors {
    double reach = 0;     ///< pixels within which the drawing and the truth may differ
    double visible = 0;   ///< pixels of line that are truly visible and surely lines
    double undecided = 0; ///< pixels of line that count as neither
    double drawn = 0;     ///< pixels of line, or dark pixels
    /// How far the worst place within the reach is off, in pixels. Only for paths.
    double off = 0;
    glm::vec2 off_at{0, 0}; ///< that place
    std::vector<WrongPoint> missed, false_drawn;

    double missed_pixels() const;
    double false_pixels() const;
    double missed_share() const; ///< of the visible length
    double false_share() const;  ///< of the visible length
};

/// Compares lengths of drawn lines, within a reach of at most PointGrid::most_reach pixels. Places
/// nearer than two pixels to the picture's border do not count.
DrawingErrors compare_paths(const EdgeTruth& truth, std::span<const DrawnPiece> drawn,
                            double reach);

/// Compares a picture, whose pixels darker than half are ink. `missed` are places with no ink
/// within a pixel, `false_drawn` is ink with no visible line within one and a half. Throws
/// UsageError if its size is not that of the truth.
DrawingErrors compare_ink(const EdgeTruth& truth, const Image& picture);

/// The result of comparing every drawn piece with the truth of its own segment alone, so that a
/// visible line beside it does not count.
struct StrictErrors {
    double decided = 0; ///< pixels drawn where the segment is known to be visible or hidden
    double hidden = 0;  ///< the hidden ones of these
    double unknown = 0; ///< pixels drawn of no known segment
    /// Hidden points that are more than 2.2 pixels behind the hiding face and farther than 1.5
    /// pixels along the segment from a place where it may be visible.
    std::vector<WrongPoint> surely_wrong;

    double hidden_share() const { return decided > 0 ? hidden / decided : 0; }
    double surely_wrong_pixels() const;
};
StrictErrors compare_strictly(const EdgeTruth& truth, std::span<const DrawnPiece> drawn);

/// A picture of the drawing in grey, `scale` times as large, with false points red and missed
/// points blue.
Image error_picture(const EdgeTruth& truth, std::span<const DrawnPiece> drawn,
                    const DrawingErrors& errors, int scale);
/// As above, for a picture.
Image error_picture(const Image& picture, const DrawingErrors& errors, int scale);

} // namespace lineatlas
