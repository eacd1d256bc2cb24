#include "member_names.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace lineatlas {
namespace {

/// The key of a member such as "FrameOptions::depth_scale": its name with hyphens, or another one
/// from this table.
std::optional<std::string> key_of(std::string_view member) {
    static const std::map<std::string_view, std::string_view> named{
        {"Density::limit", "density"},
        {"Fill::mode", "fill"},
        {"Paper::grain", "paper-grain"},
        {"Renderer::draw_tiles", "tile"}};
    constexpr std::array<std::string_view, 7> types{"Camera",      "DeviceOptions", "FrameOptions",
                                                    "LineOptions", "LoadOptions",   "StageForms",
                                                    "StrokeFilter"};
    if (const auto found = named.find(member); found != named.end())
        return std::string{found->second};
    const std::size_t colons = member.find("::");
    if (colons == member.npos || std::ranges::find(types, member.substr(0, colons)) == types.end())
        return std::nullopt;
    std::string key{member.substr(colons + 2)};
    std::ranges::replace(key, '_', '-');
    return key;
}

bool in_a_name(char c) {
    return c == ':' || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

} // namespace

std::string with_members_called(std::string_view message,
                                const std::function<std::string(const std::string& key)>& called) {
    std::string text;
    for (auto at = message.begin(); at != message.end();) {
        const auto end = std::find_if_not(at, message.end(), in_a_name);
        const std::string word{at, end};
        const std::optional<std::string> key = key_of(word);
        text += key ? called(*key) : word;
        at = end;
        if (at != message.end()) text += *at++;
    }
    return text;
}

std::string in_words_of_the_tool(std::string_view message) {
    return with_members_called(message, [](const std::string& key) { return "--" + key; });
}

} // namespace lineatlas
