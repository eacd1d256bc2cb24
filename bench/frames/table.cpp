#include "table.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "effects.hpp"
#include "profiling.hpp"

namespace lineatlas::bench {
namespace {

constexpr int label_width = 10;
constexpr int cell_width = 15;

/// Words for headings; empty if no scene is in the paper.
const char* papers_too(const Report& report) {
    const bool any = std::ranges::any_of(report.scenes, [](const SceneResult& scene) {
        return paper_figure(scene.name, "SAhi").has_value();
    });
    return any ? " (the paper's)" : "";
}

/// A number with three digits, whatever its magnitude.
std::string number(double value) {
    if (value >= 99.95) return fmt::format("{:.0f}", value);
    if (value >= 9.995) return fmt::format("{:.1f}", value);
    return fmt::format("{:.2f}", value);
}

std::string count(std::uint32_t value) {
    if (value < 1000) return fmt::format("{}", value);
    if (value < 10000) return fmt::format("{:.1f}k", value / 1000.0);
    return fmt::format("{:.0f}k", value / 1000.0);
}

template <class Cell>
void print_row(const Report& report, std::string_view label, const Cell& cell) {
    std::string line = fmt::format("{:<{}}", label, label_width);
    for (const SceneResult& scene : report.scenes) {
        if (scene.is_of_table()) line += fmt::format("{:>{}}", cell(scene), cell_width);
    }
    fmt::print("{}\n", line);
}

bool measured_anywhere(const Report& report, std::string_view method) {
    return std::ranges::any_of(report.scenes, [&](const SceneResult& scene) {
        return scene.is_of_table() && scene.method(method) != nullptr;
    });
}

template <class Cell>
void print_methods(const Report& report, const Cell& cell) {
    for (const MethodSpec& spec : method_specs()) {
        if (!measured_anywhere(report, spec.name)) continue;
        print_row(report, spec.name,
                  [&](const SceneResult& scene) { return cell(scene, spec.name); });
    }
}

void print_frame_rates(const Report& report) {
    fmt::print("\nFrames per second, median{}\n", papers_too(report));
    print_row(report, "", [](const SceneResult& scene) { return scene.name; });
    print_row(report, "# tris", [](const SceneResult& scene) { return count(scene.triangles); });
    print_row(report, "# seg", [](const SceneResult& scene) { return count(scene.segments); });
    print_methods(report, [](const SceneResult& scene, std::string_view method) -> std::string {
        const Measured* measured = scene.method(method);
        if (measured == nullptr) return "-";
        const auto paper = paper_figure(scene.name, method);
        return number(measured->fps()) + (paper ? fmt::format(" ({})", paper->text) : "");
    });
}

void print_ratios(const Report& report) {
    const bool any = std::ranges::any_of(report.scenes, [&](const SceneResult& scene) {
        return report.opengl_for(scene.name) != nullptr;
    });
    if (!any) return;
    fmt::print("\nFrame rate over OGL's, for +s over OGL's without silhouettes{}\n",
               papers_too(report));
    print_row(report, "", [](const SceneResult& scene) { return scene.name; });
    print_methods(report, [&](const SceneResult& scene, std::string_view method) -> std::string {
        const Measured* measured = scene.method(method);
        const Measured* opengl = report.opengl_for(scene.name);
        if (measured == nullptr || opengl == nullptr) return "-";
        const auto paper = paper_to_opengl(scene.name, method);
        return number(time_ratio(*opengl, *measured)) + (paper ? " (" + number(*paper) + ")" : "");
    });
}

void print_times(const Report& report) {
    fmt::print(
        "\nMilliseconds per frame, median (frames measured); depth: nothing but all triangles\n");
    const auto cell = [](const Measured* measured) -> std::string {
        if (measured == nullptr) return "-";
        return fmt::format("{} ({})", number(measured->ms()), measured->frames());
    };
    print_row(report, "", [](const SceneResult& scene) { return scene.name; });
    for (const int scale : {1, 2}) {
        print_row(report, fmt::format("depth {}x", scale),
                  [&](const SceneResult& scene) { return cell(scene.depth_at(scale)); });
    }
    print_methods(report, [&](const SceneResult& scene, std::string_view method) {
        return cell(scene.method(method));
    });
}

void print_stages(const Report& report) {
    fmt::print("\nStages in milliseconds (with a wait after each, so they add up to more)\n");
    for (const SceneResult& scene : report.scenes) {
        for (const Measured& measured : scene.methods) {
            if (measured.stages.empty()) continue;
            std::string line = fmt::format("{:<{}}{:<6}", scene.name, label_width, measured.name);
            for (const StageTime& stage : measured.stages) {
                line += fmt::format(" {} {}", stage.name, number(stage.milliseconds));
            }
            fmt::print("{}\n", line);
        }
    }
}

/// Prints the rows of two subjects that were measured against each other.
void print_pair(const Report& report, std::string_view first, std::string_view second,
                std::string_view what) {
    if (report.scene(first) == nullptr || report.scene(second) == nullptr) return;
    fmt::print("\n{}\n", what);
    for (const SceneResult* scene : {report.scene(first), report.scene(second)}) {
        std::string line = fmt::format("{:<{}}{} triangles, {} segments", scene->name, label_width,
                                       count(scene->triangles), count(scene->segments));
        for (const Measured& measured : scene->methods) {
            if (!measured.valid()) continue;
            line +=
                fmt::format("; {} {} ms, {} samples, {} runs", measured.name, number(measured.ms()),
                            count(measured.samples), count(measured.runs));
        }
        fmt::print("{}\n", line);
    }
}

void print_effects(const Report& report) {
    const SceneResult* effects = report.scene(effects_row);
    if (effects == nullptr) return;
    fmt::print("\nEffects on the ship: milliseconds per frame, over the frame without any\n");
    for (const Measured& measured : effects->methods) {
        const auto cost = effect_cost(report, measured.name);
        if (cost) fmt::print("{:<14}{:>8}{:>8.2f}\n", measured.name, number(measured.ms()), *cost);
    }
}

void print_profiling(const Report& report) {
    const auto cost = profiling_cost(report);
    if (!cost) return;
    fmt::print("\nProfiling the ship: a frame takes {:.3f} times as long and {:.3f} times the CPU "
               "time;\nthe same of two without, which are equal: {:.3f} and {:.3f}\n",
               cost->time, cost->cpu, cost->time_noise, cost->cpu_noise);
    fmt::print("Stages of a profiled frame add up to {} ms of {} ms: {:.1f} %\n",
               number(cost->stages_ms), number(cost->frame_ms),
               100 * cost->stages_ms / cost->frame_ms);
}

void print_goals(const Report& report) {
    const std::vector<Goal> all = goals(report);
    if (std::ranges::none_of(all, [](const Goal& goal) { return goal.ours.has_value(); })) return;
    fmt::print("\n{:<21}{:<8}{:>7}{:>8}{:>7}{:>6}\n", "Ratio", "scene", "paper", "ours", "must",
               "aim");
    for (const Goal& goal : all) {
        if (!goal.ours) continue;
        const char* verdict = goal.reaches(goal.aim)    ? "aim reached"
                              : goal.reaches(goal.must) ? "must reached"
                                                        : "MISSED";
        const char* sign = goal.at_most ? "<" : ">";
        fmt::print("{:<21}{:<8}{:>7}{:>8}{:>7}{:>6}  {}\n", goal.what, goal.scene,
                   goal.paper ? number(*goal.paper) : "-", number(*goal.ours),
                   fmt::format("{}{:g}", sign, goal.must), fmt::format("{}{:g}", sign, goal.aim),
                   verdict);
    }
}

} // namespace

void print_report(const Report& report) {
    fmt::print("{}\n{}, {}x{} pixels\n", report.device, report.gl, report.size.x, report.size.y);
    print_frame_rates(report);
    print_ratios(report);
    print_times(report);
    print_stages(report);
    print_pair(report, "hidden 1x", "hidden 3x",
               "Hidden segments: the ship before a wall, and with two more ships behind the wall");
    print_pair(report, "far 1x", "far 20x",
               "The ship filling the picture, and from 20 times as far");
    print_effects(report);
    print_profiling(report);
    print_goals(report);
    for (const SceneResult& scene : report.scenes) {
        for (const Measured& measured : scene.methods) {
            if (measured.failure.empty()) continue;
            fmt::print("{} on {} was not measured: {}\n", measured.name, scene.name,
                       measured.failure);
        }
    }
}

} // namespace lineatlas::bench
