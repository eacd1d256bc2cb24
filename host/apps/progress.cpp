#include "progress.hpp"

#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "base/printable.hpp"
#include "io/standard_streams.hpp"

namespace lineatlas::apps {
namespace {

constexpr std::chrono::seconds between_lines{10}; // in a log, where every line stays

constexpr std::chrono::milliseconds between_bars{100}; // on a terminal

constexpr std::size_t longest_stage = 40; // with its bar it fits on a line of 80 letters

std::string duration(double seconds) {
    const auto whole = static_cast<long>(seconds + 0.5);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

} // namespace

Progress::Progress(std::size_t total) : total_(total), terminal_(isatty(STDERR_FILENO) != 0) {}

double Progress::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::show(std::size_t done) {
    const Clock::time_point now = Clock::now();
    if (done == total_ || (!terminal_ && now - said_ < between_lines)) return;
    said_ = now;
    const double each = seconds() / static_cast<double>(done);
    const std::string text =
        fmt::format("lineatlas: {} of {} frames drawn, {:.2g} s each, {} left", done, total_, each,
                    duration(each * static_cast<double>(total_ - done)));
    clear();
    print_error(terminal_ ? text : text + '\n');
}

void Progress::clear() {
    if (terminal_) clear_error_line();
}

StageLine::StageLine(std::string_view stage)
    : stage_(printable(stage, longest_stage)), terminal_(isatty(STDERR_FILENO) != 0) {
    if (terminal_) print_error("lineatlas: " + stage_);
}

lineatlas::Progress StageLine::progress() {
    if (!terminal_) return {};
    return [this](float done) {
        const Clock::time_point now = Clock::now();
        if (static_cast<double>(done) > done_) {
            done_ = static_cast<double>(done);
            risen_ = now;
        }
        if (now - said_ >= between_bars && done_ > 0) show(now);
        return true;
    };
}

double StageLine::left(Clock::time_point now) const {
    const double until = std::chrono::duration<double>(risen_ - start_).count();
    const double since = std::chrono::duration<double>(now - risen_).count();
    return until * (1 - done_) / done_ - since;
}

void StageLine::show(Clock::time_point now) {
    constexpr std::size_t width = 20;
    said_ = now;
    const std::string full(static_cast<std::size_t>(width * done_), '#');
    const double seconds = left(now);
    clear_error_line();
    print_error(fmt::format("lineatlas: {} [{:-<{}}] {:.0f} %{}", stage_, full, width, 100 * done_,
                            seconds >= 0.5 ? fmt::format(", {} left", duration(seconds)) : ""));
}

void StageLine::clear() {
    if (terminal_) clear_error_line();
}

} // namespace lineatlas::apps
