#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command_line/cli_fwd.hpp"
#include "lineatlas/camera_path.hpp"
#include "lineatlas/lines.hpp"
#include "sequence.hpp"

namespace lineatlas::apps {

/// --turntable, --camera-path, --frames and --resume.
class SequenceOptions {
  public:
    /// `app` must outlive this object, and this object the parsing.
    void declare(CLI::App& app);

    /// Whether the options ask for several frames. Throws UsageError if they contradict each other
    /// or `output` is no name for several files.
    bool given(const std::string& output) const;
    bool turns() const { return turntable_ > 0; }
    bool resume() const { return resume_; }
    const std::string& camera_path() const { return camera_path_; } ///< a file; empty: none

    /// All frames that the options ask for. A turntable carries `view` around `axis`. A camera path
    /// takes from `view` what its file leaves out; `origin` is subtracted from its points. Throws
    /// Error that names the frame.
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
