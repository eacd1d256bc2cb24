#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "lineatlas/camera_path.hpp"
#include "lineatlas/lines.hpp"
#include "sequence.hpp"

namespace lineatlas::apps {

/// --turntable, --camera-path, --frames and --resume.
class SequenceOptions {
  public:
    /// Both live as long as each other.
    void declare(CLI::App& app);

    /// Whether many frames are asked for, not one. Throws UsageError if the options contradict each
    /// other or `output` is no name for many files.
    bool given(const std::string& output) const;
    bool turns() const { return turntable_ > 0; }
    bool resume() const { return resume_; }
    const std::string& camera_path() const { return camera_path_; } ///< a file; empty: none

    /// Every frame that is asked for. A turntable carries `view` around `axis`; a camera path takes
    /// from it what its file leaves out, and is `origin` nearer to zero. Throws Error, naming the
    /// frame.
    std::vector<SequenceFrame> frames(const std::string& output, const View& view, const Axis& axis,
                                      glm::ivec2 size, const Bounds& bounds,
                                      glm::dvec3 origin) const;

  private:
    const CLI::App* app_ = nullptr;
    int turntable_ = 0;
    std::string camera_path_, frames_;
    bool resume_ = false;
};

} // namespace lineatlas::apps
