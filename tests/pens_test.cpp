#include "core/pens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <string_view>
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
    const std::vector<std::string_view> expected{"solid", "pen", "pencil", "dashed"};
    EXPECT_TRUE(std::ranges::equal(pen_names(), expected));
    for (const std::string_view name : pen_names()) {
        for (const float width : widths) {
            const PenMark mark = make_pen(name, width);
            EXPECT_EQ(mark.coverage.size(), static_cast<std::size_t>(mark.size.x) *
                                                static_cast<std::size_t>(mark.size.y));
            EXPECT_GT(mark.repeat_length, 0);
            if (name == "solid") {
                EXPECT_EQ(mark.size, glm::ivec2(0, 0));
            } else {
                // A column covers a pixel of the stroke.
                EXPECT_EQ(mark.repeat_length, static_cast<float>(mark.size.x));
            }
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
            for (const std::string_view known : pen_names()) {
                EXPECT_NE(message.find(known), std::string::npos) << message;
            }
        }
    }
}

TEST(Pens, MarksAreTheSameEveryTime) {
    for (const std::string_view name : pen_names()) {
        EXPECT_EQ(make_pen(name, 3).coverage, make_pen(name, 3).coverage);
    }
}

TEST(Pens, InkAndGraphiteCoverTheSpineMoreThanTheEdge) {
    for (const std::string_view name : {"pen", "pencil"}) {
        const PenMark mark = make_pen(name, 4);
        const auto row_mean = [&](int row) {
            double sum = 0;
            for (int column = 0; column < mark.size.x; ++column) sum += at(mark, row, column);
            return sum / mark.size.x;
        };
        const double spine = row_mean(mark.size.y / 2);
        EXPECT_GT(spine, 100) << name;
        for (const int edge : {0, mark.size.y - 1}) {
            EXPECT_LT(row_mean(edge), 0.6 * spine) << name;
        }
    }
}

TEST(Pens, InkIsUnbrokenAlongTheSpine) {
    const PenMark mark = make_pen("pen", 2);
    for (int column = 0; column < mark.size.x; ++column) {
        EXPECT_EQ(at(mark, mark.size.y / 2, column), 255);
        EXPECT_EQ(at(mark, mark.size.y / 2 - 1, column), 255);
    }
}

TEST(Pens, GraphiteIsGrainy) {
    const PenMark mark = make_pen("pencil", 4);
    std::set<int> values;
    for (int column = 0; column < mark.size.x; ++column) {
        values.insert(at(mark, mark.size.y / 2, column));
    }
    EXPECT_GT(values.size(), 40U);
}

/// The texture repeats along the stroke: its end must go on in its start, or the pen's edge jumps
/// there. A smooth edge changes from a column to the next about as much as it does beside them.
TEST(Pens, InkRepeatsWithoutASeam) {
    const PenMark mark = make_pen("pen", 4);
    const int columns = mark.size.x;
    for (int column = 0; column < columns; ++column) {
        const double beside = std::max(change_after(mark, (column + columns - 1) % columns),
                                       change_after(mark, (column + 1) % columns));
        EXPECT_LE(change_after(mark, column), 2 * beside + 1) << "after column " << column;
    }
}

TEST(Pens, GraphiteRepeatsWithoutASeam) {
    const PenMark mark = make_pen("pencil", 4);
    double largest = 0;
    for (int column = 0; column + 1 < mark.size.x; ++column) {
        largest = std::max(largest, change_after(mark, column));
    }
    EXPECT_LE(change_after(mark, mark.size.x - 1), largest);
}

TEST(Pens, ADashAndAGapAreTwoToOne) {
    for (const float width : widths) {
        const PenMark mark = make_pen("dashed", width);
        ASSERT_EQ(mark.size.y, 1);
        const auto covered = std::ranges::count(mark.coverage, 255);
        EXPECT_EQ(covered + std::ranges::count(mark.coverage, 0), mark.size.x) << "soft ends";
        EXPECT_TRUE(std::ranges::is_sorted(mark.coverage, std::greater{})) << "more than one dash";
        EXPECT_GE(covered, 4);
        EXPECT_GE(mark.size.x - covered, 3);
        if (width >= 1) {
            EXPECT_NEAR(static_cast<float>(covered), 6 * width, 0.5F);
            EXPECT_NEAR(static_cast<float>(mark.size.x - covered), 3 * width, 0.5F);
        }
    }
}

/// A row is a share of the width; the grain must change across a wide stroke as often as its pixels
/// ask.
TEST(Pens, GrainKeepsItsSizeOnTheScreen) {
    const auto change_across = [](float width) {
        const PenMark mark = make_pen("pencil", width);
        double sum = 0;
        for (int column = 0; column < mark.size.x; ++column) {
            for (int row = 4; row < 11; ++row) {
                sum += std::abs(at(mark, row + 1, column) - at(mark, row, column));
            }
        }
        return sum;
    };
    EXPECT_LT(change_across(1), 0.5 * change_across(8));
    // Along the stroke a column is a pixel at any width.
    EXPECT_EQ(make_pen("pencil", 1).repeat_length, make_pen("pencil", 8).repeat_length);
}

} // namespace
} // namespace lineatlas
