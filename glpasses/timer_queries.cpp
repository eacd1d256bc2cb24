#include "timer_queries.hpp"

#include <limits>

#include "core/host_clock.hpp"

namespace lineatlas::gl {

TimerQueries::~TimerQueries() {
    glDeleteQueries(static_cast<GLsizei>(all_.size()), all_.data());
}

GLuint TimerQueries::stamp() {
    if (free_.empty()) {
        GLuint query = 0;
        glCreateQueries(GL_TIMESTAMP, 1, &query);
        all_.push_back(query);
        free_.push_back(query);
    }
    const GLuint query = free_.back();
    free_.pop_back();
    glQueryCounter(query, GL_TIMESTAMP);
    return query;
}

bool TimerQueries::is_available(GLuint query) {
    GLint available = GL_FALSE;
    glGetQueryObjectiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
    return available != GL_FALSE;
}

std::int64_t TimerQueries::time(GLuint query) {
    GLuint64 time = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &time);
    return static_cast<std::int64_t>(time);
}

ClockOffset read_clock_offset() {
    constexpr int readings = 3; // a reading may have been interrupted
    ClockOffset best{0, std::numeric_limits<std::int64_t>::max()};
    for (int i = 0; i < readings; ++i) {
        const std::int64_t before = host_nanoseconds();
        GLint64 time = 0;
        glGetInteger64v(GL_TIMESTAMP, &time);
        const std::int64_t half = (host_nanoseconds() - before + 1) / 2;
        if (half < best.error) best = {before + half - time, half};
    }
    return best;
}

} // namespace lineatlas::gl
