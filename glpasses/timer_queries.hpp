#pragma once

#include <cstdint>
#include <vector>

#include <epoxy/gl.h>

namespace lineatlas::gl {

/// Time stamps in GL's queue (GL_TIMESTAMP queries). The context must be current, also when the
/// object is destroyed.
class TimerQueries {
  public:
    TimerQueries() = default;
    ~TimerQueries();
    TimerQueries(const TimerQueries&) = delete;
    TimerQueries& operator=(const TimerQueries&) = delete;

    /// A query for the moment at which all earlier commands are done.
    GLuint stamp();
    /// Whether the answer is there; doesn't wait.
    static bool is_available(GLuint query);
    /// The answer in GL's nanoseconds. Waits for it.
    static std::int64_t time(GLuint query);
    /// Takes back a query that is no longer needed.
    void give_back(GLuint query) { free_.push_back(query); }

  private:
    std::vector<GLuint> all_, free_;
};

/// The difference between GL's clock and std::chrono::steady_clock.
struct ClockOffset {
    std::int64_t nanoseconds; ///< to add to GL's time
    std::int64_t error;       ///< how wrong that may be at most
};
ClockOffset read_clock_offset();

} // namespace lineatlas::gl
