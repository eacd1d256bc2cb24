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

/// A participant: a method, or a style, with its options.
struct Contestant {
    std::string name;
    FrameOptions options;
};

/// Called for every view and method with the samples of the view's own frame.
using ViewCallback =
    std::function<void(std::size_t view, const Contestant& method, const ViewSamples& samples,
                       const Camera& camera, const Oracle& oracle)>;

/// Measures all methods on one subject. Needs a current GL context.
class Measurement {
  public:
    /// All arguments taken by reference must outlive this object.
    Measurement(const Subject& subject, const Settings& settings, const DeviceOptions& device,
                bool use_cache, gl::Canvas& canvas, Progress& progress);

    /// Measures errors in every view, and sparkle and crawl in a burst that starts at each view.
    SubjectReport run(const std::vector<Contestant>& methods, const ViewCallback& on_view);
    /// As run(), of the segment atlas with several numbers of probes and depth scales.
    StudyReport study();
    /// Errors of the intervals of SAhi, and of the intervals of a drawing as paths, whose hidden
    /// ends meet the lines that hide them.
    std::vector<IntervalReport> intervals(FrameOptions options);
    /// Gets a picture of the errors of a drawing.
    using ErrorPicture =
        std::function<void(std::size_t view, const std::string& what, const Image&)>;
    /// Errors of drawings, as paths and as pictures of pixels.
    std::vector<PathReport> paths(const std::vector<Contestant>& methods,
                                  const ErrorPicture& on_errors);
    /// Sparkle of drawings with each style. Each style draws all frames of a view in order.
    SubjectReport styles(const std::vector<Contestant>& styles);
    /// Compares the truth with that of twice as many rays.
    OracleReport check_oracle();

  private:
    /// A frame, its truth, and the points that it shares with the previous frame.
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
    std::string view_; ///< the view that is being measured
    Renderer renderer_;
    std::optional<SpineSampler> spine_;
    Oracle oracle_;
};

} // namespace lineatlas::bench
