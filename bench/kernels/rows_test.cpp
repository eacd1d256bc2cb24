// Every kernel is measured: by the rows' own launches, and as `bench kernels --list` tells.

#include <array>
#include <cstdio>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "common.hpp"

namespace lineatlas::bench {
namespace {

using Names = std::set<std::string>;

/// The kernels that a device runs while rows of these names are prepared, which checks their
/// results.
void add_kernels(const Rows& rows, const std::string& way, compute::Device& device, Names& names) {
    const auto log = device.begin_log();
    for (const Row& row : rows) {
        if (row.name.ends_with(way)) row.prepare(1U << 14U);
    }
    for (const compute::CommandTime& command : log->read()) names.insert(std::string{command.name});
    device.end_log();
}

TEST(Rows, EveryKernelIsInOne) {
    compute::OpenClDevice device = compute::find_opencl_devices("opencl").front();
    compute::Tuning tuning = compute::tuning_for(device);
    tuning.scan_tiles = true; // C++ runs the chunks
    const Devices devices = make_devices(compute::make_opencl_backend(device, {}, tuning));
    const Rows rows = all_rows(devices);
    Names seen;
    add_kernels(rows, "/ours", *devices.opencl, seen);
    add_kernels(rows, "/cpp", *devices.cpp, seen);
    for (const compute::Kernel& kernel : compute::all_kernels()) {
        EXPECT_TRUE(seen.contains(std::string{kernel.name})) << kernel.name;
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

} // namespace
} // namespace lineatlas::bench
