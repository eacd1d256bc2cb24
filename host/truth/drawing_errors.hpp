#pragma once

#include <span>
#include <vector>

#include "edge_truth.hpp"
#include "lineatlas/io.hpp"

// How a drawing differs from the truth (docs/quality.md).
namespace lineatlas {

/// A straight piece of what is drawn as visible.
struct DrawnPiece {
    static constexpr std::uint32_t unknown = 0xFFFFFFFF; ///< of what it shows nothing is known
    glm::dvec2 from, to;             ///< pixels from the upper left corner, y down
    std::uint32_t segment = unknown; ///< of the truth's line set
};

/// A place where a drawing is wrong.
struct WrongPoint {
    glm::vec2 at;
    float pixels; ///< the length that it stands for
};

/// What is drawn and should not be, and what should be and is not.
struct DrawingErrors {
    double reach = 0;     ///< pixels within which the drawing and the truth may differ
    double visible = 0;   ///< pixels of line that are truly visible and surely lines
    double undecided = 0; ///< pixels of line that count as neither
    double drawn = 0;     ///< pixels of line, or dark pixels
    /// Of what is drawn within the reach how far the worst place is off, in pixels. Of paths.
    double off = 0;
    glm::vec2 off_at{0, 0}; ///< that place
    std::vector<WrongPoint> missed, false_drawn;

    double missed_pixels() const;
    double false_pixels() const;
    double missed_share() const; ///< of what is visible
    double false_share() const;  ///< of what is visible
};

/// Lengths of drawn lines, within a reach of at most PointGrid::most_reach pixels. What is nearer
/// than two pixels to the picture's border counts nowhere.
DrawingErrors compare_paths(const EdgeTruth& truth, std::span<const DrawnPiece> drawn,
                            double reach);

/// The same of a picture: pixels darker than half are ink. `missed` are places with no ink within
/// a pixel, `false_drawn` ink with no visible line within one and a half. Throws UsageError when
/// its size is not the truth's.
DrawingErrors compare_ink(const EdgeTruth& truth, const Image& picture);

/// Every drawn piece against the truth of its own segment alone, so that a visible line beside it
/// excuses nothing.
struct StrictErrors {
    double decided = 0; ///< pixels drawn where the segment is known to be visible or hidden
    double hidden = 0;  ///< of them hidden
    double unknown = 0; ///< pixels drawn of no known segment
    /// Of the hidden ones those that stand more than 2.2 pixels behind what hides them and farther
    /// than 1.5 pixels along the segment from where it may be visible.
    std::vector<WrongPoint> surely_wrong;

    double hidden_share() const { return decided > 0 ? hidden / decided : 0; }
    double surely_wrong_pixels() const;
};
StrictErrors compare_strictly(const EdgeTruth& truth, std::span<const DrawnPiece> drawn);

/// The drawing grey, what is false red, what is missed blue; `scale` times as large.
Image error_picture(const EdgeTruth& truth, std::span<const DrawnPiece> drawn,
                    const DrawingErrors& errors, int scale);
/// The same of a picture.
Image error_picture(const Image& picture, const DrawingErrors& errors, int scale);

} // namespace lineatlas
