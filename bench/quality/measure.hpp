#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "burst.hpp"
#include "common/progress.hpp"
#include "glpasses/canvas.hpp"
#include "path_errors.hpp"
#include "report.hpp"
#include "spine_sampler.hpp"
#include "subjects.hpp"

namespace lineatlas::bench {

/// What takes part.
struct Contestant {
    std::string name;
    FrameOptions options;
};

/// Told of every view and method: its samples in the view's own frame.
using ViewCallback =
    std::function<void(std::size_t view, const Contestant& method, const ViewSamples& samples,
                       const Camera& camera, const Oracle& oracle)>;

/// One subject in front of all methods. Needs a current GL context.
class Measurement {
  public:
    /// All must outlive it.
    Measurement(const Subject& subject, const Settings& settings, const DeviceOptions& device,
                bool use_cache, gl::Canvas& canvas, Progress& progress);

    /// Errors in every view; sparkle and crawl between the frames of a burst from each view on.
    SubjectReport run(const std::vector<Contestant>& methods, const ViewCallback& on_view);
    /// The same of the segment atlas with any number of probes and depth scale.
    StudyReport study();
    /// How right the intervals are that come out of SAhi, and those of a drawing as paths, whose
    /// ends meet the lines that hide them.
    std::vector<IntervalReport> intervals(FrameOptions options);
    /// How right drawings are, as paths and as pictures of pixels; the picture of the errors of
    /// each is handed to `on_errors`.
    using ErrorPicture =
        std::function<void(std::size_t view, const std::string& what, const Image&)>;
    std::vector<PathReport> paths(const std::vector<Contestant>& methods,
                                  const ErrorPicture& on_errors);
    /// Sparkle of what is drawn with each of some styles; each gets all of a view's frames in turn.
    SubjectReport styles(const std::vector<Contestant>& styles);
    /// Whether the truth hangs on the number of rays.
    OracleReport check_oracle();

  private:
    /// A frame, what is true there and the points it shares with the frame before.
    struct Frame {
        Camera camera;
        ClippedLines clipped;
        std::vector<float> truth;
        std::vector<Match> matches;
    };

    /// The frames of a view.
    struct Moving {
        std::vector<Frame> frames;
        double typical_motion; ///< see Burst
    };

    Frame frame_at(const Camera& camera, std::uint32_t rays) const;
    Moving frames_of(const PathView& view);
    Renderer::Samples sample(const Contestant& method, const Frame& frame);
    MethodReport measure(const Contestant& method, const std::vector<Frame>& frames,
                         Renderer::Samples& first);
    StyledFigures restlessness_of(const Contestant& style, const std::vector<Frame>& frames,
                                  const Tracks& tracks);
    SubjectReport empty_report() const;
    void begin_view(std::size_t index);
    void doing(const std::string& what);

    const Subject& subject_;
    const Settings& settings_;
    bool use_cache_;
    gl::Canvas& canvas_;
    Progress& progress_;
    std::string view_; ///< being measured
    Renderer renderer_;
    std::optional<SpineSampler> spine_;
    Oracle oracle_;
};

} // namespace lineatlas::bench
