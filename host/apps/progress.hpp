#pragma once

#include <chrono>
#include <string>

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

} // namespace lineatlas::apps
