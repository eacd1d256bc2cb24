#pragma once

#include <string>

namespace lineatlas::bench {

/// What a program is doing, on standard error: one line on a terminal, rewritten; lines in a log.
class Progress {
  public:
    Progress();
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A larger step.
    void say(const std::string& text);
    /// A smaller one, for terminals only.
    void detail(const std::string& text);
    /// Removes the line from a terminal, so that something else can be printed.
    void clear();

  private:
    bool terminal_;
    bool shown_ = false;
};

} // namespace lineatlas::bench
