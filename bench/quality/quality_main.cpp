// lineatlas-bench-quality: measures the errors of every method's visibility against ray casting
// (truth.hpp).

#include <algorithm>
#include <cmath>
#include <map>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "command_line/program.hpp"
#include "common/methods.hpp"
#include "glpasses/headless_context.hpp"
#include "io/atomic_file.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/scenes.hpp"
#include "measure.hpp"
#include "study_chart.hpp"

namespace lineatlas::bench {
namespace {

/// Twice the rays may change the mean of alpha* by no more than this.
constexpr double oracle_tolerance = 0.002;

struct Arguments {
    std::vector<std::string> scenes, models;
    std::vector<std::string> ups{"y"};
    std::vector<double> at;
    int frames = 6;
    std::size_t burst = 4;
    std::vector<float> distances{1};
    std::string projection{name_of(Projection::perspective)};
    std::vector<int> size{1024, 768};
    std::vector<std::string> methods;
    std::string quality;
    std::uint32_t probes = 0;
    int depth_scale = 0;
    float step = 2;
    TruthOptions truth;
    bool no_average = false;
    bool no_cache = false;
    bool study = false;
    bool check_oracle = false;
    bool intervals = false;
    bool paths = false;
    std::vector<std::string> styles;
    bool kinds = false;
    std::size_t worst = 0;
    std::string picture;
    int picture_scale = 3;
    std::string json;
    std::vector<std::string> charts;
    DeviceOptions device;
};

/// Styles by name: one per effect, and one with all effects.
const std::map<std::string, Style>& named_styles() {
    static const std::map<std::string, Style> styles = [] {
        const StrokeFilter overshoot{.overshoot = 8, .overshoot_variation = 0.5F};
        const StrokeFilter lengths{.fill_holes = 4, .drop_runs = 4};
        const StrokeFilter halo{.halo = 4};
        const StrokeFilter all{.overshoot = 8, .overshoot_variation = 0.5F, .halo = 4};
        const Density density{.limit = 0.3F};
        return std::map<std::string, Style>{{"overshoot", {.filter = overshoot}},
                                            {"filter", {.filter = lengths}},
                                            {"halo", {.filter = halo}},
                                            {"density", {.density = density}},
                                            {"texture", {.pen = {.mark = "pencil"}}},
                                            {"all", {.filter = all, .density = density}}};
    }();
    return styles;
}
std::vector<std::string> style_names() {
    std::vector<std::string> names;
    for (const auto& [name, style] : named_styles()) names.push_back(name);
    return names;
}
const Style& style_of(const std::string& name) {
    return named_styles().at(name);
}

void set_up(CLI::App& app, Arguments& a) {
    app.add_option("--scene,--scenes", a.scenes,
                   fmt::format("Of {}; may be given again. Default: all, unless there is a --model",
                               fmt::join(scene_names(), ", ")))
        ->delimiter(',');
    auto* model = app.add_option("--model", a.models, "A model file; may be given again");
    app.add_option("--up", a.ups, "Upward axis, x, y or z, of all models or of each in turn")
        ->delimiter(',')
        ->check(CLI::IsMember({"x", "y", "z"}))
        ->needs(model)
        ->capture_default_str();
    auto* at = app.add_option("--at", a.at,
                              "Positions on the camera path, 0 to 1; a model's path is a full turn")
                   ->delimiter(',')
                   ->check(CLI::Range(0.0, 1.0));
    app.add_option("--frames", a.frames, "This many positions, evenly along the path")
        ->check(CLI::PositiveNumber)
        ->excludes(at)
        ->capture_default_str();
    app.add_option("--burst", a.burst,
                   "Consecutive frames from each position on, for sparkle and crawl; 1: none")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    app.add_option("--distance", a.distances,
                   "Times the eye's distance from its target, e.g. 0.5,1,2")
        ->delimiter(',')
        ->check(CLI::PositiveNumber);
    app.add_option("--projection", a.projection,
                   "perspective or orthographic; with --paths the latter looks isometric and from "
                   "the front")
        ->capture_default_str();
    app.add_option("--size", a.size, "WIDTHxHEIGHT")->delimiter('x')->expected(2);
    auto* methods =
        app.add_option("--methods", a.methods,
                       "Of IBlo, IBhi, STlo, SThi, SAlo, SAhi; default all. With --paths of SAlo, "
                       "SAhi and EX; default the last two")
            ->delimiter(',');
    app.add_option("--quality", a.quality, "Only the methods of this quality: low or high")
        ->check(CLI::IsMember({"low", "high"}))
        ->excludes(methods);
    app.add_option("--probes", a.probes, "Depth probes per sample in place of each method's own");
    app.add_option("--depth-scale", a.depth_scale,
                   "Depth texels per pixel and axis in place of each method's own");
    app.add_option("--step", a.step, "Pixels between samples")->capture_default_str();
    auto* average = app.add_flag("--no-average", a.no_average,
                                 "Without the average of visibility over frames in slow motion");
    app.add_option("--rays", a.truth.rays, "Rays per sample")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    app.add_flag("--no-cache", a.no_cache, "Compute the truth even if it is known");
    app.add_flag("--kinds", a.kinds, "Figures per line kind too");
    app.add_option("--worst", a.worst,
                   "Figures of every view and method, with this many of their worst segments")
        ->capture_default_str();
    app.add_option("--picture", a.picture,
                   "Error picture to write; with the method's name and a number if there are "
                   "several");
    app.add_option("--picture-scale", a.picture_scale, "Its pixels per pixel of the view")
        ->check(CLI::Range(1, 16))
        ->capture_default_str();
    auto* study = app.add_flag("--study", a.study,
                               "In place of the methods: the segment atlas with 1 to 16 probes and "
                               "1x to 4x depth (Fig. 6)")
                      ->excludes(methods)
                      ->excludes(average);
    app.add_option("--chart", a.charts,
                   "Curves of the study to write, .svg or .png; may be given again")
        ->needs(study);
    app.add_flag("--check-oracle", a.check_oracle,
                 "In place of the methods: whether twice the rays change the truth")
        ->excludes(study)
        ->excludes(methods);
    app.add_flag("--intervals", a.intervals,
                 "In place of the methods: how right the intervals are that come out of the device")
        ->excludes(study)
        ->excludes(methods);
    app.add_flag(
           "--paths", a.paths,
           "In place of samples: how right drawings are, as paths and as pictures of "
           "pixels, in two views; --picture colours what is false red and what is missed blue")
        ->excludes(study)
        ->excludes(at);
    app.add_option("--styles", a.styles,
                   "In place of the methods: sparkle of what is drawn plain and with each of "
                   "these, of overshoot, halo, density, filter, texture, all")
        ->delimiter(',')
        ->check(CLI::IsMember(style_names()))
        ->excludes(study)
        ->excludes(methods);
    app.add_option("--json", a.json, "Figures to write");
    app.add_option("--compute", a.device.compute, "Backend: opencl or cpp")->capture_default_str();
}

/// Why a method cannot be measured; empty if it can.
std::string_view obstacle(const MethodSpec& spec, bool paths) {
    if (spec.reads_back) return "is SAhi otherwise";
    if (paths)
        return spec.method == Method::atlas || spec.method == Method::exact ? "" : "has no paths";
    return spec.method == Method::opengl || spec.method == Method::exact
               ? "has no visibility samples to measure"
               : "";
}

std::vector<Contestant> contestants(const Arguments& a) {
    for (const std::string& name : a.methods) {
        const std::string_view why = obstacle(method_spec(name), a.paths);
        if (!why.empty()) throw UsageError(fmt::format("--methods: {} {}", name, why));
    }
    std::vector<Contestant> result;
    for (const MethodSpec& spec : method_specs()) {
        if (!obstacle(spec, a.paths).empty()) continue;
        if (!a.methods.empty() && std::ranges::find(a.methods, spec.name) == a.methods.end()) {
            continue;
        }
        if (a.paths && a.methods.empty() && spec.name == "SAlo") continue;
        if (!a.quality.empty() && spec.name.ends_with("hi") != (a.quality == "high")) continue;
        FrameOptions options;
        options.method = spec.method;
        options.probes = a.probes != 0 ? a.probes : spec.probes;
        options.depth_scale = a.depth_scale != 0 ? a.depth_scale : spec.depth_scale;
        options.step = a.step;
        options.steady = !a.no_average;
        options.cull_hidden = false; // every sample is compared
        // Texture coordinates are only computed for marks with a texture.
        if (!a.paths) options.style.pen.mark = "fine";
        result.push_back({std::string{spec.name}, options});
    }
    return result;
}

std::vector<Contestant> style_contestants(const Arguments& a) {
    const MethodSpec& spec = method_spec("SAhi");
    FrameOptions options{.method = spec.method,
                         .probes = a.probes != 0 ? a.probes : spec.probes,
                         .depth_scale = a.depth_scale != 0 ? a.depth_scale : spec.depth_scale,
                         .step = a.step,
                         .cull_hidden = false, // every sample is compared
                         .steady = !a.no_average};
    std::vector<Contestant> result{{"plain", options}};
    for (const std::string& name : a.styles) {
        options.style = style_of(name);
        result.push_back({name, options});
    }
    return result;
}

glm::vec3 axis(const std::string& name) {
    glm::vec3 up{0};
    up[name[0] - 'x'] = 1;
    return up;
}

/// The name of each model: its file's name, or the given path if two files share a name.
std::vector<std::string> model_names(const std::vector<std::string>& paths) {
    std::map<std::string, int> files;
    const auto file = [](const std::string& path) {
        return std::filesystem::path{path}.filename().string();
    };
    for (const std::string& path : paths) ++files[file(path)];
    std::vector<std::string> names;
    for (const std::string& path : paths) {
        names.push_back(files[file(path)] > 1 ? path : file(path));
        if (std::ranges::count(names, names.back()) > 1) {
            throw UsageError("--model: " + path + " is given twice");
        }
    }
    return names;
}

/// Functions that make the subjects. Subjects are made one by one, because all would fill the
/// memory.
std::vector<std::function<Subject()>> subjects(const Arguments& a, glm::ivec2 size) {
    const Projection projection = parse_projection(a.projection);
    const Places places{a.at.empty() ? even_places(a.frames) : a.at, a.distances, projection};
    std::vector<std::function<Subject()>> result;
    std::vector<std::string> scenes = a.scenes;
    if (scenes.empty() && a.models.empty()) {
        scenes.assign(scene_names().begin(), scene_names().end());
    }
    for (const std::string& name : scenes) {
        if (std::ranges::find(scene_names(), name) == scene_names().end()) {
            throw UsageError(fmt::format("--scene: there is no \"{}\"; there is {}", name,
                                         fmt::join(scene_names(), ", ")));
        }
        result.emplace_back([=, still = a.paths] {
            Subject subject = scene_subject(name, places);
            if (still) subject.views = still_views(subject, {0, 1, 0}, size, projection);
            return subject;
        });
    }
    if (a.ups.size() != 1 && a.ups.size() != a.models.size()) {
        throw UsageError(fmt::format("--up: {} axes for {} models; name one, or one for each",
                                     a.ups.size(), a.models.size()));
    }
    const std::vector<std::string> names = model_names(a.models);
    for (std::size_t i = 0; i < a.models.size(); ++i) {
        const std::string path = a.models[i];
        const std::string name = names[i];
        const glm::vec3 up = axis(a.ups[a.ups.size() == 1 ? 0 : i]);
        result.emplace_back([=, still = a.paths] {
            Subject subject = model_subject(path, up, size, places);
            if (still) subject.views = still_views(subject, up, size, projection);
            subject.name = name;
            return subject;
        });
    }
    return result;
}

class Bench {
  public:
    explicit Bench(const Arguments& a)
        : arguments_(a), size_(a.size[0], a.size[1]), methods_(contestants(a)),
          subjects_(subjects(a, size_)) {
        check();
        report_.settings = {size_, a.step, a.truth.rays, a.burst};
    }

    /// Measures everything. Returns true if all checks pass.
    bool run() {
        const gl::HeadlessContext context;
        gl::Canvas canvas{size_};
        for (const auto& make : subjects_) {
            progress_.say("preparing");
            const Subject subject = make();
            Measurement measurement{
                subject, report_.settings, arguments_.device, !arguments_.no_cache,
                canvas,  progress_};
            if (arguments_.study) {
                report_.study.push_back(measurement.study());
            } else if (arguments_.check_oracle) {
                report_.oracle.push_back(measurement.check_oracle());
            } else if (arguments_.intervals) {
                std::ranges::move(measurement.intervals(methods_.back().options),
                                  std::back_inserter(report_.intervals));
            } else if (arguments_.paths) {
                fresh_paths_ = measurement.paths(
                    methods_, [&](std::size_t view, const std::string& what, const Image& picture) {
                        if (!arguments_.picture.empty())
                            write_image(picture_path(subject, what, view), picture);
                    });
                report_.paths.insert(report_.paths.end(), fresh_paths_.begin(), fresh_paths_.end());
            } else if (!arguments_.styles.empty()) {
                report_.subjects.push_back(measurement.styles(style_contestants(arguments_)));
            } else {
                measure(subject, measurement);
            }
            progress_.clear();
            print_last();
        }
        finish();
        return std::ranges::all_of(report_.oracle, [](const OracleReport& oracle) {
            return std::abs(oracle.twice - oracle.once) < oracle_tolerance;
        });
    }

  private:
    /// Reports errors of the command line before minutes of work.
    void check() const {
        if (!arguments_.picture.empty()) check_image_path(arguments_.picture);
        for (const std::string& path : arguments_.charts) check_drawing_path(path);
        if (!arguments_.json.empty()) const AtomicFile writable{arguments_.json};
    }

    void measure(const Subject& subject, Measurement& measurement) {
        report_.subjects.push_back(measurement.run(
            methods_, [&](std::size_t view, const Contestant& method, const ViewSamples& samples,
                          const Camera& camera, const Oracle& oracle) {
                if (arguments_.worst > 0) {
                    progress_.clear();
                    print_view_header();
                    print_view(method.name + " " + subject.views[view].name, compare(samples));
                    print_worst(oracle, samples, camera, arguments_.worst);
                }
                if (!arguments_.picture.empty()) {
                    write_image(picture_path(subject, method.name, view),
                                error_picture(samples, size_, arguments_.picture_scale));
                }
            }));
    }

    std::filesystem::path picture_path(const Subject& subject, const std::string& method,
                                       std::size_t view) const {
        std::filesystem::path path = arguments_.picture;
        std::string stem = path.stem().string();
        if (subjects_.size() > 1) {
            std::string name = subject.name; // may be a path
            std::ranges::replace(name, '/', '_');
            stem += "-" + name;
        }
        if (methods_.size() > 1 || arguments_.paths) stem += "-" + method;
        if (subject.views.size() > 1) stem += fmt::format("-{}", view);
        return path.replace_filename(stem + path.extension().string());
    }

    void print_last() const {
        if (arguments_.study) {
            print_study(report_.study.back());
        } else if (arguments_.check_oracle) {
            const OracleReport& oracle = report_.oracle.back();
            fmt::print("{}: mean alpha* {:.6f}, with twice the rays {:.6f}: {:+.6f}{}\n",
                       oracle.name, oracle.once, oracle.twice, oracle.twice - oracle.once,
                       std::abs(oracle.twice - oracle.once) < oracle_tolerance
                           ? ""
                           : ", more than may be");
        } else if (arguments_.intervals) {
            if (report_.intervals.size() == 2) print_intervals_header();
            for (const IntervalReport& one : std::span{report_.intervals}.last(2)) {
                print_intervals(one);
            }
        } else if (arguments_.paths) {
            if (report_.paths.size() == fresh_paths_.size()) print_paths_header();
            for (const PathReport& one : fresh_paths_) print_paths(one);
        } else if (!arguments_.styles.empty()) {
            print_styles(report_.subjects.back());
        } else {
            print_table(report_.subjects.back(), arguments_.kinds);
        }
        std::fflush(stdout);
    }

    void finish() {
        if (report_.subjects.size() > 1) {
            const SubjectReport total = total_of(report_.subjects);
            if (arguments_.styles.empty())
                print_table(total, arguments_.kinds);
            else
                print_styles(total);
        }
        if (report_.study.size() > 1) {
            report_.study.push_back(total_of(report_.study));
            print_study(report_.study.back());
        }
        if (!arguments_.json.empty()) {
            const std::string text = json_text(report_);
            AtomicFile{arguments_.json}.commit(
                {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
        }
        for (const std::string& path : arguments_.charts) {
            write_drawing(path, study_chart(report_.study));
        }
    }

    const Arguments& arguments_;
    glm::ivec2 size_;
    std::vector<Contestant> methods_;
    std::vector<std::function<Subject()>> subjects_;
    Progress progress_;
    Report report_;
    std::vector<PathReport> fresh_paths_; ///< reports of the last subject
};

int run(int argc, char** argv) {
    CLI::App app{"Measures the line visibility of all methods against ray casting",
                 "lineatlas-bench-quality"};
    Arguments arguments;
    set_up(app, arguments);
    if (const std::optional<int> code = parse(app, argc, argv)) return *code;
    return Bench{arguments}.run() ? 0 : 1;
}

} // namespace
} // namespace lineatlas::bench

int main(int argc, char** argv) {
    return lineatlas::run_program(argc, argv, lineatlas::bench::run, "lineatlas-bench-quality");
}
