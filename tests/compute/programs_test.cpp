// Programs from the cache on every device, with any content of the cache.

#include <functional>

#include <gtest/gtest.h>

#include "compute/kernels.hpp"
#include "compute/opencl/programs.hpp"
#include "compute/opencl/quirks.hpp"
#include "compute/opencl/shared_context.hpp"
#include "compute/opencl/tuning.hpp"
#include "program_cache_damage.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

using compute::OpenClDevice;
using compute::ProgramCache;
using compute::ProgramRecipe;

ProgramRecipe program_that_returns(int value) {
    return {"small.cl", "kernel void small(global int* out) { *out = VALUE; }",
            "-DVALUE=" + std::to_string(value)};
}

int run(const OpenClDevice& device, const cl::Context& context, const cl::Program& program) {
    cl::CommandQueue queue{context, device.device};
    cl::Buffer buffer{context, CL_MEM_READ_WRITE, 16};
    cl::Kernel kernel{program, "small"};
    kernel.setArg(0, buffer);
    queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange{1}, cl::NDRange{1});
    int result = 0;
    queue.enqueueReadBuffer(buffer, CL_TRUE, 0, sizeof(result), &result);
    return result;
}

/// Tests of programs from the cache on every device.
class ProgramsOnDevice : public testing::TestWithParam<std::size_t> {
  protected:
    int run_with(const ProgramCache& cache, const ProgramRecipe& recipe) {
        return run(device_, context_, make_program(device_, context_, recipe, &cache));
    }

    /// True if the driver gives its programs to the cache.
    bool is_cached(const ProgramCache& cache, const ProgramRecipe& recipe) {
        return cache.find(cache_key(device_, recipe)).has_value();
    }

    OpenClDevice device_ = compute::list_opencl_devices()[GetParam()];
    cl::Context context_{device_.device};
    TemporaryFolder folder_;
    ProgramCache cache_{folder_.path()};
};

TEST_P(ProgramsOnDevice, AreTakenOutOfTheCache) {
    const ProgramRecipe one = program_that_returns(1), two = program_that_returns(2);
    EXPECT_EQ(run_with(cache_, one), 1);
    EXPECT_EQ(run_with(cache_, one), 1);
    EXPECT_EQ(run_with(cache_, two), 2);
    EXPECT_EQ(run_with(cache_, two), 2);
    ASSERT_TRUE(is_cached(cache_, one) && is_cached(cache_, two));

    // The entry of a program's key is the program that runs.
    cache_.store(cache_key(device_, one), *cache_.find(cache_key(device_, two)));
    EXPECT_EQ(run_with(cache_, one), 2);
}

TEST_P(ProgramsOnDevice, AreBuiltIfTheDriverRefusesTheBinary) {
    if (aborts_on_foreign_binary(device_)) GTEST_SKIP() << "a quirk of " << device_.platform_name;
    const ProgramRecipe recipe = program_that_returns(3);
    const std::string key = cache_key(device_, recipe);
    for (const std::size_t size : {1U, 7U, 300U}) {
        cache_.store(key, std::vector<unsigned char>(size, 'x'));
        EXPECT_EQ(run_with(cache_, recipe), 3);
        EXPECT_GT(cache_.find(key).value_or(std::vector<unsigned char>{}).size(), size)
            << "the refused binary was not replaced";
    }
}

TEST_P(ProgramsOnDevice, DamagedEntriesChangeNothing) {
    const ProgramRecipe one = program_that_returns(1), two = program_that_returns(2);
    std::minstd_rand random{3};
    for (int round = 0; round < 25; ++round) {
        ASSERT_EQ(run_with(cache_, one), 1);
        ASSERT_EQ(run_with(cache_, two), 2);
        const auto file = [&](const ProgramRecipe& recipe) {
            return cache_.file_of(cache_key(device_, recipe));
        };
        SCOPED_TRACE(damage(file(one), file(two), random));
        ASSERT_EQ(run_with(cache_, one), 1);
        ASSERT_EQ(run_with(cache_, two), 2);
    }
}

TEST_P(ProgramsOnDevice, KeysTellApartWhatChangesThem) {
    const ProgramRecipe recipe = program_that_returns(1);
    const std::string key = cache_key(device_, recipe);
    const auto differs = [&](const std::function<void(OpenClDevice&, ProgramRecipe&)>& change) {
        OpenClDevice device = device_;
        ProgramRecipe changed = recipe;
        change(device, changed);
        return cache_key(device, changed) != key;
    };
    EXPECT_TRUE(differs([](OpenClDevice& device, auto&) { device.platform_name += 'x'; }));
    EXPECT_TRUE(differs([](OpenClDevice& device, auto&) { device.device_name += 'x'; }));
    EXPECT_TRUE(differs([](OpenClDevice& device, auto&) { device.driver_version += 'x'; }));
    EXPECT_TRUE(differs([](auto&, ProgramRecipe& changed) { changed.source += ' '; }));
    EXPECT_TRUE(differs([](auto&, ProgramRecipe& changed) { changed.options += ' '; }));
    EXPECT_FALSE(differs([](auto&, auto&) {}));
}

/// A driver may claim an option by which it shows registers, and refuse it.
TEST_P(ProgramsOnDevice, TellNoRegistersIfTheDriverRefuses) {
    if (device_.has_extension("cl_nv_compiler_options")) GTEST_SKIP() << "it does show them";
    OpenClDevice claiming = device_;
    claiming.extensions += " cl_nv_compiler_options";
    compute::Programs programs{claiming, compute::shared_context(claiming),
                               compute::compiler_options(compute::tuning_for(claiming)),
                               std::nullopt};
    const KernelResources& told =
        programs.resources(compute::kernel_of<compute::kernels::pyramid>());
    EXPECT_EQ(told.registers, 0U);
    EXPECT_GT(told.largest_group, 0U);
}

std::vector<std::size_t> device_numbers() {
    std::vector<std::size_t> result(compute::list_opencl_devices().size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = i;
    return result;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ProgramsOnDevice);
INSTANTIATE_TEST_SUITE_P(Device, ProgramsOnDevice, testing::ValuesIn(device_numbers()));

} // namespace
} // namespace lineatlas::test
