#include "draw_stats.hpp"
#include "io/standard_streams.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "core/median.hpp"
#include "lineatlas/compute_device.hpp"

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
        "left out: {} creases that are noise, {} seams, parts of {} more; closed: {} cracks\n",
        left_out.noisy_creases, left_out.seams, left_out.cut_seams, left_out.cracks));
    print_output(fmt::format(
        "extraction: creases {:.1f} ms, seams {:.1f} ms, intersections {:.1f} ms, "
        "ridges {:.1f} ms\n",
        lines.times.creases, lines.times.seams, lines.times.intersections, lines.times.ridges));
}

/// Prints the tables that take most memory.
void print_tables(std::vector<compute::TableMemory> tables) {
    constexpr std::ptrdiff_t most = 6;
    const auto shown = std::min(most, std::ssize(tables));
    std::ranges::partial_sort(tables, tables.begin() + shown, std::greater{},
                              &compute::TableMemory::bytes);
    std::vector<std::string> lines;
    for (const compute::TableMemory& table : std::span{tables}.first(shown)) {
        lines.push_back(
            fmt::format("{} {:.1f}", table.name, static_cast<double>(table.bytes) / (1 << 20)));
    }
    print_output(fmt::format("largest tables, MiB: {}\n", fmt::join(lines, ", ")));
}

/// Prints the times of a kind of frames, if there are any.
void print_frames(const char* kind, const std::vector<double>& times) {
    if (times.empty()) return;
    print_output(
        fmt::format("{:<14}{:8.2f} ms (median of {})\n", kind, median(times), times.size()));
}

} // namespace

void measure_and_print(MeasuredFrame frame, const Renderer& renderer) {
    auto& [name, lines, options, repeat, draw] = frame;
    std::vector<double> whole_frames, frames_by_stages;
    std::vector<std::string> stage_order;
    std::map<std::string, std::vector<double>> stage_times;
    FrameStats stats;
    // Whole frames and stages are measured in different frames, because waiting between stages
    // slows a frame down.
    for (int left = repeat; left > 0; --left) {
        options.measure_stages = left % 2 == 1; // the last frame is by stages, so a single frame
                                                // has them
        const auto start = std::chrono::steady_clock::now();
        stats = draw(options);
        glFinish();
        const std::chrono::duration<double, std::milli> elapsed =
            std::chrono::steady_clock::now() - start;
        (options.measure_stages ? frames_by_stages : whole_frames).push_back(elapsed.count());
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
    print_tables(renderer.tables());
    print_frames("whole frames", whole_frames);
    print_frames("by stages", frames_by_stages);
    for (const std::string& stage : stage_order) {
        print_output(fmt::format("  {:<12}{:8.2f} ms\n", stage, median(stage_times[stage])));
    }
}

} // namespace lineatlas::apps
