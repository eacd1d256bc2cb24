#include "measure.hpp"

#include <fmt/core.h>

#include "lineatlas/error.hpp"
#include "truth/model_truth.hpp"
#include "truth_cache.hpp"

namespace lineatlas::bench {
namespace {

constexpr float texture_wavelength = 16; ///< pixels: coarser than the grain of most marks

double mean(const std::vector<float>& values) {
    double sum = 0;
    for (const float value : values) sum += value;
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

} // namespace

Measurement::Measurement(const Subject& subject, const Settings& settings,
                         const DeviceOptions& device, bool use_cache, gl::Canvas& canvas,
                         Progress& progress)
    : subject_(subject), settings_(settings), use_cache_(use_cache), canvas_(canvas),
      progress_(progress), renderer_(device), oracle_(subject.lines) {
    renderer_.set_lines(subject.lines);
}

void Measurement::begin_view(std::size_t index) {
    view_ = fmt::format("{}: view {} of {}, {}", subject_.name, index + 1, subject_.views.size(),
                        subject_.views[index].name);
    progress_.say(view_);
}

void Measurement::doing(const std::string& what) {
    progress_.detail(view_ + ", " + what);
}

Measurement::Frame Measurement::frame_at(const Camera& camera, std::uint32_t rays) const {
    Frame frame{camera, clip_lines(subject_.lines, camera, settings_.step), {}, {}};
    const TruthOptions options{.rays = rays};
    frame.truth = use_cache_ ? cached_visibility(oracle_, frame.clipped, camera, options,
                                                 truth_cache_folder())
                             : oracle_.visibility(frame.clipped, camera, options);
    return frame;
}

Measurement::Moving Measurement::frames_of(const PathView& view) {
    doing("truth");
    std::vector<Frame> frames;
    frames.push_back(
        frame_at(make_camera(view.view(), settings_.size, subject_.lines.bounds), settings_.rays));
    const Burst burst = slow_burst(view, subject_.lines, settings_.size, settings_.burst,
                                   frames[0].clipped, frames[0].truth);
    for (std::size_t i = 1; i < burst.cameras.size(); ++i) {
        doing(fmt::format("truth {} of {}", i + 1, burst.cameras.size()));
        frames.push_back(frame_at(burst.cameras[i], settings_.rays));
        frames[i].matches = match_points(frames[i].clipped, frames[i - 1].clipped, settings_.size);
    }
    return {std::move(frames), burst.typical_motion};
}

Renderer::Samples Measurement::sample(const Contestant& method, const Frame& frame) {
    if (method.options.method == Method::spine) {
        if (!spine_) spine_.emplace(subject_.lines);
        return spine_->sample(frame.clipped, frame.camera, method.options);
    }
    canvas_.clear(glm::vec4{1});
    renderer_.draw(frame.camera, method.options, canvas_.framebuffer());
    Renderer::Samples samples = renderer_.read_samples();
    if (samples.offsets != frame.clipped.offsets) {
        throw DeviceError("the renderer's samples are not those of the reference");
    }
    return samples;
}

MethodReport Measurement::measure(const Contestant& method, const std::vector<Frame>& frames,
                                  Renderer::Samples& first) {
    first = sample(method, frames[0]);
    MethodReport report{method.name, {}, {}};
    report.errors = compare({subject_.lines, frames[0].clipped, first.alpha, frames[0].truth});
    const std::size_t segments = subject_.lines.segments.size();
    std::vector<std::uint8_t> alpha_before = first.alpha;
    StrokeArcs arcs_before{first.runs, segments};
    for (std::size_t i = 1; i < frames.size(); ++i) {
        Renderer::Samples now = sample(method, frames[i]);
        StrokeArcs arcs{now.runs, segments};
        report.motion.add(compare_frames(
            subject_.lines, frames[i].matches,
            {frames[i].clipped, now.alpha, frames[i].truth, arcs},
            {frames[i - 1].clipped, alpha_before, frames[i - 1].truth, arcs_before}));
        report.errors.add(compare({subject_.lines, frames[i].clipped, now.alpha, frames[i].truth}));
        alpha_before = std::move(now.alpha);
        arcs_before = std::move(arcs);
    }
    return report;
}

SubjectReport Measurement::empty_report() const {
    SubjectReport report;
    report.name = subject_.name;
    report.triangles = subject_.lines.triangles.size();
    report.segments = subject_.lines.segments.size();
    report.views = subject_.views.size();
    return report;
}

SubjectReport Measurement::run(const std::vector<Contestant>& methods,
                               const ViewCallback& on_view) {
    SubjectReport report = empty_report();
    for (const Contestant& method : methods) report.methods.push_back({method.name, {}, {}});
    for (std::size_t v = 0; v < subject_.views.size(); ++v) {
        begin_view(v);
        const Moving moving = frames_of(subject_.views[v]);
        const std::vector<Frame>& frames = moving.frames;
        report.typical_motion += moving.typical_motion / static_cast<double>(subject_.views.size());
        for (std::size_t m = 0; m < methods.size(); ++m) {
            doing(methods[m].name);
            Renderer::Samples first;
            report.methods[m].add(measure(methods[m], frames, first));
            if (on_view)
                on_view(v, methods[m],
                        {subject_.lines, frames[0].clipped, first.alpha, frames[0].truth},
                        frames[0].camera, oracle_);
        }
    }
    return report;
}

SubjectReport Measurement::styles(const std::vector<Contestant>& styles) {
    SubjectReport report = empty_report();
    for (const Contestant& style : styles) report.styles.push_back({style.name, {}});
    for (std::size_t v = 0; v < subject_.views.size(); ++v) {
        begin_view(v);
        const Moving moving = frames_of(subject_.views[v]);
        report.typical_motion += moving.typical_motion / static_cast<double>(subject_.views.size());
        std::vector<const ClippedLines*> clipped;
        for (const Frame& frame : moving.frames) clipped.push_back(&frame.clipped);
        const Tracks tracks = follow_points(clipped, settings_.size);
        for (std::size_t s = 0; s < styles.size(); ++s) {
            doing(styles[s].name);
            report.styles[s].figures.add(restlessness_of(styles[s], moving.frames, tracks));
        }
    }
    return report;
}

StyledFigures Measurement::restlessness_of(const Contestant& style,
                                           const std::vector<Frame>& frames, const Tracks& tracks) {
    // The first frame must not be averaged with the last frame of another style.
    Contestant unsteady = style;
    unsteady.options.steady = false;
    sample(unsteady, frames[0]);
    std::vector<const ClippedLines*> clipped;
    std::vector<std::vector<float>> drawn, truth;
    std::optional<Textures> textures;
    if (style.options.style.pen.mark != Pen{}.mark) textures = {{}, texture_wavelength};
    for (const Frame& frame : frames) {
        const Renderer::Samples samples = sample(style, frame);
        if (textures) textures->arcs.emplace_back(samples.runs, subject_.lines.segments.size());
        clipped.push_back(&frame.clipped);
        drawn.push_back(shown_samples(
            {frame.clipped, samples.alpha, samples.runs, samples.density, settings_.size}));
        truth.push_back(frame.truth);
        for (float& visibility : truth.back()) visibility = shown(visibility);
    }
    return restlessness(subject_.lines, clipped, tracks, drawn, truth, textures);
}

StudyReport Measurement::study() {
    StudyReport report{subject_.name, {}};
    std::vector<Contestant> settings;
    for (const int depth_scale : {1, 2, 3, 4}) {
        for (const std::uint32_t probes : {1U, 4U, 9U, 16U}) {
            report.points.push_back({probes, depth_scale, {}, {}});
            settings.push_back({fmt::format("{} probes, {}x depth", probes, depth_scale),
                                {.probes = probes,
                                 .depth_scale = depth_scale,
                                 .step = settings_.step,
                                 .cull_hidden = false}});
        }
    }
    const SubjectReport measured = run(settings, {});
    for (std::size_t i = 0; i < settings.size(); ++i) {
        report.points[i].errors = measured.methods[i].errors.all;
        report.points[i].motion = measured.methods[i].motion.all;
    }
    return report;
}

std::vector<IntervalReport> Measurement::intervals(FrameOptions options) {
    std::vector<IntervalReport> reports{{subject_.name, {}}, {subject_.name + ", met", {}}};
    options.intervals = KeptIntervals::all;
    options.draw = false;
    options.steady = false; // every view on its own
    for (std::size_t v = 0; v < subject_.views.size(); ++v) {
        begin_view(v);
        const Camera camera =
            make_camera(subject_.views[v].view(), settings_.size, subject_.lines.bounds);
        const ClippedLines fine = clip_lines(subject_.lines, camera, truth_step_pixels);
        doing("ray casting");
        const std::vector<float> truth = oracle_.visibility(fine, camera, {.rays = 9});
        renderer_.draw(camera, options, canvas_.framebuffer());
        const std::vector<Interval> found = renderer_.read_intervals();
        const auto compared = [&](std::span<const Interval> intervals) {
            return compare_intervals(subject_.lines, fine, settings_.size, truth, intervals);
        };
        reports[0].figures.add(compared(found));
        reports[1].figures.add(compared(met_intervals(subject_.lines, fine, camera, found)));
    }
    return reports;
}

std::vector<PathReport> Measurement::paths(const std::vector<Contestant>& methods,
                                           const ErrorPicture& on_errors) {
    constexpr int picture_scale = 2;
    std::vector<PathReport> reports;
    const ModelTruth model{subject_.mesh, subject_.lines, {}};
    for (std::size_t v = 0; v < subject_.views.size(); ++v) {
        begin_view(v);
        const Camera camera =
            make_camera(subject_.views[v].view(), settings_.size, subject_.lines.bounds);
        doing("ray casting");
        const EdgeTruth truth = model.seen(camera);
        for (const Contestant& method : methods) {
            doing(method.name);
            FrameOptions options = method.options;
            options.steady = false; // every view on its own
            options.cull_hidden = true;
            options.style.pen.join = Join::round; // a long mitre would count as false ink
            FrameOptions intervals = options;
            intervals.depth_scale = 4; // as `draw` has it for paths
            intervals.intervals = KeptIntervals::all;
            intervals.draw = false;
            renderer_.draw(camera, intervals, canvas_.framebuffer());
            const DrawnLines drawn =
                drawn_lines(make_vector_drawing(subject_.lines, camera, renderer_.read_intervals(),
                                                options.style, {.mesh = &subject_.mesh}));
            const Certificate certificate = model.certify(truth, camera, drawn);
            canvas_.clear(glm::vec4{1});
            renderer_.draw(camera, options, canvas_.framebuffer());
            const Image picture{.size = settings_.size, .channels = 4, .pixels = canvas_.read()};
            const DrawingErrors ink = compare_ink(truth, picture);
            reports.push_back({subject_.name + ", " + subject_.views[v].name, method.name,
                               figures_of(certificate, ink)});
            on_errors(v, method.name + "-paths",
                      error_picture(truth, drawn.legs, certificate.narrow, picture_scale));
            on_errors(v, method.name + "-ink", error_picture(picture, ink, picture_scale));
        }
    }
    return reports;
}

OracleReport Measurement::check_oracle() {
    OracleReport report{subject_.name};
    for (std::size_t v = 0; v < subject_.views.size(); ++v) {
        begin_view(v);
        const Camera camera =
            make_camera(subject_.views[v].view(), settings_.size, subject_.lines.bounds);
        const auto views = static_cast<double>(subject_.views.size());
        report.once += mean(frame_at(camera, settings_.rays).truth) / views;
        report.twice += mean(frame_at(camera, 2 * settings_.rays).truth) / views;
    }
    return report;
}

} // namespace lineatlas::bench
