// Messages of the library to programs, and the same messages for people.

#include "style/member_names.hpp"

#include <string>

#include <gtest/gtest.h>

#include "core/limits.hpp"

namespace lineatlas {
namespace {

constexpr Purpose all_purposes[] = {purpose::scratch,     purpose::model,         purpose::segments,
                                    purpose::motion,      purpose::atlas,         purpose::strokes,
                                    purpose::intervals,   purpose::density,       purpose::halos,
                                    purpose::depth,       purpose::whole_picture, purpose::picture,
                                    purpose::item_buffer, purpose::spine,         purpose::fill,
                                    purpose::pen,         purpose::paper};

TEST(MemberNames, TheLibrarySpeaksOfItsApiAndTheToolOfItsOptions) {
    for (const Purpose& purpose : all_purposes) {
        const std::string message = beyond_limit(purpose, "2 GiB", "there is 1 GiB");
        EXPECT_EQ(message.find("--"), std::string::npos) << message;
        EXPECT_EQ(in_words_of_the_tool(message).find("::"), std::string::npos)
            << in_words_of_the_tool(message);
    }
    EXPECT_EQ(in_words_of_the_tool(purpose::depth.help),
              "use a smaller --size or --depth-scale, or draw by tiles (--tile)");
    EXPECT_EQ(in_words_of_the_tool(purpose::fill.help), "use --fill none");
}

TEST(MemberNames, OtherWordsStayAsTheyAre) {
    for (const char* text : {"", "cannot read \"a::b\": Fill::modes; std::bad_alloc", "size: ö\n"})
        EXPECT_EQ(in_words_of_the_tool(text), text);
}

} // namespace
} // namespace lineatlas
