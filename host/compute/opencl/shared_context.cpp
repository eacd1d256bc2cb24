#include "shared_context.hpp"

#include <vector>

#include "guarded.hpp"

namespace lineatlas::compute {
namespace {

struct Contexts {
    std::mutex mutex;
    std::map<cl_device_id, std::shared_ptr<SharedContext>> of_devices;
};

/// All contexts. They are never destroyed, because drivers may end before the library at the end of
/// the process.
Contexts& contexts() {
    static Contexts& all = *new Contexts;
    return all;
}

} // namespace

SharedContext::SharedContext(const OpenClDevice& device,
                             std::span<const cl_context_properties> properties) {
    guarded(device, "creating a context", [&] {
        std::vector<cl_context_properties> all{
            CL_CONTEXT_PLATFORM, reinterpret_cast<cl_context_properties>(device.platform())};
        all.insert(all.end(), properties.begin(), properties.end());
        all.push_back(0);
        context_ = cl::Context{device.device, all.data()};
    });
}

SharedContext::Entry& SharedContext::entry(const ProgramRecipe& recipe) {
    const std::lock_guard lock{finding_};
    return programs_[recipe.options + '\n' + recipe.source];
}

cl::Program SharedContext::program(const OpenClDevice& device, const ProgramRecipe& recipe,
                                   const ProgramCache* cache) {
    Entry& own = entry(recipe);
    const std::lock_guard lock{own.building};
    if (own.program() == nullptr) own.program = make_program(device, context_, recipe, cache);
    return own.program;
}

std::shared_ptr<SharedContext> shared_context(const OpenClDevice& device) {
    Contexts& all = contexts();
    const std::lock_guard lock{all.mutex};
    std::shared_ptr<SharedContext>& own = all.of_devices[device.device()];
    if (!own) own = std::make_shared<SharedContext>(device, std::span<cl_context_properties>{});
    return own;
}

void retire(const SharedContext& context) {
    std::shared_ptr<SharedContext> last; // destroyed after the lock
    Contexts& all = contexts();
    const std::lock_guard lock{all.mutex};
    for (auto& [device, known] : all.of_devices)
        if (known.get() == &context) last.swap(known);
}

} // namespace lineatlas::compute
