// Numbers in the text of options, styles and files.
#include <cmath>
#include <string_view>

#include <gtest/gtest.h>

#include "base/numbers.hpp"

namespace lineatlas::test {
namespace {

TEST(Numbers, AreTakenFromTheStartOfAText) {
    std::string_view text = "1.5e1mm";
    EXPECT_EQ(take_number(text), 15);
    EXPECT_EQ(text, "mm");
    EXPECT_EQ(take_number(text), std::nullopt);
    EXPECT_EQ(text, "mm") << "stays as it is";
    text = "-7,8";
    EXPECT_EQ(take_number<int>(text), -7);
    EXPECT_EQ(text, ",8");
}

TEST(Numbers, FillTheWholeTextOrAreRefused) {
    EXPECT_EQ(number_from("+2.5"), 2.5);
    EXPECT_EQ(number_from("1e400"), std::nullopt);
    EXPECT_TRUE(std::isnan(*number_from("nan")));
    for (const char* const text : {"", "+", "-", " 1", "1 ", "1,5", "0x10", "-0x1p3", "++1", "1e"})
        EXPECT_EQ(number_from(text), std::nullopt) << text;
    EXPECT_EQ(number_from<int>("4.0"), std::nullopt);
    EXPECT_EQ(number_from<float>("0.1"), 0.1F);
}

} // namespace
} // namespace lineatlas::test
