#include "notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "base/printable.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {

void print_notes(const std::vector<std::string>& notes) {
    if (notes.empty()) return;
    const std::string line = fmt::format("lineatlas: {}", fmt::join(notes, "; "));
    print_error(printable(line, longest_message) + '\n');
}

} // namespace lineatlas::apps
