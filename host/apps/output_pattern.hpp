#pragma once

#include <filesystem>
#include <string>

namespace lineatlas::apps {

/// The files of a sequence: a path with one %d or %04d where the number of the frame goes.
class OutputPattern {
  public:
    /// Throws UsageError unless there is exactly one such place. `%%` is a percent sign.
    explicit OutputPattern(const std::string& text);

    std::filesystem::path path(int frame) const;

  private:
    std::string before_, after_;
    int digits_ = 0; ///< fewest digits; filled up with zeros
};

} // namespace lineatlas::apps
