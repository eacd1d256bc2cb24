#include "member_names.hpp"

#include <algorithm>
#include <map>

#include "frame_settings.hpp"

namespace lineatlas {
namespace {

/// Keys by member. Those of the table of frame settings are called as the members are.
std::map<std::string, std::string> make_keys() {
    std::map<std::string, std::string> keys{{"Camera::size", "size"},
                                            {"Density::limit", "density"},
                                            {"DeviceOptions::compute", "compute"},
                                            {"DeviceOptions::device", "device"},
                                            {"DeviceOptions::interop", "interop"},
                                            {"Fill::mode", "fill"},
                                            {"LineOptions::crease_angle", "crease"},
                                            {"LineOptions::kinds", "lines"},
                                            {"LoadOptions::deflection", "deflection"},
                                            {"LoadOptions::pixels", "pixels"},
                                            {"LoadOptions::read_memory", "read-memory"},
                                            {"LoadOptions::read_seconds", "read-seconds"},
                                            {"Paper::grain", "paper-grain"},
                                            {"Renderer::draw_tiles", "tile"},
                                            {"StrokeFilter::halo", "halo"}};
    for (const FrameSetting& setting : frame_settings()) {
        std::string member = "FrameOptions::" + setting.key;
        std::ranges::replace(member, '-', '_');
        keys.emplace(std::move(member), setting.key);
    }
    return keys;
}

bool in_a_name(char c) {
    return c == ':' || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

} // namespace

std::string with_members_called(std::string_view message,
                                const std::function<std::string(const std::string& key)>& called) {
    static const std::map<std::string, std::string> keys = make_keys();
    std::string text;
    for (auto at = message.begin(); at != message.end();) {
        const auto end = std::find_if_not(at, message.end(), in_a_name);
        const std::string word{at, end};
        const auto known = keys.find(word);
        text += known != keys.end() ? called(known->second) : word;
        at = end;
        if (at != message.end()) text += *at++;
    }
    return text;
}

std::string in_words_of_the_tool(std::string_view message) {
    return with_members_called(message, [](const std::string& key) { return "--" + key; });
}

} // namespace lineatlas
