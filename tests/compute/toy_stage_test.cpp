// A new stage needs its kernel (toy/toy.cl), its row of kernels/kernels.h (toy/row.h, which CMake
// puts there) and code that launches it (this file). The list of kernels, devices, comparison and
// profile then know it.
#include "compute/compare/comparing_device.hpp"
#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

LINEATLAS_STAGE_TEST(ToyStage);

TEST_P(ToyStage, RunsOnEveryDevice) {
    constexpr std::uint32_t n = 1000;
    const auto values = put(std::vector<float>(n, 3));
    const auto multiples = put(std::vector<float>(n + 1, 7));
    stages().launch<compute::kernels::toy>(n, {.count = n, .factor = 2},
                                           {.values = *values, .multiples = *multiples});
    std::vector<float> expected(n, 6);
    expected.push_back(7);
    EXPECT_TRUE(equal(get<float>(*multiples, n + 1), expected));
}

TEST(ToyStages, AreListed) {
    EXPECT_EQ(compute::stage_names().back(), "toy");
    const compute::Kernel& kernel = compute::kernel_of<compute::kernels::toy>();
    ASSERT_EQ(kernel.tables.size(), 2U);
    EXPECT_EQ(kernel.tables[0].name, "values");
    EXPECT_EQ(kernel.tables[1].access, compute::Access::out);
    EXPECT_NE(compute::source_of(kernel).find("toy: a stage"), std::string::npos);
}

} // namespace
} // namespace lineatlas::test
