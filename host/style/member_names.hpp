#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace lineatlas {

/// A message of the library with members of its API, as in FrameOptions::depth_scale, replaced by
/// what `called` makes of their settings' keys ("depth-scale").
std::string with_members_called(std::string_view message,
                                const std::function<std::string(const std::string& key)>& called);

/// For who uses the tool: "--depth-scale".
std::string in_words_of_the_tool(std::string_view message);

} // namespace lineatlas
