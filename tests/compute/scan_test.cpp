// scan: compared with its oracle, a sum in 64 bits, on every device and in both forms.

#include "compare.hpp"
#include "compute/oracles/scan.hpp"
#include "devices.hpp"

namespace lineatlas::test {
namespace {

class Scan : public testing::TestWithParam<TestDevice> {
  protected:
    void expect_scan(std::vector<std::uint32_t> values) {
        for (const auto kind : {compute::ScanKind::saturate, compute::ScanKind::wrap}) {
            std::vector<std::uint32_t> input = values;
            input.push_back(0xDEADBEEFU); // room for the total; its content must not matter
            const auto buffer = to_device(*on_.device, input);
            on_.stages.scan(*buffer, static_cast<std::uint32_t>(values.size()), kind);
            std::vector<std::uint32_t> expected = input;
            oracles::scan(expected, kind);
            EXPECT_TRUE(
                equal(read_back<std::uint32_t>(*on_.device, *buffer, input.size()), expected))
                << "n = " << values.size();
        }
    }

    DeviceStages on_{GetParam().make()};
};

std::uint32_t next_random(std::uint64_t& state) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::uint32_t>(state >> 33U);
}

TEST_P(Scan, AllSizesAroundTilesAndChunks) {
    std::uint64_t state = 1;
    for (const std::size_t n : {0U,      1U,
                                2U,      15U,
                                16U,     17U,
                                63U,     64U,
                                65U,     255U,
                                256U,    257U,
                                511U,    512U,
                                513U,    2047U,
                                2048U,   2049U,
                                8192U,   8193U,
                                65535U,  65536U,
                                65537U,  524288U,
                                524289U, (1U << 20U) + 3}) {
        std::vector<std::uint32_t> values(n);
        for (std::uint32_t& value : values) value = next_random(state) % 700;
        expect_scan(values);
    }
}

TEST_P(Scan, ScansZerosAndOnes) {
    expect_scan(std::vector<std::uint32_t>(100'003, 0));
    expect_scan(std::vector<std::uint32_t>(100'003, 1));
}

TEST_P(Scan, SumsSaturateOrWrapAtTheLargestNumber) {
    expect_scan({UINT32_MAX});
    expect_scan({UINT32_MAX - 1, 1, 0, 0});
    expect_scan({UINT32_MAX - 1, 1, 1, 5});
    expect_scan({UINT32_MAX, UINT32_MAX, UINT32_MAX});
    // The sum passes the limit inside a tile, between tiles and between chunks.
    expect_scan(std::vector<std::uint32_t>(70'000, 61'357));
    expect_scan(std::vector<std::uint32_t>(70'001, 61'356));
}

TEST_P(Scan, CompactsTheIndicesOfOnes) {
    std::uint64_t state = 2;
    for (const std::uint32_t n : {0U, 1U, 65U, 4097U, 100'003U}) {
        std::vector<std::uint32_t> flags, expected;
        for (std::uint32_t i = 0; i < n; ++i) {
            flags.push_back(next_random(state) % 3 == 0 ? 1 : 0);
            if (flags.back() == 1) expected.push_back(i);
        }
        flags.push_back(0); // room for the total
        const auto values = to_device(*on_.device, flags);
        const auto list =
            to_device(*on_.device, std::vector<std::uint32_t>(expected.size() + 1, 7));
        on_.stages.scan(*values, n, compute::ScanKind::saturate);
        on_.stages.launch_each<compute::kernels::scan_list>(n, {.values = *values, .list = *list});
        expected.push_back(7); // the element after the total stays
        EXPECT_TRUE(equal(read_back<std::uint32_t>(*on_.device, *list, expected.size()), expected))
            << "n = " << n;
    }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Scan);
INSTANTIATE_TEST_SUITE_P(OnDevice, Scan, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

TEST(ScanOracle, AgreesWithItsDefinition) {
    std::vector<std::uint32_t> values{3, 0, 4, UINT32_MAX, 9};
    oracles::scan(values, compute::ScanKind::saturate);
    EXPECT_TRUE(equal(values, {0, 3, 3, 7, UINT32_MAX}));
    values = {3, 0, 4, UINT32_MAX, 9};
    oracles::scan(values, compute::ScanKind::wrap);
    EXPECT_TRUE(equal(values, {0, 3, 3, 7, 6}));
}

} // namespace
} // namespace lineatlas::test
