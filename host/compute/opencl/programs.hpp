#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices.hpp"
#include "lineatlas/compute_device.hpp"
#include "lineatlas/kernel_profile.hpp"
#include "program_cache.hpp"

namespace lineatlas::compute {

class SharedContext;

/// A kernel of a built program.
struct BuiltKernel {
    cl::Kernel kernel{};
    std::size_t largest_group = 0; ///< its largest work-group, by the registers that it needs
    std::optional<KernelResources> resources{}; ///< once asked for
};

/// The input of building a program.
struct ProgramRecipe {
    std::string name; ///< for messages
    std::string source;
    std::string options;
};

/// The key of a program in the cache: everything that a built program depends on.
std::string cache_key(const OpenClDevice& device, const ProgramRecipe& recipe);

/// A program from `cache`, or else built and stored there. Null: always built. Throws DeviceError,
/// and BuildError (build_error.hpp) if it does not build.
cl::Program make_program(const OpenClDevice& device, const cl::Context& context,
                         const ProgramRecipe& recipe, const ProgramCache* cache);

/// The user's cache, if the environment variable LINEATLAS_CACHE is "on", or unset and
/// `by_default`. Throws UsageError for any value but "on" and "off".
std::optional<ProgramCache> user_program_cache(bool by_default);

/// Compiles every program for `device`, without the last step that makes it run there, which takes
/// PoCL 18 seconds. Throws BuildError for the first program that is refused.
void compile_all(const OpenClDevice& device);

/// The driver's binary of a kernel's program, built for the way `device` launches it. Empty if the
/// driver returns none. Throws as make_program() does.
std::vector<unsigned char> binary_of(const OpenClDevice& device, const Kernel& kernel);

/// The kernels of one user of a context. Kernels keep their arguments, so users do not share them.
class Programs {
  public:
    /// `options`: compiler options for every program.
    Programs(const OpenClDevice& device, std::shared_ptr<SharedContext> context,
             const std::string& options, std::optional<ProgramCache> cache);

    /// The kernel. Its program is built at the first use in the context: reading a source takes
    /// some drivers 20 ms even if they know it, and few frames need all kernels. Throws as
    /// make_program() does.
    BuiltKernel& built(const Kernel& kernel);

    /// What the driver tells of a built kernel. Asked for once.
    const KernelResources& resources(const Kernel& kernel);

  private:
    std::uint32_t registers(const Kernel& kernel, const cl::Program& program);

    OpenClDevice device_;
    std::shared_ptr<SharedContext> context_;
    std::optional<ProgramCache> cache_;
    std::string options_;
    std::vector<BuiltKernel> kernels_;            ///< by Kernel::index
    std::map<std::string, cl::Program> programs_; ///< by file and defines
    std::map<std::string, std::string> logs_;     ///< with registers, likewise
};

} // namespace lineatlas::compute
