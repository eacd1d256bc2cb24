#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices.hpp"
#include "lineatlas/compute_device.hpp"
#include "program_cache.hpp"

namespace lineatlas::compute {

class SharedContext;

/// A kernel of a built program.
struct BuiltKernel {
    cl::Kernel kernel{};
    std::size_t largest_group = 0; ///< of its work-groups, by the registers that it needs
};

/// What a program is built from.
struct ProgramRecipe {
    std::string name; ///< for messages
    std::string source;
    std::string options;
};

/// Everything that a built program depends on: what it is cached under.
std::string cache_key(const OpenClDevice& device, const ProgramRecipe& recipe);

/// A program out of `cache`, else built and stored there; null: always built. Throws DeviceError;
/// BuildError (build_error.hpp) if it doesn't build.
cl::Program make_program(const OpenClDevice& device, const cl::Context& context,
                         const ProgramRecipe& recipe, const ProgramCache* cache);

/// The user's cache, if the environment variable LINEATLAS_CACHE is "on", or unset and
/// `by_default`. Throws UsageError if it is neither that nor "off".
std::optional<ProgramCache> user_program_cache(bool by_default);

/// Compiles every program as it is for `device`, without what makes it run there, which takes PoCL
/// 18 seconds. Throws BuildError for the first that is refused.
void compile_all(const OpenClDevice& device);

/// What the driver makes of a kernel's program, built for how `device` launches it: bytes of the
/// driver's own kind, empty if it hands out none. Throws as make_program does.
std::vector<unsigned char> binary_of(const OpenClDevice& device, const Kernel& kernel);

/// The kernels of one user of a context: they keep their arguments, which programs do not.
class Programs {
  public:
    /// `options`: for the compiler, of every program.
    Programs(const OpenClDevice& device, std::shared_ptr<SharedContext> context,
             const std::string& options, std::optional<ProgramCache> cache);

    /// The kernel, built with its program if this is the first use in the context: looking at a
    /// source takes some drivers 20 ms even if they know it, and few frames need all of them.
    /// Throws as make_program does.
    BuiltKernel& built(const Kernel& kernel);

  private:
    OpenClDevice device_;
    std::shared_ptr<SharedContext> context_;
    std::optional<ProgramCache> cache_;
    std::string options_;
    std::vector<BuiltKernel> kernels_;            ///< by Kernel::index
    std::map<std::string, cl::Program> programs_; ///< by file and defines
};

} // namespace lineatlas::compute
