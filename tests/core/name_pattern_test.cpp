// Patterns that stand for names of parts, objects and materials.
#include <random>
#include <string>

#include <fnmatch.h>
#include <gtest/gtest.h>

#include "base/name_pattern.hpp"

namespace lineatlas::test {
namespace {

TEST(NamePattern, StarsQuestionMarksAndSets) {
    EXPECT_TRUE(matches("", ""));
    EXPECT_TRUE(matches("*", ""));
    EXPECT_TRUE(matches("Bolt*", "Bolt M8"));
    EXPECT_FALSE(matches("Bolt", "Bolt M8"));
    EXPECT_TRUE(matches("*M?", "Bolt M8"));
    EXPECT_TRUE(matches("B[a-p]lt[!0-9]*", "Bolt M8"));
    EXPECT_FALSE(matches("B[!a-p]lt*", "Bolt M8"));
    EXPECT_TRUE(matches("a\\*b", "a*b"));
    EXPECT_FALSE(matches("a\\*b", "axb"));
    EXPECT_TRUE(matches("[]]", "]"));
    EXPECT_TRUE(matches("a[b", "a[b")) << "without an end it is a letter";
}

TEST(NamePattern, ALetterIsNoByte) {
    EXPECT_TRUE(matches("T?r*", "T\u00fcr Gr\u00f6\u00dfe"));
    EXPECT_FALSE(matches("T??r*", "T\u00fcr"));
    EXPECT_TRUE(matches("[\u00e4-\u00fc]", "\u00f6"));
    EXPECT_TRUE(matches("?", "\U0001f529"));
    EXPECT_TRUE(matches("a?b", "a\xff"
                               "b"))
        << "a byte that is no letter of UTF-8 counts as one";
}

TEST(NamePattern, AgreesWithFnmatch) {
    std::mt19937 random(1);
    const auto made_of = [&](std::string_view letters, int most) {
        std::string text;
        for (int left = std::uniform_int_distribution(0, most)(random); left > 0; --left)
            text +=
                letters[std::uniform_int_distribution<std::size_t>(0, letters.size() - 1)(random)];
        return text;
    };
    int matched = 0;
    for (int i = 0; i < 200'000; ++i) {
        const std::string pattern = made_of("ab*?", 8), name = made_of("ab", 8);
        const bool expected = ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
        ASSERT_EQ(matches(pattern, name), expected) << pattern << " and " << name;
        matched += expected ? 1 : 0;
    }
    EXPECT_GT(matched, 10'000);
}

TEST(NamePattern, ManyStarsTakeNoTimeWithoutEnd) {
    std::string pattern;
    for (int i = 0; i < 50; ++i) pattern += "*a";
    EXPECT_FALSE(matches(pattern + "b", std::string(5000, 'a')));
}

TEST(NamePattern, PartsInAnyDepth) {
    EXPECT_TRUE(names_part("Bolt*", "robot/arm/Bolt 2"));
    EXPECT_TRUE(names_part("arm", "robot/arm/Bolt 2")) << "what is in it, too";
    EXPECT_TRUE(names_part("arm/Bolt*", "robot/arm/Bolt 2"));
    EXPECT_TRUE(names_part("robot/arm/Bolt 2", "robot/arm/Bolt 2"));
    EXPECT_FALSE(names_part("olt*", "robot/arm/Bolt 2"));
    EXPECT_FALSE(names_part("ar", "robot/arm/Bolt 2"));
    EXPECT_TRUE(names_part("1/2 bolt", "robot/1/2 bolt")) << "a name may hold a slash";
    EXPECT_TRUE(names_part("?", "a//b")) << "a name may be empty";
    EXPECT_FALSE(names_part("Bolt", ""));
}

} // namespace
} // namespace lineatlas::test
