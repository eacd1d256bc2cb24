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

    /// A query for the moment at which all that was submitted before is done.
    GLuint stamp();
    /// Whether the answer is there; doesn't wait.
    static bool is_available(GLuint query);
    /// The answer in GL's nanoseconds, with a wait if it isn't there.
    static std::int64_t time(GLuint query);
    /// A query that is no longer needed.
    void give_back(GLuint query) { free_.push_back(query); }

  private:
    std::vector<GLuint> all_, free_;
};

/// How GL's clock lies to std::chrono::steady_clock.
struct ClockOffset {
    std::int64_t nanoseconds; ///< to add to GL's
    std::int64_t error;       ///< by which that may be wrong
};
ClockOffset read_clock_offset();

} // namespace lineatlas::gl
