// What is seen of a line beyond a corner at which a face hides it.

#include "vector/corners.hpp"

#include <gtest/gtest.h>

#include "vector_support.hpp"

namespace lineatlas {
namespace {

/// A line away from the eye, of which 0.4 pixels seem to be visible, and a face at its start whose
/// other corners are that far from the eye.
Pieces pieces_of(float depth, float height = 20, float precision = 0.01F) {
    test::Lines lines;
    lines.add(LineKind::crease, {{100, 50, 0.2F}, {140, 50, 0.6F}});
    const auto first = static_cast<std::uint32_t>(lines.set.vertices.size());
    lines.set.vertices.emplace_back(140, 50 - height, depth);
    lines.set.vertices.emplace_back(140, 70, depth);
    lines.set.triangles.emplace_back(lines.set.segments[0].p, first, first + 1);
    lines.set.precision = precision;
    const Camera camera = test::flat_camera();
    test::Cuts cuts{lines.set, camera};
    cuts.add(0, 0, 0.01F, true);
    cuts.add(0, 0.01F, 1, false);
    for (Interval& interval : cuts.intervals) interval.flags |= LA_INTERVAL_EXACT;
    Pieces pieces = make_pieces(lines.set, camera, cuts.intervals);
    hide_beyond_corners(lines.set, camera, pieces);
    return pieces;
}

TEST(Corners, AFaceHidesALineFromTheCornerOn) {
    const Pieces pieces = pieces_of(0.2F);
    ASSERT_EQ(pieces.list.size(), 1U);
    EXPECT_FALSE(pieces.list[0].visible);
    EXPECT_EQ(pieces.list[0].start.t, 0);
    EXPECT_EQ(pieces.list[0].start.kind, std::uint32_t{LA_END_PATH});
    EXPECT_EQ(pieces.list[0].end.t, 1);
}

/// Behind it, along it, and beside it.
TEST(Corners, OtherFacesHideNothing) {
    EXPECT_EQ(pieces_of(0.9F).list.size(), 2U);
    EXPECT_EQ(pieces_of(0.6F).list.size(), 2U);
    EXPECT_EQ(pieces_of(0.2F, -10).list.size(), 2U);
    EXPECT_EQ(pieces_of(0.2F, 20, 0).list.size(), 2U); // nothing is known to be rounded
}

} // namespace
} // namespace lineatlas
