#include "measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <utility>

#include <epoxy/gl.h>

#include "core/median.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

constexpr double slow_ms = 1000;        // slower contestants draw fewer frames
constexpr double slow_budget_ms = 30e3; // the time of all frames of a slow contestant, about
constexpr std::size_t fewest_frames = 3;
constexpr std::size_t warm_up_frames = 4;

struct FrameTime {
    double ms, cpu_ms;
};

FrameTime timed(const Contestant& contestant, const Camera& camera, Measured& result) {
    glFinish();
    const std::clock_t cpu = std::clock();
    const auto start = std::chrono::steady_clock::now();
    const FrameStats stats = contestant.draw(camera, false);
    glFinish();
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    result.samples = stats.samples;
    result.runs = stats.runs;
    return {elapsed.count(), 1e3 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC};
}

/// The state of measuring one contestant, beside its result.
struct Plan {
    std::size_t frames = 0; ///< to draw; at most one per viewpoint
    bool slow = false;
    std::vector<std::pair<std::string, std::vector<double>>> stages;
};

/// True if a contestant with `frames` frames draws at viewpoint `i` of `count`. The frames are
/// spread evenly.
bool takes_part(std::size_t i, std::size_t count, std::size_t frames) {
    return (i + 1) * frames / count != i * frames / count;
}

/// Draws frames along the whole path, because tables grow at views with more samples than before.
Plan warm_up(const Contestant& contestant, std::span<const Viewpoint> viewpoints,
             Measured& result) {
    Plan plan;
    try {
        std::vector<double> times;
        for (std::size_t i = 0; i < warm_up_frames; ++i) {
            const std::size_t at = i * viewpoints.size() / warm_up_frames;
            times.push_back(timed(contestant, viewpoints[at].camera, result).ms);
            if (i > 0 && times.back() > slow_ms) break; // the first frame includes compiling
        }
        const double ms = times.size() > 1 ? median({times.begin() + 1, times.end()}) : times[0];
        plan.slow = ms > slow_ms;
        plan.frames = viewpoints.size();
        if (plan.slow) {
            const auto affordable = static_cast<std::size_t>(slow_budget_ms / ms);
            plan.frames = std::min(plan.frames, std::max(fewest_frames, affordable));
        }
    } catch (const Error& error) {
        result.failure = error.what();
    }
    return plan;
}

/// Draws the frame before the one that counts. A real program draws with one method. Its data are
/// in the caches, and its last frame resembles the next one. Here the other contestants have filled
/// the caches, and the last view was far away. Frames of more than a second need no such frame.
void settle(const Contestant& contestant, const Viewpoint& viewpoint, const Plan& plan) {
    if (!plan.slow) contestant.draw(viewpoint.before, false);
}

double paired_ratio(std::span<const double> a, std::span<const double> b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        const double ratio = a[i] / b[i];
        if (!std::isnan(ratio)) ratios.push_back(ratio);
    }
    return median(std::move(ratios));
}

void add_stages(const Contestant& contestant, const Camera& camera, Plan& plan) {
    for (const StageTime& stage : contestant.draw(camera, true).stages) {
        auto known = std::ranges::find(plan.stages, stage.name,
                                       &std::pair<std::string, std::vector<double>>::first);
        if (known == plan.stages.end()) {
            plan.stages.push_back({stage.name, {}});
            known = plan.stages.end() - 1;
        }
        known->second.push_back(stage.milliseconds);
    }
}

} // namespace

std::size_t Measured::frames() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(frame_ms, [](double ms) { return !std::isnan(ms); }));
}

double Measured::ms() const {
    std::vector<double> drawn;
    std::ranges::copy_if(frame_ms, std::back_inserter(drawn),
                         [](double ms) { return !std::isnan(ms); });
    return median(std::move(drawn));
}

double time_ratio(const Measured& a, const Measured& b) {
    std::vector<double> a_ms, b_ms;
    for (std::size_t i = 0; i < std::min(a.frame_ms.size(), b.frame_ms.size()); ++i) {
        if (std::isnan(a.frame_ms[i]) || std::isnan(b.frame_ms[i])) continue;
        a_ms.push_back(a.frame_ms[i]);
        b_ms.push_back(b.frame_ms[i]);
    }
    return median(std::move(a_ms)) / median(std::move(b_ms));
}

double paired_ratio(const Measured& a, const Measured& b) {
    return paired_ratio(a.frame_ms, b.frame_ms);
}

double paired_cpu_ratio(const Measured& a, const Measured& b) {
    return paired_ratio(a.cpu_ms, b.cpu_ms);
}

std::vector<Measured> measure(std::span<const Contestant> contestants,
                              std::span<const Viewpoint> viewpoints,
                              const ProgressCallback& progress) {
    const std::size_t count = viewpoints.size();
    std::vector<Measured> results(contestants.size());
    std::vector<Plan> plans(contestants.size());
    for (std::size_t i = 0; i < contestants.size(); ++i) {
        results[i].name = contestants[i].name;
        results[i].frame_ms.assign(count, std::numeric_limits<double>::quiet_NaN());
        results[i].cpu_ms = results[i].frame_ms;
        progress(0, count, contestants[i].name);
        plans[i] = warm_up(contestants[i], viewpoints, results[i]);
    }

    for (std::size_t at = 0; at < count; ++at) {
        for (std::size_t turn = 0; turn < contestants.size(); ++turn) {
            const std::size_t i = (at + turn) % contestants.size();
            if (!takes_part(at, count, plans[i].frames)) continue;
            progress(at, count, contestants[i].name);
            settle(contestants[i], viewpoints[at], plans[i]);
            const FrameTime time = timed(contestants[i], viewpoints[at].camera, results[i]);
            results[i].frame_ms[at] = time.ms;
            results[i].cpu_ms[at] = time.cpu_ms;
        }
        // Stages only show where time goes, so every third view is enough.
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            const std::size_t stage_frames = std::max<std::size_t>(1, plans[i].frames / 3);
            if (!contestants[i].has_stages || plans[i].frames == 0) continue;
            if (!takes_part(at, count, stage_frames)) continue;
            settle(contestants[i], viewpoints[at], plans[i]);
            add_stages(contestants[i], viewpoints[at].camera, plans[i]);
        }
    }
    progress(count, count, "");
    for (std::size_t i = 0; i < contestants.size(); ++i) {
        for (auto& [name, times] : plans[i].stages) {
            results[i].stages.push_back({name, median(std::move(times))});
        }
    }
    return results;
}

} // namespace lineatlas::bench
