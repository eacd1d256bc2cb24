#include "draw_stats.hpp"
#include "io/standard_streams.hpp"

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "core/median.hpp"

namespace lineatlas::apps {
namespace {

void print_lines(const LineSet& lines) {
    std::vector<std::string> kinds;
    for (std::size_t i = 0; i < line_kind_names.size(); ++i) {
        if (lines.kind_counts.at(i) > 0)
            kinds.push_back(fmt::format("{} {}", lines.kind_counts.at(i), line_kind_names.at(i)));
    }
    if (!kinds.empty()) print_output(fmt::format("segments by kind: {}\n", fmt::join(kinds, ", ")));
    const LeftOut& left_out = lines.left_out;
    print_output(fmt::format(
        "left out: {} creases that are noise; {} seams, and parts of {} more; {} cracks\n",
        left_out.noisy_creases, left_out.seams, left_out.cut_seams, left_out.cracks));
    print_output(fmt::format(
        "extraction: creases {:.1f} ms, seams {:.1f} ms, intersections {:.1f} ms, "
        "ridges {:.1f} ms\n",
        lines.times.creases, lines.times.seams, lines.times.intersections, lines.times.ridges));
}

} // namespace

void measure_and_print(MeasuredFrame frame, const Renderer& renderer) {
    auto& [name, lines, options, repeat, draw] = frame;
    std::vector<double> frame_times;
    std::vector<std::string> stage_order;
    std::map<std::string, std::vector<double>> stage_times;
    FrameStats stats;
    // Whole frames and stages have frames of their own: waiting between stages slows a frame down.
    for (int i = 0; i < repeat; ++i) {
        options.measure_stages = false;
        const auto start = std::chrono::steady_clock::now();
        draw(options);
        glFinish();
        const std::chrono::duration<double, std::milli> elapsed =
            std::chrono::steady_clock::now() - start;
        frame_times.push_back(elapsed.count());

        options.measure_stages = true;
        stats = draw(options);
        for (const StageTime& stage : stats.stages) {
            if (!stage_times.contains(stage.name)) stage_order.push_back(stage.name);
            stage_times[stage.name].push_back(stage.milliseconds);
        }
    }
    print_output(fmt::format("{}: {} triangles ({} drawn), {} segments\n", name, stats.triangles,
                             stats.triangles_drawn, stats.segments));
    print_lines(lines);
    print_output(fmt::format("{}\n", renderer.description()));
    print_output(fmt::format("{} samples, {} visible runs\n", stats.samples, stats.runs));
    const auto per = [](std::uint64_t bytes, std::uint32_t count) {
        return static_cast<double>(bytes) / std::max(1U, count);
    };
    print_output(fmt::format(
        "device memory: {:.1f} bytes per segment, {:.1f} per sample, {:.1f} per visible run, "
        "{:.1f} MiB mesh\n",
        per(stats.segment_bytes, stats.segments), per(stats.sample_bytes, stats.samples),
        per(stats.run_bytes, stats.runs), static_cast<double>(stats.mesh_bytes) / (1 << 20)));
    print_output(
        fmt::format("{:<14}{:8.2f} ms (median of {})\n", "frame", median(frame_times), repeat));
    for (const std::string& stage : stage_order) {
        print_output(fmt::format("  {:<12}{:8.2f} ms\n", stage, median(stage_times[stage])));
    }
}

} // namespace lineatlas::apps
