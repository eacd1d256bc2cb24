// The device that counts: its counts of launches with known numbers, and that its results are those
// of every other device.

#include <gtest/gtest.h>

#include "compute/cpp/counted_float.hpp"
#include "compute/cpp/counting_device.hpp"
#include "compute/kernel_bytes.hpp"
#include "compute/kernels.hpp"
#include "compute/transfer.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::test {
namespace {

using namespace compute;

class Counting : public testing::Test {
  protected:
    template <class K>
    LaunchCounts count(const typename K::Parameters& parameters, std::vector<Buffer*> tables,
                       std::uint32_t items) {
        const std::span<const std::byte> bytes{reinterpret_cast<const std::byte*>(&parameters),
                                               sizeof parameters};
        device_->launch({kernel_of<K>(), bytes, tables, items, 1});
        return counts_.back();
    }

    std::vector<LaunchCounts> counts_;
    std::unique_ptr<Device> device_ = make_counting_device(counts_);
};

constexpr PyramidParameters pyramid_of_64_by_32{.depth_size = {64, 32}, .tile_count = {4, 2}};
constexpr std::uint64_t comparisons = 16 * 15 + 15; // of a tile: by columns, then along the row

TEST_F(Counting, KnowsWhatAPyramidDoes) {
    const auto depth = to_device(*device_, std::vector<float>(64 * 32, 0.5F));
    const auto tiles = device_->allocate(8 * sizeof(float));
    const LaunchCounts counts =
        count<kernels::pyramid>(pyramid_of_64_by_32, {depth.get(), tiles.get()}, 8);
    EXPECT_EQ(counts.kernel, "pyramid");
    EXPECT_EQ(counts.bytes, 64 * 32 * 4 + 64U); // of the tiles one line
    EXPECT_EQ(counts.operations, 8 * comparisons);
}

/// Only touched bytes of tables count. The kernel does not touch the upper row of tiles.
TEST_F(Counting, CountsWhatIsTouched) {
    const auto depth = to_device(*device_, std::vector<float>(64 * 32, 0.5F));
    const auto tiles = device_->allocate(8 * sizeof(float));
    const LaunchCounts counts =
        count<kernels::pyramid>(pyramid_of_64_by_32, {depth.get(), tiles.get()}, 4);
    EXPECT_EQ(counts.bytes, 64 * 16 * 4 + 64U);
    EXPECT_EQ(counts.operations, 4 * comparisons);
}

TEST(BytesMoved, DoNotCountAStandInAgain) {
    const std::unique_ptr<Device> device = make_device("cpp");
    const auto small = device->allocate(100), large = device->allocate(1000);
    const std::array<Buffer*, 3> tables{small.get(), small.get(), large.get()};
    // It reads two tables and writes one.
    EXPECT_EQ(bytes_moved({first_variant("silhouette"), {}, tables, 1, 1}), 1100U);
}

TEST(CountedFloat, CountsEachOperation) {
    const std::uint64_t before = counted_operations;
    CountedFloat a = 2.0F;
    const CountedFloat b = a * 3.0F + 1.0F;
    a += b;
    EXPECT_EQ(static_cast<float>(a), 9.0F);
    EXPECT_TRUE(a > b);
    EXPECT_EQ(counted_operations - before, 4U);
    static_cast<void>(-a);
    EXPECT_EQ(counted_operations - before, 4U); // a sign is no operation
}

TEST(Roofs, ArithmeticIsMeasuredOnEveryKindOfDevice) {
    for (const char* device : {"cpp", "opencl", "opencl:portable"})
        EXPECT_GT(measure_arithmetic(device), 0.1) << device;
    EXPECT_THROW(measure_arithmetic("toaster"), UsageError);
}

} // namespace
} // namespace lineatlas::test
