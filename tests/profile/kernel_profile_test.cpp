// The reasons for the times of kernels: made up profiles and counts become rows and four outputs.

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lineatlas/kernel_profile.hpp"
#include "words_of.hpp"

namespace lineatlas::test {
namespace {

ProfileEvent launch(const char* stage, const char* name, std::int64_t start,
                    std::int64_t nanoseconds) {
    return {ProfileTrack::compute, stage, name, start, start + nanoseconds, 100, 64, 1};
}

/// Eleven frames. Each launches `scan` twice, in two stages, and `tiny` for the shortest possible
/// time.
std::vector<FrameProfile> frames() {
    std::vector<FrameProfile> all;
    for (std::int64_t i = 0; i < 11; ++i) {
        FrameProfile frame;
        frame.events = {launch("atlas", "atlas", 0, 100'000 + 1000 * i),
                        launch("chain", "scan", 200'000, 10'000),
                        launch("scan", "scan", 300'000, 40'000),
                        launch("cull", "tiny", 400'000, 200),
                        launch("cull", "small", 500'000, 500),
                        launch("halo", "idle", 600'000, 50'000),
                        launch("pens", "unknown", 700'000, 20'000)};
        frame.events.push_back({ProfileTrack::compute, "atlas", "read", 800'000, 900'000});
        frame.events.push_back({ProfileTrack::host, "atlas", "atlas", 0, 900'000});
        all.push_back(frame);
    }
    return all;
}

// A copy moves 10 bytes a nanosecond; the device does 100 operations a nanosecond.
constexpr Roofs roofs{10, 100};

std::vector<LaunchCounts> counts() {
    return {{"atlas", 100'000, 9'000'000}, {"scan", 80'000, 1000},
            {"scan", 300'000, 4000},       {"tiny", 64, 10},
            {"small", 4000, 10},           {"idle", 10'000, 20'000}};
}

const KernelTime& kernel(const std::vector<KernelTime>& all, const std::string& stage,
                         const std::string& name) {
    const auto found = std::ranges::find_if(
        all, [&](const KernelTime& time) { return time.stage == stage && time.name == name; });
    EXPECT_NE(found, all.end()) << stage << ' ' << name;
    return *found;
}

TEST(KernelProfile, TellsWhatALaunchTakes) {
    const std::vector<KernelTime> all = kernel_times(frames(), counts(), roofs);
    EXPECT_EQ(all.size(), 7U); // rows exist neither for the transfer nor for the host
    const KernelTime& atlas = kernel(all, "atlas", "atlas");
    EXPECT_EQ(&atlas, &all.front());
    EXPECT_EQ(atlas.launches, 11U);
    EXPECT_EQ(atlas.median, 105'000);
    EXPECT_EQ(atlas.p10, 101'000);
    EXPECT_EQ(atlas.p90, 109'000);
    EXPECT_EQ(atlas.sum, 11 * 105'000);
    EXPECT_DOUBLE_EQ(atlas.gigaops_per_second, 9000.0 / 105);
}

TEST(KernelProfile, LaunchesAreCountedInTheirOrder) {
    const std::vector<KernelTime> all = kernel_times(frames(), counts(), roofs);
    EXPECT_EQ(kernel(all, "chain", "scan").bytes, 80'000);
    EXPECT_EQ(kernel(all, "scan", "scan").bytes, 300'000);
    EXPECT_EQ(kernel(all, "scan", "scan").operations, 4000);
}

/// Rates are those of each launch: here one is large and two are small.
TEST(KernelProfile, RatesAreOfEachLaunch) {
    FrameProfile frame;
    frame.events = {launch("strokes", "tiles", 0, 1000), launch("strokes", "tiles", 2000, 1000),
                    launch("strokes", "tiles", 4000, 100'000)};
    const std::vector<KernelTime> all = kernel_times(
        std::vector{frame},
        std::vector<LaunchCounts>{{"tiles", 1000, 0}, {"tiles", 1000, 0}, {"tiles", 100'000, 0}},
        roofs);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].median, 1000);
    EXPECT_EQ(all[0].bytes, 34'000);
    EXPECT_DOUBLE_EQ(all[0].gigabytes_per_second, 1);
}

/// A device that counts may divide a kernel's work into launches in another way.
TEST(KernelProfile, LaunchesOfOtherCountsShareBytesEqually) {
    std::vector<LaunchCounts> three = counts();
    three.push_back({"scan", 100'000, 1000});
    const std::vector<KernelTime> all = kernel_times(frames(), three, roofs);
    EXPECT_EQ(kernel(all, "chain", "scan").bytes, 240'000);
    EXPECT_EQ(kernel(all, "scan", "scan").operations, 3000);
}

TEST(KernelProfile, NamesTheLimitOfEachKernel) {
    const std::vector<KernelTime> all = kernel_times(frames(), counts(), roofs);
    EXPECT_EQ(kernel(all, "atlas", "atlas").bound, Bound::arithmetic); // 86 of 100
    EXPECT_EQ(kernel(all, "chain", "scan").bound, Bound::memory);      // 8 of 10
    EXPECT_EQ(kernel(all, "scan", "scan").bound, Bound::memory);       // 7.5 of 10
    EXPECT_EQ(kernel(all, "cull", "tiny").bound, Bound::launch);
    EXPECT_EQ(kernel(all, "cull", "small").bound, Bound::launch); // 8 of 10, but too short
    EXPECT_EQ(kernel(all, "halo", "idle").bound, Bound::latency);
    EXPECT_EQ(kernel(all, "pens", "unknown").bound, Bound::unknown);
    // No kernel is near a roof that is unknown.
    EXPECT_EQ(kernel(kernel_times(frames(), counts(), {10, 0}), "atlas", "atlas").bound,
              Bound::latency);
    EXPECT_TRUE(kernel_times({}, counts(), roofs).empty());
}

TEST(KernelProfile, WritesTheTableAndTheCsv) {
    const std::vector<KernelTime> all = kernel_times(frames(), counts(), roofs);
    const std::string table = kernel_table(all, roofs);
    const std::vector<std::string> row{"chain",  "scan",  "11",    "0.0100", "0.0100",
                                       "0.0100", "0.080", "8.00",  "80.0",   "0.00",
                                       "0.10",   "0.1",   "memory"};
    EXPECT_EQ(words_of(table, "chain "), row) << table;
    EXPECT_NE(table.find("a copy 10.00 GB/s; products and sums 100.0 Gop/s"), std::string::npos);
    const std::string csv = kernel_csv(all, roofs);
    EXPECT_NE(csv.find("\nchain,scan,11,10.000,10.000,10.000,80000,1000,8.000,10.000,0.100,100.000,"
                       "memory\n"),
              std::string::npos)
        << csv;
    const auto json = nlohmann::json::parse(kernel_json(all, roofs));
    EXPECT_EQ(json["roofs"]["copy_gb_per_s"], 10);
    EXPECT_EQ(json["roofs"]["arithmetic_gop_per_s"], 100);
    ASSERT_EQ(json["kernels"].size(), 7U);
    EXPECT_EQ(json["kernels"][0], (nlohmann::json{{"stage", "atlas"},
                                                  {"kernel", "atlas"},
                                                  {"launches", 11},
                                                  {"median_us", 105.0},
                                                  {"p10_us", 101.0},
                                                  {"p90_us", 109.0},
                                                  {"bytes", 100'000.0},
                                                  {"operations", 9'000'000.0},
                                                  {"gb_per_s", all[0].gigabytes_per_second},
                                                  {"gop_per_s", all[0].gigaops_per_second},
                                                  {"bound", "arithmetic"}}));
}

TEST(KernelProfile, RooflineHasADotForEachKernelThatComputes) {
    const std::string svg = roofline_svg(kernel_times(frames(), counts(), roofs), roofs);
    std::size_t dots = 0;
    for (std::size_t at = svg.find("<circle"); at != svg.npos; at = svg.find("<circle", at + 1))
        ++dots;
    EXPECT_EQ(dots, 6U); // the figures of pens are unknown
    EXPECT_NE(svg.find("<title>chain scan: memory</title>"), std::string::npos);
    EXPECT_NE(svg.find("100 Gop/s; a copy: 10.0 GB/s"), std::string::npos);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_EQ(roofline_svg({}, roofs).find("<circle"), std::string::npos);
}

} // namespace
} // namespace lineatlas::test
