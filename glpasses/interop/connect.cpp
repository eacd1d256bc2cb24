#include "connect.hpp"

#include <algorithm>
#include <cstdlib>

#include <epoxy/gl.h>

#include "compute/choose_device.hpp"
#include "compute/opencl/build_error.hpp"
#include "compute/opencl/choose_opencl.hpp"
#include "compute/opencl/opencl_backend.hpp"
#include "compute/opencl/quirks.hpp"
#include "core/memory_limit.hpp"
#include "gl_context.hpp"
#include "glpasses/current_context.hpp"
#include "lineatlas/error.hpp"
#include "round_trip.hpp"

namespace lineatlas::interop {
namespace {

/// A device that shares by a mode, null if the mode does not work, and the reason for either.
struct Attempt {
    std::unique_ptr<compute::OpenClBackend> device;
    std::string reason;
};

constexpr const char* collision =
    "it crashes beside llvmpipe, since both bring an LLVM of their own";

/// Whether the device and the driver of the current context cannot both run in one process.
bool collides(const compute::OpenClDevice& device) {
    return compute::collides_with_llvmpipe(device) && gl::is_software();
}

void refuse_collision(const compute::OpenClDevice& device) {
    if (!collides(device)) return;
    throw DeviceError(device.description() + ": " + collision +
                      "; take DeviceOptions::compute cpp, or draw paths by the method exact, which "
                      "need no GL");
}

/// The reason against a mode, found without building anything. Empty: the mode is worth trying.
std::string obstacle(const compute::OpenClDevice& device, SharingMode mode) {
    if (collides(device)) return collision;
    if (mode == SharingMode::gl_sharing) return gl_sharing_obstacle(device);
    if (mode == SharingMode::external_memory) return external_memory_obstacle(device);
    if (mode == SharingMode::host_pointer) {
        if (!device.is_cpu) return "the device is not a CPU";
        if (!gl::is_software()) return "GL does not run on the CPU";
    }
    return {};
}

std::string_view success(SharingMode mode) {
    constexpr std::string_view reasons[] = {
        "the context was accepted and a round trip succeeded",
        "GL and OpenCL import memory of a Vulkan device; a round trip succeeded",
        "device and GL share memory; a round trip succeeded", "a round trip succeeded"};
    static_assert(std::size(reasons) == all_modes.size()); // which stand in the same order
    return reasons[static_cast<std::size_t>(mode)];
}

Attempt attempt(const compute::OpenClDevice& device, SharingMode mode) {
    std::string reason = obstacle(device, mode);
    if (!reason.empty()) return {nullptr, std::move(reason)};
    std::vector<cl_context_properties> properties;
    if (mode == SharingMode::gl_sharing) properties = current_gl_properties();
    try {
        auto made = compute::make_opencl_backend(device, properties);
        if (round_trip(*made, mode)) return {std::move(made), std::string{success(mode)}};
        return {nullptr, "a round trip returned other data"};
    } catch (const compute::BuildError&) {
        throw; // then no mode works
    } catch (const DeviceError& error) {
        return {nullptr, error.what()};
    }
}

/// A remark on whether textures can be opened too. Only gl-sharing may be able to.
std::string texture_remark(compute::OpenClBackend& device) {
    try {
        if (texture_round_trip(device)) return "; textures too";
        return "; a round trip with a texture returned other data";
    } catch (const DeviceError& error) {
        return std::string{"; textures not: "} + error.what();
    }
}

/// The rank of a device by the sharing that it may be able to do, found without building anything.
int rank(const compute::OpenClDevice& device, bool software_gl) {
    if (device.has_extension("cl_khr_gl_sharing")) return 0;
    if (device.is_cpu && software_gl) return 1;
    return device.is_gpu ? 2 : 3;
}

/// A device and its mode, before its kernels are put into stages.
struct Chosen {
    std::unique_ptr<compute::Device> device;
    SharingMode mode;
    std::string note{};
    std::optional<Choice> otherwise{};
};

/// A device for a mode that works. Throws with the reason if none does. Making a device compiles
/// kernels, so the device of the attempt is kept.
Chosen choose_mode(const compute::OpenClDevice& device, std::optional<SharingMode> wanted) {
    refuse_collision(device);
    std::string reason;
    for (const SharingMode mode : all_modes) {
        if (wanted && *wanted != mode) continue;
        // Copying needs no extension, so no time is spent on trying it.
        if (mode == SharingMode::copy) return {compute::make_opencl_backend(device), mode};
        Attempt tried = attempt(device, mode);
        if (tried.device != nullptr) return {std::move(tried.device), mode};
        reason = tried.reason;
    }
    throw DeviceError(device.name() + " cannot share with GL by " + std::string{name_of(*wanted)} +
                      ": " + reason + "; `lineatlas devices` shows what works");
}

/// True if the user left the choice open and only one picture is wanted from a software GL.
/// Starting OpenCL would take longer than drawing by C++ on the same CPU. Under a memory limit
/// OpenCL is started all the same: if its drivers do not survive, GL's would not either.
bool starts_too_late(const DeviceOptions& options, const compute::WantedDevice& wanted) {
    return options.one_picture && wanted.kind.empty() && wanted.device.empty() &&
           options.interop.empty() && options.compare_with.empty() &&
           std::getenv("LINEATLAS_KERNEL_DIR") == nullptr && !memory_limit() && gl::is_software();
}

/// A device other than OpenCL's. Its memory is the host's, which a software GL can share.
Chosen choose_other(const std::string& kind, const std::string& device,
                    std::optional<SharingMode> wanted) {
    const bool shares_memory = kind == "cpp" && gl::is_software();
    return {compute::make_device(kind, device),
            wanted.value_or(shares_memory ? SharingMode::host_pointer : SharingMode::copy)};
}

/// The OpenCL devices that may be taken, without those of Choice::without.
std::vector<compute::OpenClDevice> devices_for(const compute::WantedDevice& wanted,
                                               const Choice& choice) {
    std::vector<compute::OpenClDevice> devices = compute::opencl_devices(wanted);
    std::erase_if(devices, [&](const compute::OpenClDevice& device) {
        return std::ranges::any_of(choice.without, [&](const compute::OpenClDevice& other) {
            return other.device() == device.device();
        });
    });
    return devices;
}

/// The mode that the options ask for; none: the best that works.
std::optional<SharingMode> wanted_mode(const DeviceOptions& options) {
    std::optional<SharingMode> mode = mode_of(options.interop);
    if (!options.interop.empty() && !mode) {
        throw UsageError("unknown interop \"" + options.interop + "\"; there is " + mode_names());
    }
    if (options.compare_with.empty()) return mode;
    if (!mode) mode = SharingMode::copy;
    if (is_for_one_device(*mode))
        throw UsageError("comparing devices needs DeviceOptions::interop host-pointer or copy");
    return mode;
}

Chosen choose(Choice choice, std::optional<SharingMode> mode) {
    const DeviceOptions& options = choice.options;
    const compute::WantedDevice wanted = compute::wanted_device(options.compute, options.device);
    if (!wanted.may_be_opencl()) return choose_other(wanted.kind, wanted.device, mode);
    if (starts_too_late(options, wanted)) return choose_other("cpp", "", mode);
    const bool is_open = wanted.device.empty() && options.compare_with.empty();
    std::string& failed = choice.why_without;
    for (;;) {
        const std::vector<compute::OpenClDevice> devices = devices_for(wanted, choice);
        if (devices.empty()) break;
        choice.without.push_back(devices[default_device(devices)]);
        const compute::OpenClDevice& best = choice.without.back();
        try {
            Chosen chosen = choose_mode(best, mode);
            if (!failed.empty()) chosen.note = best.description() + " is used, since " + failed;
            if (is_open) chosen.otherwise = choice;
            return chosen;
        } catch (const compute::BuildError& error) {
            if (!is_open) throw;
            failed += (failed.empty() ? "" : "; ") + std::string{error.what()};
        }
    }
    if (wanted.kind == "opencl" && !failed.empty()) throw DeviceError(failed);
    // With so little memory GL's drivers would end the process too.
    if (wanted.kind == "opencl" || (failed.empty() && compute::drivers_lack_memory()))
        throw DeviceError(compute::no_device_message());
    Chosen chosen = choose_other("cpp", "", mode);
    chosen.note = failed.empty() ? compute::note_of_cpp()
                                 : "kernels run as C++ on all cores, since " + failed;
    return chosen;
}

Connection connect_as(const Choice& choice) {
    const DeviceOptions& options = choice.options;
    const std::optional<SharingMode> mode = wanted_mode(options);
    if (options.compare_with.starts_with("opencl"))
        refuse_collision(compute::find_opencl_devices(options.compare_with).front());
    Chosen chosen = choose(choice, mode);
    chosen.device = compute::with_comparison(std::move(chosen.device), options.compare_with,
                                             options.compare_until);
    auto stages = std::make_unique<compute::Stages>(*chosen.device);
    auto sharing = std::make_unique<Sharing>(*chosen.device, chosen.mode);
    return {std::move(chosen.device), std::move(stages), std::move(sharing), std::move(chosen.note),
            std::move(chosen.otherwise)};
}

} // namespace

ModeReport probe_mode(const compute::OpenClDevice& device, SharingMode mode) {
    Attempt tried = attempt(device, mode);
    const bool works = tried.device != nullptr;
    if (works && mode == SharingMode::gl_sharing) tried.reason += texture_remark(*tried.device);
    return {mode, works, tried.reason};
}

std::size_t default_device(const std::vector<compute::OpenClDevice>& devices) {
    const bool software_gl = gl::is_software();
    const auto best =
        std::ranges::min_element(devices, {}, [&](const compute::OpenClDevice& device) {
            return rank(device, software_gl);
        });
    return static_cast<std::size_t>(best - devices.begin());
}

Connection connect(const DeviceOptions& options) {
    return connect_as({.options = options});
}

Connection connect_next(const Connection& failed, const std::string& why) {
    Choice choice = failed.otherwise.value();
    choice.why_without += (choice.why_without.empty() ? "" : "; ") + why;
    return connect_as(choice);
}

} // namespace lineatlas::interop
