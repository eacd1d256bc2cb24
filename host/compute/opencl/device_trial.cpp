#include "device_trial.hpp"

#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "build_error.hpp"
#include "content_hash.hpp"
#include "opencl_backend.hpp"
#include "programs.hpp"
#include "sources/sources.hpp"

namespace lineatlas::compute {
namespace {

constexpr std::string_view passed = "passed", begun = "begun";

/// Everything that a verdict depends on.
std::string key_of(const OpenClBackend& device, std::string_view what) {
    ContentHash kernels;
    for (const EmbeddedSource& source : embedded_kernels())
        kernels = kernels.with(std::as_bytes(std::span{source.text}));
    return "trial of " + std::string{what} + '\n' +
           cache_key(device.device(), {.name = "trial",
                                       .source = kernels.text(),
                                       .options = compiler_options(device.tuning())});
}

/// The verdict on a device. Nothing if something else went wrong that says nothing about kernels.
std::optional<std::string> verdict_of(const OpenClDevice& device,
                                      const std::function<void(const DeviceOptions&)>& run) {
    try {
        run({.compute = "opencl", .device = device.name(), .compare_with = "cpp"});
        return std::string{passed};
    } catch (const MismatchError& error) {
        return error.what();
    } catch (const BuildError&) {
        throw;
    } catch (const DeviceError&) {
        return std::nullopt;
    }
}

std::string kept_verdict(const ProgramCache& cache, const std::string& key) {
    const std::optional<std::vector<unsigned char>> kept = cache.find(key);
    return kept ? std::string{kept->begin(), kept->end()} : std::string{};
}

void keep(const ProgramCache& cache, const std::string& key, const std::string& verdict) {
    cache.store(key, {reinterpret_cast<const unsigned char*>(verdict.data()), verdict.size()});
}

/// Verdicts of this process, so that it reads files once.
struct Verdicts {
    std::mutex mutex;
    std::map<std::pair<cl_device_id, std::string>, std::string> known;
};

Verdicts& verdicts() {
    static Verdicts result;
    return result;
}

} // namespace

bool try_device(const Device& device, std::string_view what,
                const std::function<void(const DeviceOptions&)>& run) {
    const auto* opencl = dynamic_cast<const OpenClBackend*>(&device);
    if (opencl == nullptr || std::getenv("LINEATLAS_KERNEL_DIR") != nullptr) return false;
    const std::optional<ProgramCache> cache = user_program_cache(true);
    if (!cache) return false;
    const std::scoped_lock lock{verdicts().mutex}; // other threads wait for the same answer
    std::string& verdict = verdicts().known[{opencl->device().device(), std::string{what}}];
    if (verdict.empty()) {
        const std::string key = key_of(*opencl, what);
        verdict = kept_verdict(*cache, key);
        if (verdict.empty() || verdict == begun) { // or a trial that ended with its process
            verdict.clear();
            keep(*cache, key, std::string{begun});
            if (kept_verdict(*cache, key) != begun) return false; // the folder is not writable
            const auto found = verdict_of(opencl->device(), run);
            if (!found) return false;
            verdict = *found;
            keep(*cache, key, verdict);
        }
    }
    if (verdict != passed)
        throw BuildError(opencl->device().description() + ": its driver, " +
                         opencl->device().driver_version +
                         ", builds a kernel that computes something else than C++: " + verdict);
    return true;
}

} // namespace lineatlas::compute
