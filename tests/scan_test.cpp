// scan: against a sum in 64 bits, on every device and in both forms.

#include <numeric>

#include "compare.hpp"
#include "devices.hpp"

namespace lineatlas::test {
namespace {

class Scan : public testing::TestWithParam<TestDevice> {
  protected:
    static std::vector<std::uint32_t> expected(const std::vector<std::uint32_t>& values,
                                               compute::ScanKind kind) {
        std::vector<std::uint32_t> result;
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i <= values.size(); ++i) {
            const std::uint64_t limited = kind == compute::ScanKind::saturate
                                              ? std::min<std::uint64_t>(sum, UINT32_MAX)
                                              : sum;
            result.push_back(static_cast<std::uint32_t>(limited));
            if (i < values.size()) sum += values[i];
        }
        return result;
    }

    void expect_scan(std::vector<std::uint32_t> values) {
        for (const auto kind : {compute::ScanKind::saturate, compute::ScanKind::wrap}) {
            std::vector<std::uint32_t> input = values;
            input.push_back(0xDEADBEEFU); // room for the total; its content must not matter
            const auto buffer = to_device(*backend_, input);
            backend_->scan(*buffer, static_cast<std::uint32_t>(values.size()), kind);
            EXPECT_TRUE(equal(read_back<std::uint32_t>(*backend_, *buffer, input.size()),
                              expected(values, kind)))
                << "n = " << values.size();
        }
    }

    std::unique_ptr<compute::Backend> backend_ = GetParam().backend();
};

std::uint32_t next_random(std::uint64_t& state) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::uint32_t>(state >> 33U);
}

TEST_P(Scan, AllSizesAroundTilesAndChunks) {
    std::uint64_t state = 1;
    for (const std::size_t n :
         {0U,   1U,   2U,   15U,  16U,   17U,   63U,   64U,    65U,    255U,   256U,
          257U, 511U, 512U, 513U, 2047U, 2048U, 2049U, 65535U, 65536U, 65537U, (1U << 20U) + 3}) {
        std::vector<std::uint32_t> values(n);
        for (std::uint32_t& value : values) value = next_random(state) % 700;
        expect_scan(values);
    }
}

TEST_P(Scan, ZerosAndOnes) {
    expect_scan(std::vector<std::uint32_t>(100'003, 0));
    expect_scan(std::vector<std::uint32_t>(100'003, 1));
}

TEST_P(Scan, TotalsAroundTheLargest) {
    expect_scan({UINT32_MAX});
    expect_scan({UINT32_MAX - 1, 1, 0, 0});
    expect_scan({UINT32_MAX - 1, 1, 1, 5});
    expect_scan({UINT32_MAX, UINT32_MAX, UINT32_MAX});
    // The sum passes the limit inside a tile, between tiles and between chunks.
    expect_scan(std::vector<std::uint32_t>(70'000, 61'357));
    expect_scan(std::vector<std::uint32_t>(70'001, 61'356));
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Scan);
INSTANTIATE_TEST_SUITE_P(OnDevice, Scan, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

TEST(ScanReference, AgreesWithItsDefinition) {
    const auto backend = compute::make_reference_backend();
    const auto buffer = to_device(*backend, std::vector<std::uint32_t>{3, 0, 4, UINT32_MAX, 9});
    backend->scan(*buffer, 4, compute::ScanKind::saturate);
    EXPECT_TRUE(equal(read_back<std::uint32_t>(*backend, *buffer, 5), {0, 3, 3, 7, UINT32_MAX}));
}

} // namespace
} // namespace lineatlas::test
