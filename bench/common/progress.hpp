#pragma once

#include <string>

namespace lineatlas::bench {

/// Shows on standard error what a program is doing. A terminal gets one line that is rewritten, a
/// log gets one line per step.
class Progress {
  public:
    Progress();
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Shows a larger step.
    void say(const std::string& text);
    /// Shows a smaller step; only terminals get it.
    void detail(const std::string& text);
    /// Removes the line from a terminal, so that other text can be printed.
    void clear();

  private:
    bool terminal_;
    bool shown_ = false;
};

} // namespace lineatlas::bench
