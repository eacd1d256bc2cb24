// The sizes of launches and their bytes a second, in the logs of devices and in the three outputs
// of a profile.

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "compute/stages/stages.hpp"
#include "lineatlas/profile.hpp"
#include "words_of.hpp"

namespace lineatlas::test {
namespace {

using Json = nlohmann::json;

/// A kernel of 0.5 ms that moves 4 GB/s, and a transfer; a copy moves 16 GB/s.
std::vector<FrameProfile> two_commands() {
    using enum ProfileTrack;
    FrameProfile frame;
    frame.number = 7;
    frame.start = 1000;
    frame.end = 1'001'000;
    frame.events = {{host, "atlas", "atlas", 1000, 900'000, 0, 0, 0},
                    {compute, "atlas", "atlas", 101'000, 601'000, 300, 64, 2'000'000},
                    {compute, "atlas", "read", 701'000, 801'000, 0, 0, 100'000}};
    frame.copy_gigabytes_per_second = 16;
    return {frame};
}

TEST(ProfileSizes, OfTheTable) {
    const std::string table = profile_table(two_commands());
    const std::vector<std::string> head{"items", "group", "MB", "GB/s", "%", "copy"};
    const std::vector<std::string> titles = words_of(table, "stage, kernel");
    ASSERT_GE(titles.size(), head.size());
    EXPECT_TRUE(std::equal(head.rbegin(), head.rend(), titles.rbegin()));
    const std::vector<std::string> kernel{"atlas", "compute", "1.0",  "0.500", "0.50", "50.0",
                                          "300",   "64",      "2.00", "4.00",  "25.0"};
    EXPECT_EQ(words_of(table, "  atlas"), kernel);
    const std::vector<std::string> read{"read", "compute", "1.0",  "0.100", "0.10",
                                        "10.0", "0.10",    "1.00", "6.2"};
    EXPECT_EQ(words_of(table, "  read"), read);
    EXPECT_NE(table.find("a copy on the compute device: 16.00 GB/s"), std::string::npos);
}

TEST(ProfileSizes, OfTheTableAreThoseOfOneLaunch) {
    std::vector<FrameProfile> frames = two_commands();
    ProfileEvent again = frames[0].events[1]; // a tenth of the size in a tenth of the time
    again.start = 850'000;
    again.end = 900'000;
    again.items = 100;
    again.bytes = 200'000;
    frames[0].events.push_back(again);
    const std::vector<std::string> words = words_of(profile_table(frames), "  atlas");
    const std::vector<std::string> sizes{"200", "64", "1.10", "4.00", "25.0"};
    ASSERT_GE(words.size(), sizes.size());
    EXPECT_TRUE(std::equal(sizes.rbegin(), sizes.rend(), words.rbegin()));
}

TEST(ProfileSizes, WithoutACopyNothingStandsBesideThem) {
    std::vector<FrameProfile> frames = two_commands();
    frames[0].copy_gigabytes_per_second = 0;
    const std::string table = profile_table(frames);
    EXPECT_EQ(words_of(table, "  atlas").back(), "4.00");
    EXPECT_EQ(table.find("a copy on"), std::string::npos);
}

TEST(ProfileSizes, OfTheCsv) {
    const std::string csv = profile_csv(two_commands());
    EXPECT_NE(csv.find("\n7,compute,atlas,atlas,100.000,500.000,300,64,2000000,4.000,16.000\n"),
              std::string::npos)
        << csv;
    EXPECT_NE(csv.find("\n7,compute,atlas,read,700.000,100.000,0,0,100000,1.000,16.000\n"),
              std::string::npos)
        << csv;
}

TEST(ProfileSizes, OfTheTrace) {
    Json kernel, host;
    const Json trace = Json::parse(profile_trace(two_commands(), "device"));
    for (const Json& event : trace["traceEvents"]) {
        if (event["name"] != "atlas") continue;
        (event["args"].contains("items") ? kernel : host) = event["args"];
    }
    EXPECT_EQ(kernel, (Json{{"frame", 7},
                            {"stage", "atlas"},
                            {"items", 300},
                            {"group", 64},
                            {"bytes", 2'000'000},
                            {"gb_per_s", 4.0},
                            {"copy_gb_per_s", 16.0}}));
    EXPECT_EQ(host, (Json{{"frame", 7}, {"stage", "atlas"}}));
}

/// The log entry of a device for a kernel.
compute::CommandTime logged(compute::Device& device, const std::function<void()>& run,
                            std::string_view name) {
    const auto log = device.begin_log();
    run();
    const std::vector<compute::CommandTime> commands = log->read();
    device.end_log();
    const auto found = std::ranges::find(commands, name, &compute::CommandTime::name);
    return found != commands.end() ? *found : compute::CommandTime{};
}

TEST(ProfileSizes, AsDevicesLogThem) {
    for (const char* kind : {"cpp", "opencl"}) {
        SCOPED_TRACE(kind);
        const auto device = compute::make_device(kind);
        compute::Stages stages{*device};
        const glm::ivec2 size{10 * LA_TILE, 4 * LA_TILE};
        const auto depth = device->allocate(std::size_t{40} * LA_TILE * LA_TILE * sizeof(float));
        const auto tiles = device->allocate(40 * sizeof(float));
        // A log with a single command tells too little about a device's clock.
        const auto run = [&] {
            device->clear(*depth, depth->size());
            stages.pyramid(*depth, size, *tiles);
            device->finish();
        };
        const compute::CommandTime pyramid = logged(*device, run, "pyramid");
        EXPECT_EQ(pyramid.items, 40U);
        EXPECT_EQ(pyramid.group, device->tuning().local_size);
        EXPECT_EQ(pyramid.bytes, depth->size() + tiles->size());

        const auto ranges = device->allocate(96), segments = device->allocate(32),
                   objects = device->allocate(32), jumped = device->allocate(32);
        const auto bytes_with = [&](compute::Buffer& object_table) {
            const auto forget = [&] {
                for (compute::Buffer* table : {segments.get(), objects.get(), jumped.get()})
                    device->clear(*table, table->size());
                stages.launch_each<compute::kernels::transform_forget>(1, {.segments = *segments,
                                                                           .objects = object_table,
                                                                           .jumped = *jumped,
                                                                           .ranges = *ranges});
                device->finish();
            };
            return logged(*device, forget, "transform_forget").bytes;
        };
        EXPECT_EQ(bytes_with(*objects), 3 * 32U + 2 * 96U)
            << "what is read and written counts twice";
        EXPECT_EQ(bytes_with(*segments), 2 * 32U + 2 * 96U) << "what stands twice counts once";
    }
}

} // namespace
} // namespace lineatlas::test
