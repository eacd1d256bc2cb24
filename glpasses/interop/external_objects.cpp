#include "external_objects.hpp"

#include <optional>

#include <epoxy/gl.h>

#include "compute/opencl/loader.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::interop {
namespace {

constexpr const char* gl_extension = "GL_EXT_memory_object_fd";
constexpr const char* extension = "cl_khr_external_memory_opaque_fd";

// Constants of OpenCL 3.0 and its extensions. Headers hide them from programs for 1.2.
constexpr cl_device_info device_uuid = 0x106A;
constexpr cl_ulong opaque_descriptor = 0x2060;

DeviceUuid uuid_of_gl() {
    DeviceUuid uuid{};
    glGetUnsignedBytei_vEXT(GL_DEVICE_UUID_EXT, 0, uuid.data());
    return uuid;
}

/// The UUID of a device; none if OpenCL does not tell it.
std::optional<DeviceUuid> uuid_of(const compute::OpenClDevice& device) {
    DeviceUuid uuid{};
    if (!device.has_extension("cl_khr_device_uuid") ||
        clGetDeviceInfo(device.device(), device_uuid, uuid.size(), uuid.data(), nullptr) !=
            CL_SUCCESS)
        return std::nullopt;
    return uuid;
}

} // namespace

std::string external_memory_obstacle(const compute::OpenClDevice& device) {
    if (!device.has_extension(extension))
        return std::string{"the device does not list "} + extension;
    if (!epoxy_has_gl_extension(gl_extension))
        return std::string{"GL does not list "} + gl_extension;
    if (const std::optional<DeviceUuid> uuid = uuid_of(device); uuid && *uuid != uuid_of_gl())
        return "GL runs on another device";
    return {};
}

template <class Function>
Function ExternalObjects::function(const char* name) const {
    auto* const found = clGetExtensionFunctionAddressForPlatform(device_.device().platform(), name);
    if (found == nullptr) throw DeviceError(std::string{"the driver has no "} + name);
    return reinterpret_cast<Function>(found);
}

ExternalObjects::ExternalObjects(const compute::OpenClBackend& device) : device_(device) {
    if (const std::string why = external_memory_obstacle(device.device()); !why.empty())
        throw DeviceError(why + "; use DeviceOptions::interop copy");
    vulkan_ = &vulkan_memory(uuid_of_gl());
    acquire_ = function<Handover>("clEnqueueAcquireExternalMemObjectsKHR");
    release_ = function<Handover>("clEnqueueReleaseExternalMemObjectsKHR");
    create_ = reinterpret_cast<CreateBuffer>(
        compute::opencl_library().function("clCreateBufferWithProperties"));
    if (create_ == nullptr) throw DeviceError("OpenCL's loader is older than OpenCL 3.0");
}

std::unique_ptr<compute::OpenClBuffer> ExternalObjects::open(FileDescriptor& memory,
                                                             std::size_t bytes) const {
    const std::array<cl_ulong, 3> properties{opaque_descriptor,
                                             static_cast<cl_ulong>(memory.number()), 0};
    cl_int status = CL_SUCCESS;
    cl::Buffer opened{create_(device_.context()(), properties.data(), CL_MEM_READ_WRITE, bytes,
                              nullptr, &status)};
    check_handover(status, "clCreateBufferWithProperties");
    memory.release(); // OpenCL owns it from here on
    return std::make_unique<compute::OpenClBuffer>(std::move(opened), bytes);
}

void ExternalObjects::acquire(_cl_mem* object) {
    check_handover(acquire_(device_.queue()(), 1, &object, 0, nullptr, nullptr),
                   "clEnqueueAcquireExternalMemObjectsKHR");
}

void ExternalObjects::release(std::span<_cl_mem* const> objects) {
    check_handover(release_(device_.queue()(), static_cast<cl_uint>(objects.size()), objects.data(),
                            0, nullptr, nullptr),
                   "clEnqueueReleaseExternalMemObjectsKHR");
}

} // namespace lineatlas::interop
