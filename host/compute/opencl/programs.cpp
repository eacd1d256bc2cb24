#include "programs.hpp"

#include "core/sources.hpp"
#include "guarded.hpp"

namespace lineatlas::compute {
namespace {

std::string common_options(const cl::Device& device) {
    std::string options = "-cl-std=CL1.2 ";
    const auto float_config = device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
    if ((float_config & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0) {
        options += "-cl-fp32-correctly-rounded-divide-sqrt ";
    }
    return options;
}

} // namespace

Programs::Programs(const OpenClDevice& device, cl::Context context)
    : device_(device), context_(std::move(context)),
      common_options_(common_options(device.device)) {}

cl::Kernel& Programs::ready(LazyKernel& lazy) {
    if (lazy.kernel() != nullptr) return lazy.kernel;
    const std::string key = std::string{lazy.file} + ' ' + lazy.defines;
    auto program = programs_.find(key);
    if (program == programs_.end()) {
        program = programs_.emplace(key, build(lazy.file, lazy.defines)).first;
    }
    guarded(device_, "creating a kernel", [&] {
        lazy.kernel = cl::Kernel{program->second, lazy.name};
    });
    return lazy.kernel;
}

cl::Program Programs::build(const std::string& file, const std::string& defines) const {
    const std::string options = common_options_ + defines;
    return guarded(device_, "creating a program", [&] {
        cl::Program program{context_, kernel_source(file)};
        try {
            program.build({device_.device}, options.c_str());
        } catch (const cl::Error&) {
            throw DeviceError(device_.description() + ": kernel " + file +
                              " did not build with \"" + options + "\":\n" +
                              program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device_.device));
        }
        return program;
    });
}

} // namespace lineatlas::compute
