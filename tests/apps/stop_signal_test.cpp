#include "command_line/stop_signal.hpp"

#include <csignal>

#include <ctime>
#include <gtest/gtest.h>
#include <unistd.h>

namespace lineatlas {
namespace {

using ::testing::ExitedWithCode;

/// A frame that never ends.
[[noreturn]] void draw_for_ever() {
    for (;;) ::pause();
}

TEST(StopSignal, EndsWhatDoesNotStop) {
    const auto be_stopped = [](int signal) {
        StopSignal stop;
        stop.set_last_words("1 of 3 frames");
        stop.set_last_words("2 of 3 frames");
        std::raise(signal);
        draw_for_ever();
    };
    EXPECT_EXIT(be_stopped(SIGINT), ExitedWithCode(128 + SIGINT), "^2 of 3 frames\n$");
    EXPECT_EXIT(be_stopped(SIGTERM), ExitedWithCode(128 + SIGTERM), "^2 of 3 frames\n$");
}

TEST(StopSignal, LeavesAloneWhatStops) {
    const auto stop_by_itself = [] {
        {
            const StopSignal stop;
            std::raise(SIGINT);
            if (stop.received() != SIGINT) ::_exit(1);
        }
        const timespec longer_than_it_waits{.tv_sec = 0, .tv_nsec = 400'000'000};
        ::nanosleep(&longer_than_it_waits, nullptr);
        ::_exit(7);
    };
    EXPECT_EXIT(stop_by_itself(), ExitedWithCode(7), "");
}

TEST(StopSignal, ASecondSignalEndsAtOnce) {
    const auto be_stopped_twice = [] {
        const StopSignal stop;
        std::raise(SIGINT);
        std::raise(SIGINT);
        draw_for_ever();
    };
    EXPECT_EXIT(be_stopped_twice(), ::testing::KilledBySignal(SIGINT), "");
}

} // namespace
} // namespace lineatlas
