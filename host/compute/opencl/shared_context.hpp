#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "programs.hpp"

namespace lineatlas::compute {

/// A context of one device with the programs that were built in it, each once. Several threads may
/// use one.
class SharedContext {
  public:
    /// `properties`: as make_opencl_backend() takes them. Throws DeviceError when the driver
    /// refuses.
    SharedContext(const OpenClDevice& device, std::span<const cl_context_properties> properties);

    const cl::Context& context() const { return context_; }

    /// The program of that recipe. A thread that asks for one that another thread is building
    /// waits for it. One that did not build is built anew the next time. Throws as make_program().
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
    std::map<std::string, Entry> programs_; ///< by all that they are built from
};

/// The context of this process on a device that shares nothing with GL. It stays until it is
/// retired: a renderer that comes after all others are gone finds their programs.
std::shared_ptr<SharedContext> shared_context(const OpenClDevice& device);

/// Something has failed in this context: whoever asks from now on gets a new one.
void retire(const SharedContext& context);

} // namespace lineatlas::compute
