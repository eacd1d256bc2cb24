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
    print_error("\r\x1b[K" + text);
    shown_ = true;
}

void Progress::clear() {
    if (shown_) print_error("\r\x1b[K");
    shown_ = false;
}

} // namespace lineatlas::bench
