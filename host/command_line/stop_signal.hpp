#pragma once

#include <array>
#include <string>

#include "lineatlas/error.hpp"

namespace lineatlas {

/// The user stopped the program with a signal; the exit code is 128 and its number.
class Stopped : public Error {
  public:
    Stopped(int signal, const std::string& message) : Error(message), signal_(signal) {}
    int exit_code() const { return 128 + signal_; }

  private:
    int signal_;
};

/// While it lives, SIGINT (Ctrl-C) and SIGTERM are noted instead of ending the program, so that it
/// can stop where it suits. If it has not stopped 0.2 seconds later, it ends with the exit code of
/// Stopped all the same. The second of a kind ends it at once. One at a time.
class StopSignal {
  public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    int received() const; ///< 0: none
    /// What is said on standard error, as a line, if the program ends so.
    void set_last_words(const std::string& line);

  private:
    std::array<std::string, 2> words_; ///< those that a signal may find, and the next ones
    int next_ = 0;
};

} // namespace lineatlas
