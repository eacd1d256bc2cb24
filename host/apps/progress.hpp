#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "lineatlas/progress.hpp"

namespace lineatlas::apps {

/// Prints the progress of a sequence on standard error: on a terminal one line that every frame
/// rewrites, elsewhere a line from time to time.
class Progress {
  public:
    /// `total`: frames to draw.
    explicit Progress(std::size_t total);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Call after each frame. `done`: frames drawn so far.
    void show(std::size_t done);
    double seconds() const; ///< so far
    /// Removes the line from a terminal, so that something else can be printed.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    std::size_t total_;
    bool terminal_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point said_ = start_;
};

/// Shows on a terminal the stage of a program's work, the share of it that is done and the time
/// left. Elsewhere it shows nothing.
class StageLine {
  public:
    /// Shows the stage, in a word or two and perhaps the name of a file, as printable() returns it,
    /// until progress() knows more.
    explicit StageLine(std::string_view stage);
    ~StageLine() { clear(); }
    StageLine(const StageLine&) = delete;
    StageLine& operator=(const StageLine&) = delete;

    /// For the call that does the work; this object must outlive it. Empty if nothing is shown.
    lineatlas::Progress progress();
    /// Removes the line, so that something else can be printed.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    void show(Clock::time_point now);
    /// Seconds until the end. The last share may be some time old.
    double left(Clock::time_point now) const;

    std::string stage_;
    bool terminal_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point said_ = start_;
    Clock::time_point risen_ = start_; ///< when the share has risen to `done_`
    double done_ = 0;
};

} // namespace lineatlas::apps
