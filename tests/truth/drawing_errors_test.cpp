// The reported errors of drawings with known errors.

#include "truth/drawing_errors.hpp"

#include <array>

#include <gtest/gtest.h>

#include "lineatlas/error.hpp"
#include "truth/certificate.hpp"
#include "truth_views.hpp"

namespace lineatlas {
namespace {

/// A line from 100 to 300 along y = 150, the right half of it behind a panel 1.5 pixels before it;
/// another one all visible, 60 pixels below.
class DrawingErrorsTest : public testing::Test {
  protected:
    explicit DrawingErrorsTest(float pixels = 1.5F) : lines_(lines_behind(pixels)) {}

    static LineSet lines_behind(float pixels) {
        Mesh mesh;
        test::add_panel(mesh, {0, -9}, {9, 9}, 0.01F * pixels);
        test::add_stroke(mesh, {-1, 0.5F, 0}, {1, 0.5F, 0});
        test::add_stroke(mesh, {-1, -0.1F, 0}, {-0.2F, -0.1F, 0});
        return extract_lines(mesh);
    }

    std::uint32_t segment(float y) const {
        for (std::uint32_t i = 0; i < lines_.segments.size(); ++i) {
            const Segment& one = lines_.segments[i];
            if ((one.tag & LA_TAG_KIND_MASK) == LA_KIND_FILE && lines_.vertices[one.p].y == y)
                return i;
        }
        return DrawnPiece::unknown;
    }

    /// The right drawing, including the panel's edge.
    std::vector<DrawnPiece> right() const {
        return {{{100, 150}, {200, 150}, segment(0.5F)},
                {{100, 210}, {180, 210}, segment(-0.1F)},
                {{200, 0}, {200, 400}}};
    }

    LineSet lines_;
    RayScene scene_{lines_};
    EdgeTruth truth_{scene_, test::front_camera()};
};

TEST_F(DrawingErrorsTest, NothingIsWrongWithTheTruth) {
    const DrawingErrors errors = compare_paths(truth_, right(), 0.5);
    EXPECT_NEAR(errors.visible, 100 + 80 + 396, 1.5);
    EXPECT_NEAR(errors.drawn, 100 + 80 + 396, 0.5);
    EXPECT_EQ(errors.missed_pixels(), 0);
    EXPECT_EQ(errors.false_pixels(), 0);
    EXPECT_EQ(compare_strictly(truth_, right()).hidden, 0);
}

TEST_F(DrawingErrorsTest, SeesWhatIsMissing) {
    std::vector<DrawnPiece> drawn = right();
    drawn.erase(drawn.begin() + 1);
    const DrawingErrors errors = compare_paths(truth_, drawn, 0.5);
    EXPECT_NEAR(errors.missed_pixels(), 80, 0.01);
    EXPECT_NEAR(errors.missed_share(), 80.0 / 576, 0.001);
    EXPECT_EQ(errors.false_pixels(), 0);
    EXPECT_EQ(compare_paths(truth_, {}, 0.5).missed_share(), 1);
}

TEST_F(DrawingErrorsTest, OfALineOnlyWhatIsInThePictureCounts) {
    // To test all of it at every quarter of a pixel would take years.
    const std::vector<DrawnPiece> drawn{{{-1e12, 60}, {1e12, 60}}, {{50, 1e12}, {50, 2e12}}};
    const DrawingErrors errors = compare_paths(truth_, drawn, 0.5);
    // Except where it meets the panel.
    EXPECT_NEAR(errors.drawn, truth_.size().x - 4, 0.5); // without the picture's border
    EXPECT_NEAR(errors.false_pixels(), truth_.size().x - 4 - 1, 1);
}

TEST_F(DrawingErrorsTest, SeesLinesLessThanTwoPixelsBehindAFace) {
    // The drawing shows a part that is less than two pixels behind a panel.
    std::vector<DrawnPiece> drawn = right();
    drawn[0].to.x = 300;
    const DrawingErrors errors = compare_paths(truth_, drawn, 0.5);
    EXPECT_NEAR(errors.false_pixels(), 100, 1); // the ends beside the panel's edge are near it
    EXPECT_EQ(errors.missed_pixels(), 0);
    const StrictErrors strict = compare_strictly(truth_, drawn);
    EXPECT_NEAR(strict.hidden, 100, 0.5);
    EXPECT_NEAR(strict.decided, 280, 1);
    EXPECT_NEAR(strict.unknown, 400, 0.01);
    EXPECT_EQ(strict.surely_wrong_pixels(), 0); // it is not behind the panel by 2.2 pixels
}

class DrawingErrorsFarTest : public DrawingErrorsTest {
  protected:
    DrawingErrorsFarTest() : DrawingErrorsTest(5) {}
};

TEST_F(DrawingErrorsFarTest, SeesWhatIsSurelyWrong) {
    std::vector<DrawnPiece> drawn = right();
    drawn[0].to.x = 300;
    // The panel's edge is in the middle, so that it does not move in a view from 10 units.
    EXPECT_NEAR(compare_strictly(truth_, drawn).surely_wrong_pixels(), 98.5, 0.6);
    drawn[0].to.x = 201.2; // an end that is slightly late is not surely wrong
    EXPECT_EQ(compare_strictly(truth_, drawn).surely_wrong_pixels(), 0);
    EXPECT_GT(compare_strictly(truth_, drawn).hidden, 0.5);
}

TEST_F(DrawingErrorsTest, AVisibleLineBesideAHiddenPieceDoesNotExcuseItStrictly) {
    std::vector<DrawnPiece> drawn = right();
    drawn[0].to.x = 300;
    drawn.push_back({{200, 150.4}, {300, 150.4}}); // as a part of another line
    EXPECT_NEAR(compare_strictly(truth_, drawn).hidden, 100, 0.5);
}

TEST_F(DrawingErrorsTest, ToleratesErrorsWithinItsReachAlone) {
    std::vector<DrawnPiece> drawn = right();
    for (DrawnPiece& piece : drawn) {
        piece.from += glm::dvec2{1, 1};
        piece.to += glm::dvec2{1, 1};
    }
    const DrawingErrors narrow = compare_paths(truth_, drawn, 0.5);
    EXPECT_GT(narrow.missed_share(), 0.98);
    EXPECT_GT(narrow.false_share(), 0.98);
    const DrawingErrors wide = compare_paths(truth_, drawn, 1.5);
    EXPECT_EQ(wide.missed_pixels(), 0);
    EXPECT_LT(wide.false_pixels(), 0.5);
}

Image white() {
    return {.size = {400, 400}, .channels = 4, .pixels = std::vector<std::uint8_t>(640'000, 255)};
}

void blacken(Image& image, glm::ivec2 low, glm::ivec2 high) {
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x)
            for (int channel = 0; channel < 3; ++channel)
                image.pixels[static_cast<std::size_t>((y * 400 + x) * 4 + channel)] = 0;
}

TEST_F(DrawingErrorsTest, SeesFalseAndMissedInk) {
    Image image = white();
    blacken(image, {100, 149}, {200, 151});
    blacken(image, {199, 0}, {201, 400});
    const DrawingErrors missing = compare_ink(truth_, image);
    EXPECT_NEAR(missing.missed_pixels(), 80, 0.01);
    EXPECT_EQ(missing.false_pixels(), 0);
    blacken(image, {100, 209}, {180, 211});
    EXPECT_EQ(compare_ink(truth_, image).missed_pixels(), 0);
    // Every fourth pixel of the hidden part: a row of dots.
    for (int x = 210; x < 300; x += 4) blacken(image, {x, 150}, {x + 1, 151});
    EXPECT_EQ(compare_ink(truth_, image).false_pixels(), 23);
    image.size = {400, 300};
    EXPECT_THROW(compare_ink(truth_, image), UsageError);
}

TEST_F(DrawingErrorsTest, ColoursWhatIsWrong) {
    std::vector<DrawnPiece> drawn = right();
    drawn[0].to.x = 300;
    drawn.erase(drawn.begin() + 1);
    const Image image = error_picture(truth_, drawn, compare_paths(truth_, drawn, 0.5), 2);
    ASSERT_EQ(image.size, (glm::ivec2{800, 800}));
    const auto color = [&](int x, int y) {
        const std::uint8_t* at = &image.pixels[static_cast<std::size_t>((y * 800 + x) * 3)];
        return std::array<int, 3>{at[0], at[1], at[2]};
    };
    EXPECT_EQ(color(500, 300), (std::array{230, 0, 0}));     // false
    EXPECT_EQ(color(280, 420), (std::array{0, 60, 255}));    // missed
    EXPECT_EQ(color(300, 300), (std::array{150, 150, 150})); // right
    EXPECT_EQ(color(300, 600), (std::array{255, 255, 255})); // nothing
}

TEST_F(DrawingErrorsTest, CertificateNamesFiguresAndPlaces) {
    std::vector<DrawnPiece> drawn = right();
    drawn[0].to.x = 300;
    Certificate certificate = compare_lines(truth_, {.legs = drawn, .pieces = {}});
    certificate.strict = compare_strictly(truth_, drawn);
    EXPECT_NEAR(certificate.narrow.false_pixels(), 100, 1);
    EXPECT_NEAR(certificate.wide.false_pixels(), 98.5, 1);
    const std::string line = certificate_line(certificate);
    EXPECT_NE(line.find("missed 0.0000 % within 1.5 pixels, 0.0000 % within 0.5; false 17."),
              std::string::npos)
        << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const std::string table = certificate_table(certificate, 3);
    EXPECT_NE(table.find("false           12.00 px at 204.1,150.0"), std::string::npos) << table;
}

/// Paths that nearly meet, one after the other, each a line.
DrawnLines lines_between(const std::vector<std::array<glm::dvec2, 2>>& ends) {
    DrawnLines drawn;
    for (const auto& [from, to] : ends) {
        drawn.legs.push_back({from, to});
        drawn.path_ends.push_back(drawn.legs.size());
    }
    return drawn;
}

TEST_F(DrawingErrorsTest, EndsThatNearlyMeetAreGaps) {
    const glm::ivec2 size = truth_.size();
    const std::vector<Gap> gaps =
        gaps_of(lines_between({{{{100, 100}, {200, 100}}}, {{{200.3, 100.4}, {200, 200}}}}), size);
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_NEAR(gaps[0].width, 0.5, 1e-6);
    EXPECT_EQ(gaps[0].at, (glm::vec2{200, 100}));
    // The same point, as files round it; ends farther apart; ends on a line in front of them.
    for (const auto& met : {
             lines_between({{{{100, 100}, {200, 100}}}, {{{200.01, 100.01}, {200, 200}}}}),
             lines_between({{{{100, 100}, {200, 100}}}, {{{200, 101.1}, {200, 200}}}}),
             lines_between({{{{100, 100}, {200, 100}}},
                            {{{100, 100.5}, {200, 100.5}}},
                            {{{200, 50}, {200, 150}}},
                            {{{100, 50}, {100, 150}}}}),
         })
        EXPECT_TRUE(gaps_of(met, size).empty());
    Certificate certificate = compare_lines(
        truth_, lines_between({{{{100, 100}, {200, 100}}}, {{{200.5, 100}, {300, 100}}}}));
    EXPECT_EQ(certificate.paths, 2U);
    const std::string table = certificate_table(certificate, 3);
    EXPECT_NE(table.find("gap              0.50 px at 200.0,100.0"), std::string::npos) << table;
}

} // namespace
} // namespace lineatlas
