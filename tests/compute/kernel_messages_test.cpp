// Messages about errors in kernels name the file and the line. Messages about wrong launches name
// the argument.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "compute/kernels.hpp"
#include "compute/opencl/build_error.hpp"
#include "compute/opencl/opencl_backend.hpp"
#include "lineatlas/error.hpp"
#include "planted_error.hpp"
#include "support/fault_layer/fault_layer.hpp"

namespace lineatlas::test {
namespace {

/// Set before the first OpenCL call, in which the loader loads the layer.
const bool layered = setenv("OPENCL_LAYERS", LINEATLAS_FAULT_LAYER, 1) == 0;

OpenClFaults& opencl_faults() {
    static OpenClFaults* faults = [] {
        void* layer = dlopen(LINEATLAS_FAULT_LAYER, RTLD_NOW);
        if (layer == nullptr) throw std::runtime_error(dlerror());
        return reinterpret_cast<GetOpenClFaults*>(dlsym(layer, opencl_faults_symbol))();
    }();
    return *faults;
}

class KernelMessages : public testing::TestWithParam<std::size_t> {
  protected:
    /// The message of a launch of the kernel; empty if there is none.
    std::string said_by_launching(const compute::Kernel& kernel,
                                  std::span<const std::byte> parameters = {},
                                  std::span<compute::Buffer* const> tables = {}) {
        try {
            device_->launch({kernel, parameters, tables, 1, 1});
            device_->finish();
        } catch (const DeviceError& error) {
            return error.what();
        }
        return {};
    }

    std::unique_ptr<compute::OpenClBackend> make_device() const {
        return compute::make_opencl_backend(compute::list_opencl_devices()[GetParam()]);
    }

    std::unique_ptr<compute::OpenClBackend> device_ = make_device();
};

/// "file:line" of the first line with this text.
std::string place_of(const std::string& file, const std::string& text) {
    std::ostringstream content;
    content << std::ifstream{LINEATLAS_SOURCE_DIR "/kernels/" + file}.rdbuf();
    const std::string all = content.str();
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(all.find(text));
    return file + ":" + std::to_string(1 + std::count(all.begin(), end, '\n'));
}

TEST_P(KernelMessages, ABuildErrorHasTheFileAndTheLine) {
    const compute::Kernel& kernel = compute::kernel_of<compute::kernels::atlas>();
    const std::pair<const char*, const char*> places[] = {
        {"atlas.cl", "KERNEL(atlas, "},
        {"shared/spine.h", "FUNCTION Spine make_spine("}}; // behind includes
    for (const auto& [file, text] : places) {
        const PlantedError broken{file, text, std::string{"unknown_type broken; "} + text};
        const std::string said = said_by_launching(kernel);
        EXPECT_NE(said.find(place_of(file, text) + ":"), std::string::npos) << said;
    }
    EXPECT_NE(said_by_launching(kernel).find("the parameters"), std::string::npos) << "mended";
}

TEST_P(KernelMessages, AWarningIsNotPrinted) {
    const compute::Kernel& kernel = compute::kernel_of<compute::kernels::atlas>();
    const PlantedError warning{"atlas.cl", "KERNEL(atlas, ", "\n#warning planted\nKERNEL(atlas, "};
    testing::internal::CaptureStderr();
    const std::string said = said_by_launching(kernel);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_NE(said.find("the parameters"), std::string::npos) << "builds: " << said;
}

TEST_P(KernelMessages, AWrongArgumentHasItsName) {
    const compute::Kernel& kernel = compute::kernel_of<compute::kernels::facing>();
    const auto table = device_->allocate(16);
    const std::array tables{table.get(), table.get(), table.get()};
    const compute::FacingParameters parameters{.count = 0, .eye = {}};
    const std::pair<int, const char*> names[] = {{0, "argument 0, the parameters, of"},
                                                 {2, "argument 2, triangles, of"}};
    for (const auto& [argument, name] : names) {
        opencl_faults().fail_argument = argument;
        const std::string said =
            said_by_launching(kernel, std::as_bytes(std::span{&parameters, 1}), tables);
        opencl_faults().reset();
        const std::string expected =
            name + std::string{" the kernel facing was refused: clSetKernelArg returned "
                               "CL_INVALID_ARG_SIZE (-51)"};
        EXPECT_NE(said.find(expected), std::string::npos) << said;
    }
    EXPECT_EQ(said_by_launching(kernel, std::as_bytes(std::span{&parameters, 1}), tables), "");
}

/// The forms of logs by rusticl of Mesa 26.1 and by others.
TEST(FirstError, IsInItsFile) {
    const std::string source = "a\n#line 7 \"spine.h\"\nb\nc\n#line 30 \"atlas.cl\"\nd\n";
    EXPECT_EQ(compute::first_error("x\ninput.cl:4:1: error: y", source), "spine.h:8:1: error: y");
    EXPECT_EQ(compute::first_error("input.cl:6:2: error: y", source), "atlas.cl:30:2: error: y");
    for (const char* said : {"input.cl:1:1: error: y", "atlas.cl:4:1: error: y", "error: y",
                             "input.cl: error: y", "input.cl:9"})
        EXPECT_EQ(compute::first_error(said, source), said);
}

INSTANTIATE_TEST_SUITE_P(Devices, KernelMessages,
                         testing::Range(std::size_t{0}, compute::list_opencl_devices().size()),
                         [](const auto& tested) {
                             const bool rusticl =
                                 compute::list_opencl_devices()[tested.param].platform_name.find(
                                     "rusticl") != std::string::npos;
                             return (rusticl ? "rusticl_" : "device_") +
                                    std::to_string(tested.param);
                         });

} // namespace
} // namespace lineatlas::test
