#pragma once

#include <string>
#include <vector>

namespace lineatlas::apps {

/// Prints notes on stderr, in one line.
void print_notes(const std::vector<std::string>& notes);

} // namespace lineatlas::apps
