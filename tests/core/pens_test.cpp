#include "core/pens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr std::array<float, 6> widths{0.5F, 1, 2, 3.7F, 10, 60};

int at(const PenMark& mark, int row, int column) {
    return mark.coverage.at(static_cast<std::size_t>(row * mark.size.x + column));
}

/// Mean change of coverage from a column to the next; the one after the last is the first.
double change_after(const PenMark& mark, int column) {
    double sum = 0;
    for (int row = 0; row < mark.size.y; ++row) {
        sum += std::abs(at(mark, row, (column + 1) % mark.size.x) - at(mark, row, column));
    }
    return sum / mark.size.y;
}

TEST(Pens, EveryNameIsAPen) {
    const std::vector<std::string_view> expected{"solid", "fine",   "pencil", "charcoal",
                                                 "brush", "dashed", "dotted", "chain"};
    EXPECT_TRUE(std::ranges::equal(pen_names(), expected, {}, &PenName::name));
    for (const PenName& pen : pen_names()) {
        EXPECT_FALSE(pen.description.empty());
        EXPECT_FALSE(is_pen_file(pen.name));
        for (const float width : widths) {
            const PenMark mark = make_pen(pen.name, width);
            EXPECT_EQ(mark.coverage.size(), static_cast<std::size_t>(mark.size.x) *
                                                static_cast<std::size_t>(mark.size.y));
            EXPECT_GT(mark.repeat_length, 0);
            EXPECT_EQ(mark.size == glm::ivec2(0, 0), pen.name == "solid");
        }
    }
}

TEST(Pens, AnUnknownNameIsRefusedWithTheNamesThereAre) {
    for (const std::string_view name : {"", "crayon", "Solid", "pen ", "penci"}) {
        try {
            make_pen(name, 2);
            ADD_FAILURE() << name << " was taken";
        } catch (const UsageError& error) {
            const std::string message = error.what();
            EXPECT_NE(message.find('"' + std::string{name} + '"'), std::string::npos) << message;
            for (const PenName& known : pen_names()) {
                EXPECT_NE(message.find(known.name), std::string::npos) << message;
            }
        }
    }
}

TEST(Pens, MarksAreTheSameEveryTime) {
    for (const PenName& pen : pen_names()) {
        EXPECT_EQ(make_pen(pen.name, 3).coverage, make_pen(pen.name, 3).coverage);
    }
}

constexpr std::array<std::string_view, 4> uneven{"fine", "pencil", "charcoal", "brush"};

TEST(Pens, UnevenMarksCoverTheSpineMoreThanTheEdge) {
    for (const std::string_view name : uneven) {
        for (const float width : {2.0F, 4.0F, 8.0F, 16.0F}) {
            const PenMark mark = make_pen(name, width);
            const auto row_mean = [&](int row) {
                double sum = 0;
                for (int column = 0; column < mark.size.x; ++column) sum += at(mark, row, column);
                return sum / mark.size.x;
            };
            const double spine = row_mean(mark.size.y / 2);
            EXPECT_GT(spine, 100) << name << width;
            for (const int edge : {0, mark.size.y - 1}) {
                EXPECT_LT(row_mean(edge), 0.75 * spine) << name << width;
            }
        }
    }
}

TEST(Pens, InkIsUnbrokenAlongTheSpine) {
    const PenMark mark = make_pen("fine", 2);
    for (int column = 0; column < mark.size.x; ++column) {
        EXPECT_GT(at(mark, mark.size.y / 2, column), 200);
        EXPECT_GT(at(mark, mark.size.y / 2 - 1, column), 200);
    }
}

TEST(Pens, GraphiteAndCharcoalAreGrainy) {
    for (const std::string_view name : {"pencil", "charcoal"}) {
        const PenMark mark = make_pen(name, 8);
        std::set<int> values;
        for (int column = 0; column < mark.size.x; ++column) {
            values.insert(at(mark, mark.size.y / 2, column));
        }
        EXPECT_GT(values.size(), 40U) << name;
    }
}

TEST(Pens, ABrushLeavesStreaksAlongTheStroke) {
    const PenMark mark = make_pen("brush", 16);
    double along = 0;
    double across = 0;
    for (int row = 3; row < 12; ++row) {
        for (int column = 0; column + 1 < mark.size.x; ++column) {
            along += std::abs(at(mark, row, column + 1) - at(mark, row, column));
            across += std::abs(at(mark, row + 1, column) - at(mark, row, column));
        }
    }
    EXPECT_GT(across, 2 * along);
}

/// The texture repeats along the stroke. Its end must continue in its start, or the mark jumps
/// there.
TEST(Pens, MarksRepeatWithoutASeam) {
    for (const PenName& pen : pen_names()) {
        const PenMark mark = make_pen(pen.name, 4);
        if (mark.size.x == 0) continue;
        double largest = 0;
        for (int column = 0; column + 1 < mark.size.x; ++column) {
            largest = std::max(largest, change_after(mark, column));
        }
        EXPECT_LE(change_after(mark, mark.size.x - 1), largest) << pen.name;
    }
    // Columns far apart look different, and neighbours look alike. Noise that does not wrap would
    // jump.
    const PenMark ink = make_pen("fine", 8);
    const double far = change_after(ink, ink.size.x - 1);
    EXPECT_LT(far, 12);
}

/// The middle of a path lies where the mark begins.
TEST(Pens, AChainHasADashInTheMiddleOfAPath) {
    const PenMark mark = make_pen("chain", 4);
    const double columns_per_width = mark.size.x / 30.5;
    for (int column = 0; column < mark.size.x; ++column) {
        const double from_end =
            (std::min(column, mark.size.x - 1 - column) + 0.5) / columns_per_width;
        const int ink = at(mark, mark.size.y / 2, column);
        if (from_end < 11) { // half a dash of 24 widths
            EXPECT_GT(ink, 250) << column;
        }
        if (from_end > 13 && from_end < 14) {
            EXPECT_LT(ink, 5) << column;
        }
    }
    EXPECT_GT(at(mark, mark.size.y / 2, mark.size.x / 2), 100); // the dot
}

TEST(Pens, DashesAndDotsGrowWithTheWidth) {
    for (const auto& [name, length, share] :
         {std::tuple{"dashed", 15.0F, 12.0 / 15}, std::tuple{"dotted", 2.5F, 0.7854 / 2.5}}) {
        for (const float width : widths) {
            const PenMark mark = make_pen(name, width);
            EXPECT_FLOAT_EQ(mark.repeat_length, length * std::max(1.0F, width));
            if (width < 2) continue; // antialiasing blurs narrower marks
            double sum = 0;
            for (const std::uint8_t coverage : mark.coverage) sum += coverage / 255.0;
            EXPECT_NEAR(sum / static_cast<double>(mark.coverage.size()), share, 0.03)
                << name << width;
        }
    }
}

/// Across a wide stroke the grain must change as often per pixel as across a narrow one.
TEST(Pens, GrainKeepsItsSizeOnTheScreen) {
    const auto change_per_pixel = [](float width) {
        const PenMark mark = make_pen("pencil", width);
        double sum = 0;
        const int middle = mark.size.y / 2;
        for (int column = 0; column < mark.size.x; ++column) {
            sum += std::abs(at(mark, middle, column) - at(mark, middle - 1, column));
        }
        return sum / (width / static_cast<float>(mark.size.y));
    };
    EXPECT_NEAR(change_per_pixel(32) / change_per_pixel(16), 1, 0.3);
    EXPECT_EQ(make_pen("pencil", 1).repeat_length, make_pen("pencil", 8).repeat_length);
}

TEST(Pens, AnImageIsAMark) {
    const Image grey{.size = {3, 2}, .channels = 1, .pixels = {0, 100, 255, 10, 20, 30}};
    const PenMark mark = pen_from_image(grey, 4);
    EXPECT_EQ(mark.size, glm::ivec2(3, 2));
    EXPECT_FLOAT_EQ(mark.repeat_length, 6);
    // The stroke's right side first: the lower row of the picture.
    EXPECT_EQ(mark.coverage, (std::vector<std::uint8_t>{245, 235, 225, 255, 155, 0}));
    EXPECT_EQ(image_of_pen(mark).pixels, grey.pixels);

    const Image rgb{.size = {2, 1}, .channels = 3, .pixels = {0, 0, 0, 255, 255, 255}};
    EXPECT_EQ(pen_from_image(rgb, 1).coverage, (std::vector<std::uint8_t>{255, 0}));
    const Image alpha{.size = {2, 1}, .channels = 4, .pixels = {9, 9, 9, 40, 255, 255, 255, 200}};
    EXPECT_EQ(pen_from_image(alpha, 1).coverage, (std::vector<std::uint8_t>{40, 200}));
    const Image opaque{.size = {2, 1}, .channels = 2, .pixels = {5, 255, 250, 255}};
    EXPECT_EQ(pen_from_image(opaque, 1).coverage, (std::vector<std::uint8_t>{250, 5}))
        << "alpha says nothing if it is the same everywhere";
    EXPECT_THROW(pen_from_image({}, 1), UsageError);
}

TEST(Pens, BuiltInMarksSurviveAsImages) {
    for (const PenName& pen : pen_names()) {
        const PenMark mark = make_pen(pen.name, 16);
        const PenMark again = pen_from_image(image_of_pen(mark), 16);
        if (pen.name == "solid") {
            EXPECT_EQ(std::ranges::count(again.coverage, 255), std::ssize(again.coverage));
            continue;
        }
        EXPECT_EQ(again.coverage, mark.coverage) << pen.name;
        EXPECT_FLOAT_EQ(again.repeat_length, mark.repeat_length) << pen.name;
    }
    EXPECT_THROW(make_pen("mark.png", 2), UsageError);
    EXPECT_TRUE(is_pen_file("mark.png"));
    EXPECT_TRUE(is_pen_file("marks/mine"));
}

} // namespace
} // namespace lineatlas
