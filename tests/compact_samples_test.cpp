// compact, samples: the packed addresses of what is visible, on every device and in both forms.

#include <algorithm>

#include "compare.hpp"
#include "devices.hpp"

namespace lineatlas::test {
namespace {

class CompactSamples : public testing::TestWithParam<TestDevice> {
  protected:
    void expect_packed(const std::vector<std::uint8_t>& alpha) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < alpha.size(); ++i) {
            if (alpha[i] != 0) expected.push_back(i);
        }
        const auto input = to_device(*backend_, alpha);
        const auto packed = to_device(*backend_, std::vector<std::uint32_t>(alpha.size() + 1, 77));
        const auto count = backend_->allocate(sizeof(std::uint32_t));
        backend_->compact_samples({.alpha = *input,
                                   .count = static_cast<std::uint32_t>(alpha.size()),
                                   .packed = *packed,
                                   .packed_count = *count});
        ASSERT_EQ(read_back<std::uint32_t>(*backend_, *count, 1)[0], expected.size());
        const auto seen = read_back<std::uint32_t>(*backend_, *packed, alpha.size() + 1);
        EXPECT_TRUE(equal(
            {seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(expected.size())}, expected));
        // Nothing is written beyond what was kept.
        EXPECT_TRUE(std::all_of(seen.begin() + static_cast<std::ptrdiff_t>(expected.size()),
                                seen.end(), [](std::uint32_t value) { return value == 77; }));
    }

    std::unique_ptr<compute::Backend> backend_ = GetParam().backend();
};

TEST_P(CompactSamples, AllSizesAroundBlocks) {
    std::uint32_t state = 7;
    for (const std::size_t n :
         {0U, 1U, 15U, 16U, 17U, 1023U, 1024U, 1025U, 16383U, 16384U, 16385U, (1U << 20U) + 3}) {
        std::vector<std::uint8_t> alpha(n);
        for (std::uint8_t& value : alpha) {
            state = state * 1664525U + 1013904223U;
            value = (state >> 29U) == 0 ? static_cast<std::uint8_t>(state >> 16U) : 0;
        }
        expect_packed(alpha);
    }
}

TEST_P(CompactSamples, NothingAndEverything) {
    expect_packed(std::vector<std::uint8_t>(50'001, 0));
    expect_packed(std::vector<std::uint8_t>(50'001, 1));
    expect_packed(std::vector<std::uint8_t>(50'001, 255));
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CompactSamples);
INSTANTIATE_TEST_SUITE_P(OnDevice, CompactSamples, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lineatlas::test
