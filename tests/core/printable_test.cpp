// Text from files, in messages and on a terminal.

#include <string>

#include <gtest/gtest.h>

#include "base/printable.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::test {
namespace {

constexpr std::size_t much = 1000;

TEST(Printable, LettersStay) {
    const std::string text = "Geh\u00e4use \u6a5f\u68b0 \U0001f529 \"~";
    EXPECT_EQ(printable(text, much), text);
}

TEST(Printable, WhatATerminalObeysDoesNot) {
    EXPECT_EQ(printable("\x1b[31mred\x07", much), "?[31mred?");
    EXPECT_EQ(printable("a\r\nb\tc\x7f", much), "a??b?c?");
    EXPECT_EQ(printable("\u009b31m", much), "?31m");                // C1: CSI in one letter
    EXPECT_EQ(printable("\u202egpj.exe\u2028", much), "?gpj.exe?"); // turned; ends a line
    EXPECT_EQ(printable(std::string("a\0b", 3), much), "a?b");
}

TEST(Printable, BytesThatAreNoUtf8DoNot) {
    EXPECT_EQ(printable("\xff\xfe", much), "??");
    EXPECT_EQ(printable("\xc0\x80", much), "??");           // zero in two bytes
    EXPECT_EQ(printable("\xe0\x82\x9b", much), "???");      // C1 in three
    EXPECT_EQ(printable("\xed\xa0\x80", much), "???");      // half of a surrogate pair
    EXPECT_EQ(printable("\xf4\x90\x80\x80", much), "????"); // beyond the last letter
    EXPECT_EQ(printable("cut \xe6\xa9", much), "cut ??");
}

TEST(Printable, LongTextIsCutBetweenLetters) {
    EXPECT_EQ(printable("abcdef", 6), "abcdef");
    EXPECT_EQ(printable("abcdefg", 6), "abcdef...");
    EXPECT_EQ(printable("ab\u6a5f", 4), "ab...");
    EXPECT_EQ(printable(std::string(41, 'x')), std::string(40, 'x').append("..."));
}

TEST(Printable, LinesStayWhereTheyAreMeant) {
    EXPECT_EQ(printable_lines("a\n\tb\x1b\r\n"), "a\n\tb??\n");
}

TEST(Printable, EveryErrorIsOneLineOfModerateLength) {
    EXPECT_STREQ(FileError("a\nb\x1b").what(), "a?b?");
    EXPECT_EQ(std::string{UsageError(std::string(1 << 20, 'x')).what()}.size(),
              longest_message + 3);
    EXPECT_STREQ(DeviceError("it does not build\n", "line 1\nline 2\x1b").what(),
                 "it does not build?:\nline 1\nline 2?");
}

} // namespace
} // namespace lineatlas::test
