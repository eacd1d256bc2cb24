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

/// While such an object lives, SIGINT (Ctrl-C) and SIGTERM are noted and do not end the program, so
/// that it can stop at a good moment. A program that has not stopped 0.2 seconds later ends with
/// the exit code of Stopped all the same. The second signal of a kind ends it at once. There may be
/// one such object at a time.
class StopSignal {
  public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    int received() const; ///< 0: none
    /// Sets the line for standard error if the program ends so.
    void set_last_words(const std::string& line);

  private:
    std::array<std::string, 2> words_; ///< the words that a signal may find, and the next ones
    int next_ = 0;
};

} // namespace lineatlas
