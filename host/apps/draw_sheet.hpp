#pragma once

#include "command_line/cli_fwd.hpp"
#include "draw_arguments.hpp"

namespace lineatlas::apps {

/// The style of sheets unless --style is given.
inline constexpr const char* sheet_style = "technical";

/// `draw --views`: several views of one model on a page. The command line has been checked before.
/// Throws Error.
void draw_sheet(const DrawArguments& arguments, const CLI::App& app);

} // namespace lineatlas::apps
