#include "programs.hpp"

#include <cstdlib>
#include <set>
#include <string_view>
#include <vector>

#include "build_error.hpp"
#include "guarded.hpp"
#include "kernel_resources.hpp"
#include "quirks.hpp"
#include "shared_context.hpp"
#include "sources/sources.hpp"
#include "status.hpp"
#include "tuning.hpp"

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

/// All compiler options. `options`: those of the program.
std::string options_for(const OpenClDevice& device, const std::string& options) {
    return common_options(device.device) + quirk_options(device) + options;
}

/// The compiler options for the way the device launches kernels.
std::string usual_options(const OpenClDevice& device) {
    const Tuning tuning = within_groups(tuning_for(device), group_limits(device.device));
    return options_for(device, compiler_options(tuning));
}

ProgramRecipe recipe_of(const Kernel& kernel, const std::string& options) {
    return {kernel.file(), source_of(kernel), options + ' ' + std::string{kernel.defines}};
}

/// Whether an error is about the program, and not about the state of the device.
bool is_about_the_program(const cl::Error& error) {
    return !is_shortage(error.err()) && error.err() != CL_DEVICE_NOT_AVAILABLE;
}

BuildError build_error(const OpenClDevice& device, const ProgramRecipe& recipe,
                       const cl::Program& program, const cl::Error& error) {
    const std::string log = program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device.device);
    const std::string what = device.description() + ": kernel " + recipe.name + " does not build";
    std::string cause = first_error(log, recipe.source);
    if (cause.empty()) cause = std::string{error.what()} + " returned " + name_of(error.err());
    const std::string rest = keep_build_log(what + " with \"" + recipe.options + "\":", log);
    return BuildError{what + ": " + cause + "; " + rest};
}

cl::Program build_program(const OpenClDevice& device, const cl::Context& context,
                          const ProgramRecipe& recipe) {
    cl::Program program{context, recipe.source};
    try {
        program.build({device.device}, recipe.options.c_str());
    } catch (const cl::Error& error) {
        if (!is_about_the_program(error)) throw;
        throw build_error(device, recipe, program, error);
    }
    return program;
}

/// The program in the cache; none if there is none or the driver does not accept it.
std::optional<cl::Program> cached_program(const OpenClDevice& device, const cl::Context& context,
                                          const ProgramRecipe& recipe, const ProgramCache& cache) {
    const std::optional<std::vector<unsigned char>> binary = cache.find(cache_key(device, recipe));
    if (!binary) return std::nullopt;
    try {
        cl::Program program{context, {device.device}, {*binary}};
        program.build({device.device}, recipe.options.c_str());
        return program;
    } catch (const cl::Error&) {
        return std::nullopt;
    }
}

void store_program(const OpenClDevice& device, const cl::Program& program,
                   const ProgramRecipe& recipe, const ProgramCache& cache) {
    try {
        const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
        if (binaries.size() == 1 && !binaries.front().empty()) {
            cache.store(cache_key(device, recipe), binaries.front());
        }
    } catch (const cl::Error&) {
        return; // the driver does not return programs
    }
}

} // namespace

std::string cache_key(const OpenClDevice& device, const ProgramRecipe& recipe) {
    const cl::Device& own = device.device;
    std::string key;
    // These versions name the compiler too, in case the driver's own version does not change with
    // it.
    for (const std::string& part :
         {device.platform_name, device.platform.getInfo<CL_PLATFORM_VERSION>(), device.device_name,
          own.getInfo<CL_DEVICE_VENDOR>(), own.getInfo<CL_DEVICE_VERSION>(), device.driver_version,
          recipe.options, recipe.source}) {
        key += std::to_string(part.size()) + ' ' + part + '\n';
    }
    return key;
}

cl::Program make_program(const OpenClDevice& device, const cl::Context& context,
                         const ProgramRecipe& recipe, const ProgramCache* cache) {
    return guarded(device, "creating a program", [&] {
        if (cache == nullptr) return build_program(device, context, recipe);
        if (const auto cached = cached_program(device, context, recipe, *cache)) return *cached;
        cl::Program program = build_program(device, context, recipe);
        store_program(device, program, recipe, *cache);
        return program;
    });
}

std::optional<ProgramCache> user_program_cache(bool by_default) {
    const char* variable = std::getenv("LINEATLAS_CACHE");
    const std::string_view wish = variable != nullptr ? variable : by_default ? "on" : "off";
    if (wish == "off") return std::nullopt;
    if (wish != "on") {
        throw UsageError("LINEATLAS_CACHE is \"" + std::string{wish} + "\"; it can be on or off");
    }
    const auto folder = ProgramCache::default_folder();
    return folder ? std::optional{ProgramCache{*folder}} : std::nullopt;
}

Programs::Programs(const OpenClDevice& device, std::shared_ptr<SharedContext> context,
                   const std::string& options, std::optional<ProgramCache> cache)
    : device_(device), context_(std::move(context)), cache_(std::move(cache)),
      options_(options_for(device, options)), kernels_(all_kernels().size()) {}

namespace {

/// The key of a kernel's program among those of one user.
std::string own_key(const Kernel& kernel) {
    return std::string{kernel.stage} + ' ' + std::string{kernel.defines};
}

} // namespace

BuiltKernel& Programs::built(const Kernel& kernel) {
    BuiltKernel& own = kernels_[kernel.index];
    if (own.kernel() != nullptr) return own;
    const std::string key = own_key(kernel);
    auto program = programs_.find(key);
    if (program == programs_.end()) {
        const ProgramRecipe recipe = recipe_of(kernel, options_);
        program =
            programs_.emplace(key, context_->program(device_, recipe, cache_ ? &*cache_ : nullptr))
                .first;
    }
    guarded(device_, "creating a kernel", [&] {
        try {
            cl::Kernel made{program->second, std::string{kernel.name}.c_str()};
            own.largest_group = made.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device_.device);
            own.kernel = made;
        } catch (const cl::Error& error) {
            if (!is_about_the_program(error)) throw;
            throw BuildError(device_.description() + ": kernel " + std::string{kernel.name} +
                             " of " + kernel.file() + " cannot be made: " + error.what() +
                             " returned " + name_of(error.err()));
        }
    });
    return own;
}

const KernelResources& Programs::resources(const Kernel& kernel) {
    BuiltKernel& own = built(kernel);
    if (!own.resources) {
        own.resources = told_of(own.kernel, device_.device);
        own.resources->registers = registers(kernel, programs_.at(own_key(kernel)));
        if (own.resources->registers > 0) {
            own.resources->resident = registers_of_processor(device_) / own.resources->registers;
        }
    }
    return *own.resources;
}

std::uint32_t Programs::registers(const Kernel& kernel, const cl::Program& program) {
    try {
        if (const std::string option = register_option(device_); !option.empty()) {
            const auto [log, is_new] = logs_.try_emplace(own_key(kernel));
            if (is_new) {
                // Not build_program(), whose failure ends a frame and is kept for the user.
                const ProgramRecipe recipe = recipe_of(kernel, options_ + ' ' + option);
                cl::Program talking{context_->context(), recipe.source};
                talking.build({device_.device}, recipe.options.c_str());
                log->second = talking.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device_.device);
            }
            return registers_in_log(log->second, kernel.name);
        }
        if (!device_.is_gpu) return 0; // other drivers build more for a binary
        const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
        return binaries.empty() ? 0 : registers_in_code_object(binaries.front(), kernel.name);
    } catch (const cl::Error&) {
        return 0; // the driver does not tell
    }
}

std::vector<unsigned char> binary_of(const OpenClDevice& device, const Kernel& kernel) {
    return guarded(device, "building a program", [&] {
        const cl::Context context{device.device};
        const cl::Program program =
            build_program(device, context, recipe_of(kernel, usual_options(device)));
        const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
        return binaries.empty() ? std::vector<unsigned char>{} : binaries.front();
    });
}

void compile_all(const OpenClDevice& device) {
    guarded(device, "compiling kernels", [&] {
        const cl::Context context{device.device};
        const std::string options = usual_options(device);
        std::set<std::string_view> known;
        for (const Kernel& kernel : all_kernels()) {
            if (!known.insert(kernel.stage).second) continue;
            const ProgramRecipe recipe = recipe_of(kernel, options);
            cl::Program program{context, recipe.source};
            try {
                program.compile(recipe.options.c_str());
            } catch (const cl::Error& error) {
                if (!is_about_the_program(error)) throw;
                throw build_error(device, recipe, program, error);
            }
        }
    });
}

} // namespace lineatlas::compute
