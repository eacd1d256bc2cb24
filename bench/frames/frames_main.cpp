// lineatlas-bench-frames: frame rates of all methods on all scenes, beside the paper's Table 1.

#include <algorithm>
#include <memory>

#include <CLI/App.hpp>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "chart.hpp"
#include "command_line/device_options.hpp"
#include "command_line/program.hpp"
#include "common/progress.hpp"
#include "compare/turns.hpp"
#include "effects.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "io/atomic_file.hpp"
#include "json.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/scenes.hpp"
#include "profiling.hpp"
#include "row.hpp"
#include "subjects.hpp"
#include "table.hpp"

namespace lineatlas::bench {
namespace {

struct Arguments {
    std::vector<std::string> scenes{"clevis", "house", "ship",   "office",  "ship+s", "office+s",
                                    "hidden", "far",   "moving", "effects", "profile"};
    std::vector<std::string> methods;
    std::string model;
    std::string up = "y";
    std::size_t frames = 30;
    std::vector<int> size{1024, 768};
    std::string json;
    std::vector<std::string> charts;
    DeviceOptions device;
    Turns turns;
};

void set_up(CLI::App& app, Arguments& a) {
    auto* scenes =
        app.add_option(
               "--scenes", a.scenes,
               fmt::format("Of {}, each also with silhouettes as in ship+s; hidden: the cost of "
                           "hidden segments; far: of a model from 20 times as far; moving: of "
                           "moving objects; effects: of a style's effects; profile: of profiling",
                           fmt::join(scene_names(), ", ")))
            ->delimiter(',')
            ->capture_default_str();
    app.add_option("--methods", a.methods,
                   "Of OGL, IBlo, IBhi, STlo, SThi, SAlo, SAhi, EX; default all")
        ->delimiter(',');
    auto* model =
        app.add_option("--model", a.model, "A model file in place of the scenes")->excludes(scenes);
    app.add_option("--up", a.up, "The model's upward axis: x, y or z")
        ->check(CLI::IsMember({"x", "y", "z"}))
        ->needs(model)
        ->capture_default_str();
    app.add_option("--frames", a.frames,
                   "Views along the camera path; methods over a second a frame draw fewer")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    app.add_option("--size", a.size, "WIDTHxHEIGHT; default 1024x768")
        ->delimiter('x')
        ->expected(2)
        ->check(CLI::Range(1, 1000000));
    app.add_option("--json", a.json, "Figures to write");
    app.add_option("--chart", a.charts, "Bar chart to write, .svg or .png; may be given again");
    declare_device(app, a.device);
    a.turns.declare(app);
}

class Bench {
  public:
    explicit Bench(const Arguments& a)
        : arguments_(a), size_(a.size[0], a.size[1]), canvas_(size_) {
        report_.size = size_;
        report_.gl = fmt::format("{}, OpenGL {}", gl_string(GL_RENDERER), gl_string(GL_VERSION));
    }

    Report run() {
        if (!arguments_.model.empty()) {
            glm::vec3 up{0};
            up[arguments_.up[0] - 'x'] = 1;
            for (const bool silhouettes : {false, true}) {
                begin(arguments_.model + (silhouettes ? "+s" : ""));
                measure_rows(
                    {model_subject(arguments_.model, up, silhouettes, size_, arguments_.frames)},
                    drawn(methods(silhouettes)));
            }
        } else {
            for (const std::string& name : arguments_.scenes) {
                begin(name);
                if (name == "hidden") {
                    measure_rows(hidden_subjects(size_, arguments_.frames), drawn({"SAhi", "EX"}));
                } else if (name == "far") {
                    measure_rows(far_subjects(size_, arguments_.frames), drawn({"SAhi", "EX"}));
                } else if (name == "moving") {
                    measure_rows(moving_subjects(size_, arguments_.frames), drawn({"SAhi"}));
                } else if (name == effects_row) {
                    Subject ship = scene_subject("ship+s", size_, arguments_.frames);
                    ship.name = effects_row;
                    measure_rows({ship}, effect_drawings());
                } else if (name == profile_row) {
                    Subject ship = scene_subject("ship+s", size_, arguments_.frames);
                    ship.name = profile_row;
                    measure_rows({ship}, profile_drawings());
                } else {
                    measure_rows({scene_subject(name, size_, arguments_.frames)},
                                 drawn(methods(name.ends_with("+s"))));
                }
            }
        }
        progress_.clear();
        return report_;
    }

  private:
    static std::string gl_string(GLenum name) {
        return reinterpret_cast<const char*>(glGetString(name));
    }

    void begin(const std::string& scene) {
        scene_ = scene;
        progress_.say(fmt::format("{}: preparing", scene_));
    }

    void show(std::size_t done, std::size_t total, std::string_view method) {
        if (done == total) return;
        progress_.detail(done == 0
                             ? fmt::format("{}: warming up {}", scene_, method)
                             : fmt::format("{}: {} of {} frames, {}", scene_, done, total, method));
    }

    std::vector<std::string_view> methods(bool silhouettes) const {
        const auto& names = arguments_.methods;
        std::vector<std::string_view> result;
        for (const MethodSpec& spec : method_specs()) {
            const bool chosen = names.empty() || std::ranges::find(names, spec.name) != names.end();
            if (chosen && (spec.silhouettes || !silhouettes)) result.push_back(spec.name);
        }
        return result;
    }

    static std::vector<Drawn> drawn(const std::vector<std::string_view>& methods) {
        std::vector<Drawn> result;
        for (const std::string_view name : methods) {
            result.push_back({std::string{name}, method_options(method_spec(name))});
        }
        return result;
    }

    /// Measures subjects with the same viewpoints against each other.
    void measure_rows(const std::vector<Subject>& subjects, const std::vector<Drawn>& drawings) {
        std::vector<std::unique_ptr<Row>> rows;
        std::vector<Contestant> contestants;
        for (const Subject& subject : subjects) {
            rows.push_back(std::make_unique<Row>(subject, drawings, arguments_.device, canvas_));
            report_.device = rows.back()->description();
            const auto& more = rows.back()->contestants();
            contestants.insert(contestants.end(), more.begin(), more.end());
        }
        const std::vector<Measured> measured =
            measure(contestants, subjects.front().viewpoints,
                    [&](std::size_t done, std::size_t total, std::string_view name) {
                        show(done, total, name);
                    });
        std::span<const Measured> rest = measured;
        for (const auto& row : rows) {
            const std::size_t count = row->contestants().size();
            report_.scenes.push_back(row->result(rest.first(count)));
            rest = rest.subspan(count);
        }
    }

    const Arguments& arguments_;
    glm::ivec2 size_;
    gl::Canvas canvas_;
    Progress progress_;
    std::string scene_; ///< being measured
    Report report_;
};

/// Reports errors of the command line before minutes of work.
void check(const Arguments& a) {
    for (const std::string& name : a.methods) method_spec(name);
    for (const std::string& name : a.scenes) {
        const std::string plain = name.ends_with("+s") ? name.substr(0, name.size() - 2) : name;
        if (name == "hidden" || name == "far" || name == "moving" || name == effects_row ||
            name == profile_row || std::ranges::find(scene_names(), plain) != scene_names().end()) {
            continue;
        }
        throw UsageError(fmt::format("--scenes: there is no \"{}\"; there is {}, each also with "
                                     "+s, hidden, far, moving, effects, and profile",
                                     name, fmt::join(scene_names(), ", ")));
    }
    for (const std::string& path : a.charts) check_drawing_path(path);
    if (!a.json.empty()) const AtomicFile writable{a.json};
}

void bench_frames(const Arguments& a) {
    check(a);
    const gl::HeadlessContext context;
    const Report report = Bench{a}.run();
    print_report(report);
    if (!a.json.empty()) write_json(a.json, report);
    for (const std::string& path : a.charts) write_drawing(path, chart(report));
}

int run(int argc, char** argv) {
    CLI::App app{"Measures frame rates of all methods beside the paper's Table 1",
                 "lineatlas-bench-frames"};
    Arguments arguments;
    set_up(app, arguments);
    if (const std::optional<int> code = parse(app, argc, argv)) return *code;
    if (arguments.turns.given()) {
        arguments.turns.run(Turns::others(argc, argv), {""}, arguments.json);
        return 0;
    }
    bench_frames(arguments);
    return 0;
}

} // namespace
} // namespace lineatlas::bench

int main(int argc, char** argv) {
    return lineatlas::run_program(argc, argv, lineatlas::bench::run, "lineatlas-bench-frames");
}
