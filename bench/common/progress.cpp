#include "progress.hpp"

#include <unistd.h>

#include "io/standard_streams.hpp"

namespace lineatlas::bench {

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::say(const std::string& text) {
    if (terminal_) return detail(text);
    print_error(text + "\n");
}

void Progress::detail(const std::string& text) {
    if (!terminal_) return;
    clear_error_line();
    print_error(text);
    shown_ = true;
}

void Progress::clear() {
    if (shown_) clear_error_line();
    shown_ = false;
}

} // namespace lineatlas::bench
