// Every kernel is measured: by the rows' own launches, and as `bench kernels --list` tells. Every
// row runs, as it does when it is timed: with sanitizers they see what a job uses that it does not
// own.

#include <array>
#include <cstdio>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "command_line/scratch.hpp"
#include "common.hpp"
#include "compare/figures.hpp"

namespace lineatlas::bench {
namespace {

using Names = std::set<std::string>;

void add_kernels(compute::CommandLog& log, Names& names) {
    for (const compute::CommandTime& command : log.read()) names.insert(std::string{command.name});
}

Devices devices_here(bool of_gpu = false) {
    compute::OpenClDevice device = compute::find_opencl_devices("opencl").front();
    compute::Tuning tuning = compute::tuning_for(device);
    tuning.scan_tiles = true; // C++ runs the chunks
    tuning.depth_each = tuning.stroke_pixels = tuning.face_lists = of_gpu;
    return make_devices(compute::make_opencl_backend(device, {}, tuning));
}

/// Adds the kernels that rows launch.
void run(const Devices& devices, const Rows& rows, Names& seen) {
    const auto opencl_log = devices.opencl->begin_log(), cpp_log = devices.cpp->begin_log();
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        EXPECT_NO_THROW(seconds_of(row.prepare(1U << 14U)));
    }
    add_kernels(*opencl_log, seen);
    add_kernels(*cpp_log, seen);
    devices.opencl->end_log();
    devices.cpp->end_log();
}

TEST(Rows, EveryRowRunsAndEveryKernelIsInOne) {
    Names seen;
    const Devices devices = devices_here(), of_gpu = devices_here(true);
    run(devices, all_rows(devices), seen);
    for (const auto& rows : {depth_rows, strokes_rows, exact_rows}) run(of_gpu, rows(of_gpu), seen);
    for (const compute::Kernel& kernel : compute::all_kernels()) {
        EXPECT_TRUE(seen.contains(std::string{kernel.name})) << kernel.name;
    }
}

TEST(Rows, StrokesOfSoManySegmentsThatTheyCoverOneAnother) {
    const Devices devices = devices_here();
    for (const Row& row : strokes_rows(devices)) {
        if (!row.name.ends_with("/cpp")) continue;
        EXPECT_NO_THROW(row.prepare(1U << 20U));
    }
}

TEST(Rows, TheListHasEveryStageOnBothDevices) {
    FILE* program = popen(LINEATLAS_BENCH_KERNELS " --list", "r");
    ASSERT_NE(program, nullptr);
    Names listed;
    std::array<char, 256> line{};
    while (std::fgets(line.data(), line.size(), program) != nullptr) {
        std::string name{line.data()};
        name.pop_back(); // the line's end
        listed.insert(name);
    }
    EXPECT_EQ(pclose(program), 0);
    for (const compute::Kernel& kernel : compute::all_kernels()) {
        const std::string stage{kernel.stage};
        EXPECT_TRUE(listed.contains(stage + "/ours")) << stage;
        EXPECT_TRUE(listed.contains(stage + "/cpp")) << stage;
    }
}

std::string printed(const std::string& arguments, int exit_code) {
    FILE* program = popen((LINEATLAS_BENCH_KERNELS " " + arguments + " 2>&1").c_str(), "r");
    std::string text;
    std::array<char, 256> part{};
    while (std::fgets(part.data(), part.size(), program) != nullptr) text += part.data();
    EXPECT_EQ(WEXITSTATUS(pclose(program)), exit_code) << text;
    return text;
}

/// The program beside itself: both take all turns, and the files pair them.
TEST(Rows, TwoBuildsTakeTurns) {
    const Scratch scratch;
    const std::string own = (scratch.folder / "own.json").string();
    const std::string other = (scratch.folder / "other.json").string();
    const std::string text =
        printed("--interleave " LINEATLAS_BENCH_KERNELS " --turns=3 --benchmark_min_time=0.001 "
                "--benchmark_filter='copy/memcpy/(16384|65536)/' --json " +
                    own + " --json-other " + other,
                0);
    EXPECT_NE(text.find("copy/memcpy/16384 "), std::string::npos) << text;
    EXPECT_NE(text.find("0 slower, 0 faster, "), std::string::npos) << text;
    EXPECT_NE(text.find("3 turns: 12 are needed"), std::string::npos) << text;
    const Figures after = read_figures(own), before = read_figures(other);
    EXPECT_EQ(after.turns, before.turns);
    for (const Figures& figures : {after, before}) {
        ASSERT_EQ(figures.rows.size(), 2U);
        for (const auto& [name, values] : figures.rows) EXPECT_EQ(values.size(), 3U) << name;
        EXPECT_EQ(figures.quiet.size(), 2U);
    }
}

TEST(Rows, TurnsNeedAnotherBuild) {
    EXPECT_NE(printed("--interleave /nonexistent --benchmark_filter=copy/memcpy/16384", 2)
                  .find("--interleave \"/nonexistent\""),
              std::string::npos);
    EXPECT_NE(printed("--interleave / --benchmark_filter=nothing", 2).find("no row is chosen"),
              std::string::npos);
}

} // namespace
} // namespace lineatlas::bench
