// The reasons for the times of kernels: made up profiles and counts become rows and five outputs.

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lineatlas/kernel_profile.hpp"
#include "words_of.hpp"

namespace lineatlas::test {
namespace {

using Json = nlohmann::json;

ProfileEvent launch(const char* stage, const char* name, std::int64_t start,
                    std::int64_t nanoseconds) {
    return {ProfileTrack::compute, stage, name, start, start + nanoseconds, 100, 64, 1};
}

/// What a driver tells of the kernel `atlas`, and of no other.
constexpr KernelResources resources{256, 32, 4096, 16, 40, 1638};

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

/// The CPU's events: of `atlas` all, of `scan` its time alone.
std::vector<PerfCounts> perf() {
    return {{"atlas", 1000, 1500, 3000, 6000, 500, resources},
            {"scan", 1000, 2000},
            {"scan", 1000, 500},
            {"idle", 1000, {}, {}, {}, {}, {64, 8}}};
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

TEST(KernelProfile, TellsWhatTheCpuCounted) {
    const std::vector<KernelTime> all = kernel_times(frames(), counts(), roofs, perf());
    const KernelTime& atlas = kernel(all, "atlas", "atlas");
    EXPECT_EQ(atlas.cores, 1.5);
    EXPECT_EQ(atlas.cycles, 3000);
    EXPECT_EQ(atlas.instructions, 6000);
    EXPECT_EQ(atlas.cache_misses, 500);
    EXPECT_EQ(kernel(all, "chain", "scan").cores, 2); // launches are told apart
    EXPECT_EQ(kernel(all, "scan", "scan").cores, 0.5);
    EXPECT_FALSE(kernel(all, "scan", "scan").cycles);
    EXPECT_FALSE(kernel(all, "cull", "tiny").cores);
    EXPECT_EQ(atlas.resources, resources);
    EXPECT_FALSE(kernel(all, "halo", "idle").cores); // as on a GPU
    EXPECT_EQ(kernel(all, "halo", "idle").resources.largest_group, 64U);
    // Launches of another number share the events equally.
    std::vector<PerfCounts> three = perf();
    three.push_back(three.front());
    const std::vector<KernelTime> shared = kernel_times(frames(), counts(), roofs, three);
    EXPECT_EQ(kernel(shared, "atlas", "atlas").instructions, 12'000);
}

TEST(KernelProfile, WritesTheTables) {
    const std::string table = kernel_table(kernel_times(frames(), counts(), roofs, perf()), roofs);
    const std::vector<std::string> times{"chain",  "scan",  "11",    "0.0100", "0.0100",
                                         "0.0100", "0.080", "8.00",  "80.0",   "0.00",
                                         "0.10",   "0.1",   "memory"};
    EXPECT_EQ(words_of(table, "chain "), times) << table;
    EXPECT_NE(table.find("a copy 10.00 GB/s; products and sums 100.0 Gop/s\n\n"),
              std::string::npos);
    const std::string second = table.substr(table.find("\n\n") + 2);
    const std::vector<std::string> atlas{"atlas", "atlas", "1.50", "0.01", "2.00", "0.50",
                                         "4096",  "16",    "32",   "256",  "40",   "1638"};
    EXPECT_EQ(words_of(second, "atlas "), atlas) << second;
    const std::vector<std::string> scan{"scan", "scan", "0.50", "-", "-", "-",
                                        "-",    "-",    "-",    "-", "-", "-"};
    EXPECT_EQ(words_of(second, "scan "), scan) << second;
    const std::vector<std::string> tiny{"cull", "tiny", "-", "-", "-", "-",
                                        "-",    "-",    "-", "-", "-", "-"};
    EXPECT_EQ(words_of(second, "cull          tiny"), tiny) << second;
}

TEST(KernelProfile, WritesTheCsv) {
    const std::string csv = kernel_csv(kernel_times(frames(), counts(), roofs, perf()), roofs);
    for (const char* row :
         {"\nchain,scan,11,10.000,10.000,10.000,80000,1000,8.000,10.000,0.100,100.000,memory,2.0,,,"
          ",,,,,,\n",
          ",arithmetic,1.5,3000.0,6000.0,500.0,256,32,4096,16,40,1638\n",
          "\npens,unknown,11,20.000,20.000,20.000,0,0,0.000,10.000,0.000,100.000,unknown,,,,,,,,,,"
          "\n"})
        EXPECT_NE(csv.find(row), std::string::npos) << row << csv;
    // Every row has as many fields as the heading.
    std::istringstream lines{csv};
    for (std::string line; std::getline(lines, line);)
        EXPECT_EQ(std::ranges::count(line, ','), 22) << line;
}

/// The figures of `atlas` by their keys.
Json figures_of_atlas(const KernelTime& atlas) {
    return {{"launches", 11},
            {"median_us", 105.0},
            {"p10_us", 101.0},
            {"p90_us", 109.0},
            {"bytes", 100'000.0},
            {"operations", 9'000'000.0},
            {"gb_per_s", atlas.gigabytes_per_second},
            {"gop_per_s", atlas.gigaops_per_second},
            {"bound", "arithmetic"},
            {"cores", 1.5},
            {"cycles", 3000.0},
            {"instructions", 6000.0},
            {"cache_misses", 500.0},
            {"largest_group", 256},
            {"group_multiple", 32},
            {"local_bytes", 4096},
            {"private_bytes", 16},
            {"registers", 40},
            {"resident_items", 1638}};
}

TEST(KernelProfile, WritesTheJson) {
    const std::vector<KernelTime> all = kernel_times(frames(), counts(), roofs, perf());
    const auto json = Json::parse(kernel_json(all, roofs));
    EXPECT_EQ(json["roofs"]["copy_gb_per_s"], 10);
    EXPECT_EQ(json["roofs"]["arithmetic_gop_per_s"], 100);
    ASSERT_EQ(json["kernels"].size(), 7U);
    Json expected = figures_of_atlas(all[0]);
    expected.update({{"stage", "atlas"}, {"kernel", "atlas"}});
    EXPECT_EQ(json["kernels"][0], expected);
}

TEST(KernelProfile, WritesTheTrace) {
    const std::vector<KernelTime> all = kernel_times(frames(), counts(), roofs, perf());
    const Json trace = Json::parse(kernel_trace(frames(), all, "device"));
    std::size_t launches = 0;
    for (const Json& event : trace["traceEvents"]) {
        const Json& own = event["args"];
        if (!own.contains("items")) {
            EXPECT_FALSE(own.contains("kernel")) << event;
            continue;
        }
        ++launches;
        if (event["name"] != "atlas") continue;
        EXPECT_EQ(own["kernel"], figures_of_atlas(all[0]));
    }
    EXPECT_EQ(launches, 77U);
    for (const Json& event : Json::parse(profile_trace(frames(), "device"))["traceEvents"])
        EXPECT_FALSE(event["args"].contains("kernel"));
}

TEST(KernelProfile, RooflineHasADotForEachKernelThatComputes) {
    const std::string svg = roofline_svg(kernel_times(frames(), counts(), roofs, perf()), roofs);
    std::size_t dots = 0;
    for (std::size_t at = svg.find("<circle"); at != svg.npos; at = svg.find("<circle", at + 1))
        ++dots;
    EXPECT_EQ(dots, 6U); // the figures of pens are unknown
    EXPECT_NE(svg.find("<title>chain scan: memory\nlaunches: 11\n"), std::string::npos) << svg;
    EXPECT_NE(svg.find("\ncores: 1.5\ncycles: 3000\n"), std::string::npos) << svg;
    EXPECT_NE(svg.find("\nlocal_bytes: 4096\nprivate_bytes: 16\n"), std::string::npos) << svg;
    EXPECT_NE(svg.find("100 Gop/s; a copy: 10.0 GB/s"), std::string::npos);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_EQ(roofline_svg({}, roofs).find("<circle"), std::string::npos);
}

} // namespace
} // namespace lineatlas::test
