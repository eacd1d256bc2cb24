#include "connect.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <numeric>

#include <dlfcn.h>
#include <epoxy/gl.h>

#include "compute/backends.hpp"
#include "compute/opencl/opencl_backend.hpp"
#include "glpasses/objects.hpp"
#include "handover.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::interop {
namespace {

/// A function of a window-system library, if this process has that library loaded already. Loading
/// it here would be wrong: a context can only be current through a library that is in use.
template <class Function>
Function* loaded_function(const char* library, const char* name) {
    void* handle = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
    if (handle == nullptr) return nullptr;
    void* function = dlsym(handle, name);
    dlclose(handle); // gives back this reference, not the library
    return reinterpret_cast<Function*>(function);
}

/// The object that a parameterless "get current" function returns, or null.
void* current_object(const char* library, const char* name) {
    auto* get_current = loaded_function<void*()>(library, name);
    return get_current != nullptr ? get_current() : nullptr;
}

/// The GL context of this thread, as OpenCL context properties (cl_khr_gl_sharing).
std::vector<cl_context_properties> current_gl_properties() {
    const auto property = [](void* value) {
        return reinterpret_cast<cl_context_properties>(value);
    };
    if (void* context = current_object("libEGL.so.1", "eglGetCurrentContext")) {
        void* display = current_object("libEGL.so.1", "eglGetCurrentDisplay");
        return {CL_GL_CONTEXT_KHR, property(context), CL_EGL_DISPLAY_KHR, property(display)};
    }
    for (const char* library : {"libGLX.so.0", "libGL.so.1"}) {
        if (void* context = current_object(library, "glXGetCurrentContext")) {
            void* display = current_object(library, "glXGetCurrentDisplay");
            return {CL_GL_CONTEXT_KHR, property(context), CL_GLX_DISPLAY_KHR, property(display)};
        }
    }
    return {};
}

/// Writes through one API, reads through the other, both ways. Throws DeviceError if a call fails;
/// false if the content does not arrive.
bool round_trip(compute::Backend& backend, SharingMode mode) {
    constexpr std::uint32_t n = 1023;
    const std::unique_ptr<SharedBuffer> buffer =
        make_shared_buffer(backend, mode, (n + 1) * sizeof(std::uint32_t));
    const std::uint32_t one = 1;
    glClearNamedBufferData(buffer->gl(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &one);
    Handover handover{backend};
    handover.to_compute({{*buffer, buffer->size()}});
    backend.scan(buffer->compute(), n, compute::ScanKind::saturate); // ones become 0, 1, 2, ...
    handover.to_gl({{*buffer, buffer->size()}});
    // Copied on the GL side first, so that GL itself has read it.
    const gl::Buffer copy = gl::Buffer::create();
    glNamedBufferStorage(copy.id(), static_cast<GLsizeiptr>(buffer->size()), nullptr, 0);
    glCopyNamedBufferSubData(buffer->gl(), copy.id(), 0, 0,
                             static_cast<GLsizeiptr>(buffer->size()));
    std::vector<std::uint32_t> seen(n + 1);
    glGetNamedBufferSubData(copy.id(), 0, static_cast<GLsizeiptr>(buffer->size()), seen.data());
    std::vector<std::uint32_t> expected(n + 1);
    std::iota(expected.begin(), expected.end(), 0U);
    return seen == expected;
}

ModeReport probe_gl_sharing(const compute::OpenClDevice& device) {
    constexpr SharingMode mode = SharingMode::gl_sharing;
    if (!device.has_extension("cl_khr_gl_sharing")) {
        return {mode, false, "the device does not list cl_khr_gl_sharing"};
    }
    const std::vector<cl_context_properties> properties = current_gl_properties();
    if (properties.empty()) return {mode, false, "no GL context is current"};
    try {
        const auto backend = compute::make_opencl_backend(device, properties);
        if (!round_trip(*backend, mode)) return {mode, false, "a round trip returned other data"};
    } catch (const Error& error) {
        return {mode, false, error.what()};
    }
    return {mode, true, "the context was accepted and a round trip succeeded"};
}

ModeReport probe_host_pointer(const compute::OpenClDevice& device) {
    constexpr SharingMode mode = SharingMode::host_pointer;
    if (!device.is_cpu) return {mode, false, "the device is not a CPU"};
    if (!gl_is_software()) return {mode, false, "GL does not run on the CPU"};
    try {
        const auto backend = compute::make_opencl_backend(device);
        if (!round_trip(*backend, mode)) return {mode, false, "a round trip returned other data"};
    } catch (const Error& error) {
        return {mode, false, error.what()};
    }
    return {mode, true, "device and GL share memory; a round trip succeeded"};
}

ModeReport probe(const compute::OpenClDevice& device, SharingMode mode) {
    switch (mode) {
    case SharingMode::gl_sharing:
        return probe_gl_sharing(device);
    case SharingMode::host_pointer:
        return probe_host_pointer(device);
    case SharingMode::copy:
        break;
    }
    return {SharingMode::copy, true, "always works"};
}

constexpr std::array all_modes{SharingMode::gl_sharing, SharingMode::host_pointer,
                               SharingMode::copy};

/// The cheap part of the probes: what the device could do, without building anything.
int rank(const compute::OpenClDevice& device, bool software_gl) {
    if (device.has_extension("cl_khr_gl_sharing")) return 0;
    if (device.is_cpu && software_gl) return 1;
    return device.is_gpu ? 2 : 3;
}

compute::OpenClDevice choose_device(const std::string& wanted) {
    const std::vector<compute::OpenClDevice> devices =
        wanted.empty() ? compute::list_opencl_devices() : compute::find_opencl_devices(wanted);
    if (devices.empty()) {
        throw DeviceError("no OpenCL device was found; " + compute::opencl_advice());
    }
    return devices[default_device(devices)];
}

/// The backend for a mode if that mode works, with the reason if not. Building a backend compiles
/// kernels, so the probe's own is kept.
Connection connect_device(const compute::OpenClDevice& device, std::optional<SharingMode> wanted) {
    std::string reason;
    for (const SharingMode mode : all_modes) {
        if (wanted && *wanted != mode) continue;
        if (mode == SharingMode::copy) return {compute::make_opencl_backend(device), mode};
        std::vector<cl_context_properties> properties;
        if (mode == SharingMode::gl_sharing) {
            properties = current_gl_properties();
            if (!device.has_extension("cl_khr_gl_sharing") || properties.empty()) {
                reason = "the device does not list cl_khr_gl_sharing";
                continue;
            }
        } else if (!device.is_cpu || !gl_is_software()) {
            reason = "device and GL do not share memory";
            continue;
        }
        try {
            Connection connection{compute::make_opencl_backend(device, properties), mode};
            if (round_trip(*connection.backend, mode)) return connection;
            reason = "a round trip returned other data";
        } catch (const DeviceError& error) {
            reason = error.what();
        }
    }
    throw DeviceError(device.name() + " cannot share with GL by " + std::string{name_of(*wanted)} +
                      ": " + reason + "; `lineatlas devices` shows what works");
}

} // namespace

std::array<ModeReport, 3> probe_modes(const compute::OpenClDevice& device) {
    return {probe(device, all_modes[0]), probe(device, all_modes[1]), probe(device, all_modes[2])};
}

bool gl_is_software() {
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    if (renderer == nullptr) return false;
    return std::strstr(renderer, "llvmpipe") != nullptr ||
           std::strstr(renderer, "softpipe") != nullptr;
}

std::size_t default_device(const std::vector<compute::OpenClDevice>& devices) {
    const bool software_gl = gl_is_software();
    const auto best =
        std::ranges::min_element(devices, {}, [&](const compute::OpenClDevice& device) {
            return rank(device, software_gl);
        });
    return static_cast<std::size_t>(best - devices.begin());
}

Connection connect(const ConnectOptions& options) {
    if (options.backend != "opencl") {
        return {compute::make_backend(options.backend, options.device),
                options.mode.value_or(SharingMode::copy)};
    }
    std::string wanted = options.device;
    if (wanted.empty()) {
        if (const char* variable = std::getenv("LINEATLAS_DEVICE")) wanted = variable;
    }
    return connect_device(choose_device(wanted), options.mode);
}

} // namespace lineatlas::interop
