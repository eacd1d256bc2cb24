#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace lineatlas {

/// A message of the library in which members of its API, such as FrameOptions::depth_scale, are
/// replaced by the results of `called` for their keys ("depth-scale").
std::string with_members_called(std::string_view message,
                                const std::function<std::string(const std::string& key)>& called);

/// A message for users of the tool, with options such as "--depth-scale".
std::string in_words_of_the_tool(std::string_view message);

} // namespace lineatlas
