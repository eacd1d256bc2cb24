// Every kernel is measured: by the launches of the rows, and by `bench kernels --list`. Every row
// runs as it does when it is timed. Sanitizers then find memory that a job uses and does not own.

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "command_line/scratch.hpp"
#include "common.hpp"
#include "compare/figures.hpp"
#include "environment_variable.hpp"

namespace lineatlas::bench {
namespace {

using Names = std::set<std::string>;

void add_kernels(compute::CommandLog& log, Names& names) {
    for (const compute::CommandTime& command : log.read()) names.insert(std::string{command.name});
}

Devices devices_here(bool of_gpu = false) {
    compute::OpenClDevice device = compute::find_opencl_devices("opencl").front();
    compute::Tuning tuning = compute::tuning_for(device);
    tuning.scan_tiles = true; // `cpp` already runs the form with chunks
    tuning.depth_each = tuning.stroke_pixels = tuning.face_lists = of_gpu;
    return make_devices(compute::make_opencl_backend(device, {}, tuning));
}

/// Runs the rows and adds the kernels that they launch to `seen`.
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

/// Compares the program with itself. Both take all turns, and the two files pair them.
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

/// A process with `--watch`. The destructor ends it.
class Watching {
  public:
    explicit Watching(const std::filesystem::path& kernels)
        : program_(popen(("LINEATLAS_KERNEL_DIR=" + kernels.string() +
                          " sh -c 'echo $$; exec " LINEATLAS_BENCH_KERNELS
                          " --watch pyramid --size 16384'")
                             .c_str(),
                         "r")) {
        pid_ = static_cast<pid_t>(std::stol(line()));
    }
    ~Watching() {
        ::kill(pid_, SIGINT);
        pclose(program_);
    }
    Watching(const Watching&) = delete;
    Watching& operator=(const Watching&) = delete;

    /// The next line of its output; empty after its end.
    std::string line() {
        std::array<char, 1024> text{};
        return std::fgets(text.data(), text.size(), program_) != nullptr ? text.data() : "";
    }

  private:
    FILE* program_;
    pid_t pid_ = 0;
};

TEST(Rows, AKernelIsMeasuredAgainWhenItIsWritten) {
    const Scratch scratch;
    const auto kernels = scratch.folder / "kernels";
    std::filesystem::copy(std::filesystem::path{LINEATLAS_SOURCE_DIR} / "kernels", kernels,
                          std::filesystem::copy_options::recursive);
    const auto file = kernels / "pyramid.cl";
    std::ostringstream original;
    original << std::ifstream{file}.rdbuf();
    const auto rewrite = [&](const std::string& from, const std::string& to) {
        std::string text = original.str();
        const std::size_t place = text.find(from);
        ASSERT_NE(place, std::string::npos) << from;
        std::ofstream{file} << text.replace(place, from.size(), to);
    };
    Watching watching{kernels};
    EXPECT_NE(watching.line().find("pyramid at 16384 elements"), std::string::npos);
    EXPECT_NE(watching.line().find("to last"), std::string::npos);
    EXPECT_NE(watching.line().find(" - "), std::string::npos) << "there is nothing before";
    rewrite("KERNEL(", "/* as before */ KERNEL(");
    const std::string again = watching.line();
    EXPECT_EQ(again.find(" - "), std::string::npos) << again;
    EXPECT_EQ(again.find_first_not_of(" 0123456789.\n"), std::string::npos) << again;
    rewrite("KERNEL(", "what KERNEL(");
    EXPECT_NE(watching.line().find("does not build"), std::string::npos);
    rewrite("max(", "min(");
    EXPECT_NE(watching.line().find("gave a wrong result"), std::string::npos);
    rewrite("KERNEL(", "KERNEL(");
    EXPECT_EQ(watching.line().find_first_not_of(" 0123456789.\n"), std::string::npos);
}

TEST(Rows, WatchingNeedsAFolderAndAName) {
    EXPECT_NE(printed("--watch pyramid", 2).find("needs LINEATLAS_KERNEL_DIR"), std::string::npos);
    const test::EnvironmentVariable kernels{"LINEATLAS_KERNEL_DIR",
                                            std::string{LINEATLAS_SOURCE_DIR} + "/kernels"};
    EXPECT_NE(printed("--watch nothing", 2).find("no row measures \"nothing\""), std::string::npos);
}

} // namespace
} // namespace lineatlas::bench
