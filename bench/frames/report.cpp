#include "report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "effects.hpp"
#include "profiling.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::array<std::string_view, 6> paper_scenes{"clevis", "house",  "ship",
                                                       "office", "ship+s", "office+s"};
struct PaperRow {
    std::string_view method;
    std::array<PaperFigure, 6> figures; ///< fps 0: the paper has no figure
};
constexpr PaperFigure none{"-", 0};
constexpr std::array<PaperRow, 7> paper_rows{{
    {"OGL", {{{"1000+", 1000}, {"300+", 300}, {"42", 42}, {"32", 32}, none, none}}},
    {"IBlo", {{{"87", 87}, {"24", 24}, {"9.6", 9.6}, {"7.0", 7.0}, none, none}}},
    {"IBhi", {{{"20", 20}, {"3.4", 3.4}, {"0.5", 0.5}, {"0.4", 0.4}, none, none}}},
    {"STlo", {{{"900+", 900}, {"146", 146}, {"26", 26}, {"28", 28}, {"19", 19}, {"23", 23}}}},
    {"SThi", {{{"300+", 300}, {"75", 75}, {"24", 24}, {"25", 25}, {"19", 19}, {"21", 21}}}},
    {"SAlo", {{{"400+", 400}, {"119", 119}, {"33", 33}, {"29", 29}, {"23", 23}, {"24", 24}}}},
    {"SAhi", {{{"200+", 200}, {"76", 76}, {"25", 25}, {"24", 24}, {"22", 22}, {"21", 21}}}},
}};

std::string_view without_suffix(std::string_view scene) {
    if (scene.ends_with("+s")) scene.remove_suffix(2);
    return scene;
}

const Measured* find(const std::vector<Measured>& all, std::string_view name) {
    const auto found = std::ranges::find(all, name, &Measured::name);
    return found == all.end() || !found->valid() ? nullptr : &*found;
}

/// The frame rate of `fast` over that of `slow`.
std::optional<double> speed_ratio(const SceneResult* scene, std::string_view fast,
                                  std::string_view slow) {
    if (scene == nullptr) return std::nullopt;
    const Measured* a = scene->method(fast);
    const Measured* b = scene->method(slow);
    if (a == nullptr || b == nullptr) return std::nullopt;
    return time_ratio(*b, *a);
}

/// The frame time on `more` over that on `less`.
std::optional<double> frame_cost(const SceneResult* more, const SceneResult* less,
                                 std::string_view method) {
    if (more == nullptr || less == nullptr) return std::nullopt;
    const Measured* a = more->method(method);
    const Measured* b = less->method(method);
    if (a == nullptr || b == nullptr) return std::nullopt;
    return time_ratio(*a, *b);
}

/// The frame time without the depth pass. The pass is known from the stages alone: the atlas leaves
/// out hidden triangles, so the benchmark's pass with all triangles is another one.
std::optional<double> without_depth(const SceneResult* scene) {
    const Measured* frame = scene == nullptr ? nullptr : scene->method("SAhi");
    if (frame == nullptr) return std::nullopt;
    const auto depth = std::ranges::find(frame->stages, "depth", &StageTime::name);
    if (depth == frame->stages.end()) return std::nullopt;
    return frame->ms() - depth->milliseconds;
}

} // namespace

bool SceneResult::is_of_table() const {
    return !name.starts_with("hidden ") && !name.starts_with("far ") &&
           !name.starts_with("office ") && name != effects_row && name != profile_row;
}

const Measured* SceneResult::method(std::string_view method_name) const {
    return find(methods, method_name);
}

const Measured* SceneResult::depth_at(int scale) const {
    return find(depth, scale == 1 ? "1x" : "2x");
}

const SceneResult* Report::scene(std::string_view name) const {
    const auto found = std::ranges::find(scenes, name, &SceneResult::name);
    return found == scenes.end() ? nullptr : &*found;
}

const Measured* Report::opengl_for(std::string_view scene_name) const {
    const SceneResult* plain = scene(without_suffix(scene_name));
    return plain == nullptr ? nullptr : plain->method("OGL");
}

std::optional<PaperFigure> paper_figure(std::string_view scene, std::string_view method) {
    const auto column = std::ranges::find(paper_scenes, scene);
    const auto row = std::ranges::find(paper_rows, method, &PaperRow::method);
    if (column == paper_scenes.end() || row == paper_rows.end()) return std::nullopt;
    const PaperFigure figure =
        row->figures[static_cast<std::size_t>(column - paper_scenes.begin())];
    if (figure.fps == 0) return std::nullopt;
    return figure;
}

std::optional<double> paper_to_opengl(std::string_view scene, std::string_view method) {
    const auto figure = paper_figure(scene, method);
    const auto opengl = paper_figure(without_suffix(scene), "OGL");
    if (!figure || !opengl) return std::nullopt;
    return figure->fps / opengl->fps;
}

std::vector<Goal> goals(const Report& report) {
    struct Target {
        std::string_view method, yardstick, scene;
        double must, aim;
    };
    constexpr std::array<Target, 14> targets{{
        {"SAhi", "OGL", "ship", 0.70, 1.0},
        {"SAhi", "OGL", "office", 0.70, 1.0},
        {"SAlo", "OGL", "ship", 0.95, 1.5},
        {"SAlo", "OGL", "office", 0.95, 1.5},
        {"SAhi", "OGL", "clevis", 0.30, 0.5},
        {"SAhi", "OGL", "house", 0.30, 0.5},
        {"SAhi", "IBhi", "ship", 10, 60},
        {"SAhi", "IBhi", "office", 10, 60},
        {"SThi", "OGL", "ship", 0.25, 0.6},
        {"SThi", "OGL", "office", 0.25, 0.6},
        {"EX", "SAhi", "clevis", 0.77, 1.43},
        {"EX", "SAhi", "house", 0.77, 1.43},
        {"EX", "SAhi", "ship", 0.77, 1.43},
        {"EX", "SAhi", "office", 0.77, 1.43},
    }};
    std::vector<Goal> result;
    for (const Target& t : targets) {
        Goal goal{std::string{t.method} + "/" + std::string{t.yardstick},
                  std::string{t.scene},
                  {},
                  speed_ratio(report.scene(t.scene), t.method, t.yardstick),
                  t.must,
                  t.aim};
        const auto figure = paper_figure(t.scene, t.method);
        const auto yardstick = paper_figure(t.scene, t.yardstick);
        if (figure && yardstick) goal.paper = figure->fps / yardstick->fps;
        result.push_back(std::move(goal));
    }
    Goal hidden{"SAhi 3x/1x segments", "hidden", {}, {}, 2.0, 1.2, true};
    const auto once = without_depth(report.scene("hidden 1x"));
    const auto thrice = without_depth(report.scene("hidden 3x"));
    if (once && thrice) hidden.ours = *thrice / *once;
    result.push_back(std::move(hidden));
    const auto exact_cost = [&](std::string_view more, std::string_view less) {
        return frame_cost(report.scene(more), report.scene(less), "EX");
    };
    result.push_back(
        {"EX 3x/1x segments", "hidden", {}, exact_cost("hidden 3x", "hidden 1x"), 1.3, 1, true});
    result.push_back(
        {"EX 20x/1x as far", "ship", {}, exact_cost("far 20x", "far 1x"), 2.5, 1, true});
    Goal moving{"SAhi moving/still", "office", {}, {}, 0.9, 1};
    if (const SceneResult* still = report.scene("office still")) {
        const Measured* frames = report.scene("office moving")->method("SAhi");
        moving.ours = time_ratio(*still->method("SAhi"), *frames);
    }
    result.push_back(std::move(moving));
    for (const std::string_view name : stroke_effects()) {
        const double most = name == "all" ? 1.4 : 1.12;
        result.push_back(
            {"with " + std::string{name}, "ship", {}, effect_cost(report, name), most, 1, true});
    }
    Goal profiling{"profiled", "ship", {}, {}, 1.02, 1, true};
    if (const auto cost = profiling_cost(report)) profiling.ours = cost->time;
    result.push_back(std::move(profiling));
    return result;
}

} // namespace lineatlas::bench
