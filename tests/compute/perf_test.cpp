// The CPU's events: counted for all threads, and noted for each launch. Events of the system's own
// stand in for those of the processor, which virtual machines do not offer.

#include <atomic>
#include <thread>

#include <gtest/gtest.h>
#include <linux/perf_event.h>

#include "compute/kernels.hpp"
#include "compute/perf/perf_device.hpp"
#include "compute/transfer.hpp"

namespace lineatlas::test {
namespace {

using namespace compute;

constexpr PerfEvent nanoseconds{PERF_TYPE_SOFTWARE, PERF_COUNT_SW_TASK_CLOCK};
constexpr PerfEvent faults{PERF_TYPE_SOFTWARE, PERF_COUNT_SW_PAGE_FAULTS};
constexpr PerfEvent of_the_system[] = {nanoseconds, faults, nanoseconds};
constexpr PerfEvent unknown[] = {nanoseconds, {PERF_TYPE_SOFTWARE, 12345}};

/// Touches that many pages for the first time.
void touch_pages(std::size_t count) {
    constexpr std::size_t page = 4096;
    const auto memory = std::make_unique_for_overwrite<volatile char[]>(count * page);
    for (std::size_t i = 0; i < count; ++i) memory[i * page] = 1;
}

class Perf : public testing::Test {
  protected:
    void SetUp() override {
        const PerfEvents events{of_the_system};
        if (!events.refusal().empty()) GTEST_SKIP() << events.refusal();
    }
};

TEST_F(Perf, CountsWhatAllThreadsDo) {
    std::atomic<bool> go = false;
    std::thread before{[&] {
        go.wait(false);
        touch_pages(20'000);
    }};
    const PerfEvents events{of_the_system};
    const std::vector<PerfReading> begin = events.read();
    go = true;
    go.notify_all();
    before.join();
    const std::vector<std::uint64_t> first = events.since(begin);
    const std::vector<PerfReading> middle = events.read();
    std::thread{[] { touch_pages(20'000); }}.join();
    const std::vector<std::uint64_t> second = events.since(middle);
    ASSERT_EQ(second.size(), 3U);
    constexpr std::uint64_t fewest = 30; // if a page had 2 MB
    EXPECT_GT(first[1], fewest) << "of a thread that is there";
    EXPECT_GT(second[1], fewest) << "of a thread that began later";
    EXPECT_GT(first[0], 0U);
    EXPECT_GT(second[2], 0U);
}

TEST_F(Perf, SaysWhyNothingIsCounted) {
    const PerfEvents events{unknown};
    EXPECT_FALSE(events.refusal().empty());
    EXPECT_TRUE(events.read().empty());
}

/// Without /proc.
TEST_F(Perf, NeedsToKnowTheThreads) {
    const PerfEvents events{of_the_system, "/there/is/no/such/folder"};
    EXPECT_NE(events.refusal().find("/there/is/no/such/folder"), std::string::npos);
    EXPECT_TRUE(events.read().empty());
}

/// A counter that shares the processor with others counts part of the time.
TEST(PerfReadings, ScaleTheDifference) {
    // Scaled up by themselves they are 2000 and 1200.
    const std::vector<PerfReading> before{{1000, 200, 100}, {7, 50, 50}};
    const std::vector<PerfReading> after{{1100, 240, 220}, {9, 80, 80}};
    EXPECT_EQ(events_between(before, after, 2), (std::vector<std::uint64_t>{33, 2}));
    EXPECT_EQ(events_between(before, before, 2), (std::vector<std::uint64_t>{0, 0}));
}

TEST(PerfReadings, AddUpOverThreads) {
    const std::vector<PerfReading> before{{10, 5, 5}, {20, 5, 5}, {0, 0, 0}, {1, 0, 0}};
    const std::vector<PerfReading> after{{11, 6, 6}, {22, 6, 6}, {8, 8, 4}, {1, 0, 0}};
    EXPECT_EQ(events_between(before, after, 2), (std::vector<std::uint64_t>{1 + 16, 2}));
    // A reading that failed is none.
    EXPECT_EQ(events_between(before, std::vector<PerfReading>(4), 2),
              (std::vector<std::uint64_t>{0, 0}));
}

/// What the device notes of a launch of `pyramid`.
PerfCounts counted(std::span<const PerfEvent> events, const char* kind) {
    std::vector<PerfCounts> counts;
    const auto device = make_perf_device(make_device(kind), events, counts);
    const auto depth = to_device(*device, std::vector<float>(64 * 32, 0.5F));
    const auto tiles = device->allocate(8 * sizeof(float));
    const PyramidParameters parameters{.depth_size = {64, 32}, .tile_count = {4, 2}};
    const std::span<const std::byte> bytes{reinterpret_cast<const std::byte*>(&parameters),
                                           sizeof parameters};
    const std::array<Buffer*, 2> tables{depth.get(), tiles.get()};
    device->launch({kernel_of<kernels::pyramid>(), bytes, tables, 8, 1});
    EXPECT_EQ(read_back<float>(*device, *tiles, 8), std::vector<float>(8, 0.5F)) << kind;
    EXPECT_EQ(counts.size(), 1U);
    return counts.back();
}

TEST_F(Perf, NotesTheEventsOfEachLaunch) {
    for (const char* kind : {"cpp", "opencl"}) {
        const PerfCounts all = counted(of_the_system, kind);
        EXPECT_EQ(all.kernel, "pyramid");
        EXPECT_GT(all.time, 0U);
        ASSERT_TRUE(all.cpu_time);
        EXPECT_GT(*all.cpu_time, 0U);
        ASSERT_TRUE(all.cycles && all.instructions && all.cache_misses) << kind;
        EXPECT_GT(*all.cycles, 0U); // of three events the first and the last are equal here
        EXPECT_GT(*all.cache_misses, 0U);
    }
}

/// PoCL tells of every kernel, the device cpp of none.
TEST_F(Perf, NotesWhatTheDriverTells) {
    EXPECT_EQ(counted(of_the_system, "cpp").resources, KernelResources{});
    const KernelResources told = counted(of_the_system, "opencl").resources;
    EXPECT_GE(told.largest_group, 64U);
    EXPECT_GE(told.multiple, 1U);
    EXPECT_EQ(told.local_bytes, 0U);
}

TEST_F(Perf, TimesLaunchesWithoutEvents) {
    const PerfCounts alone = counted(unknown, "cpp");
    EXPECT_GT(alone.time, 0U);
    EXPECT_TRUE(alone.cpu_time);
    EXPECT_FALSE(alone.cycles || alone.instructions || alone.cache_misses);
}

/// Either the processor's events are there, or one line says why they are not.
TEST_F(Perf, KindOfDeviceHasEventsOrAReason) {
    register_perf_device();
    register_perf_device(); // a second call does nothing
    take_perf_counts();
    const auto device = make_device("perf");
    EXPECT_EQ(device->description(), make_device("cpp")->description() + ", perf");
    const std::string why = why_no_perf_events();
    EXPECT_EQ(why.find('\n'), std::string::npos);
    EXPECT_EQ(why.empty(), !PerfEvents{cpu_events()}.read().empty()) << why;
}

} // namespace
} // namespace lineatlas::test
