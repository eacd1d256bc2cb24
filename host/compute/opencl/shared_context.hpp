#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "programs.hpp"

namespace lineatlas::compute {

/// A context of one device with the programs that were built in it, each once. Several threads may
/// use it.
class SharedContext {
  public:
    /// `properties`: as in make_opencl_backend(). Throws DeviceError if the driver refuses.
    SharedContext(const OpenClDevice& device, std::span<const cl_context_properties> properties);

    const cl::Context& context() const { return context_; }

    /// The program of a recipe. A thread waits for a program that another thread is building. A
    /// program that did not build is built anew the next time. Throws as make_program() does.
    cl::Program program(const OpenClDevice& device, const ProgramRecipe& recipe,
                        const ProgramCache* cache);

  private:
    struct Entry {
        std::mutex building;
        cl::Program program{};
    };
    Entry& entry(const ProgramRecipe& recipe);

    cl::Context context_;
    std::mutex finding_;
    std::map<std::string, Entry> programs_; ///< by cache_key()
};

/// The context of this process on a device that shares nothing with GL. It stays until it is
/// retired, so a new renderer finds programs of earlier ones.
std::shared_ptr<SharedContext> shared_context(const OpenClDevice& device);

/// Replaces a context in which something has failed: later calls of shared_context() get a new one.
void retire(const SharedContext& context);

} // namespace lineatlas::compute
