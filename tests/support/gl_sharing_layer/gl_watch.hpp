#pragma once

namespace lineatlas::test {

/// Puts watchers in front of the GL functions of this process (those of libepoxy).
void watch_gl();

/// True if somebody has waited for GL since its last command.
bool gl_is_finished();
/// True if a fence follows the last command.
bool gl_is_fenced();

/// While one exists, GL commands are the layer's own and not watched.
class Unwatched {
  public:
    Unwatched();
    ~Unwatched();
    Unwatched(const Unwatched&) = delete;
    Unwatched& operator=(const Unwatched&) = delete;
};

} // namespace lineatlas::test
