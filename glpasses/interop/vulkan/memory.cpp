#include "glpasses/interop/vulkan_memory.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <vulkan/vulkan_core.h>

#include "lineatlas/error.hpp"

namespace lineatlas::interop {
namespace {

constexpr const char* file = "libvulkan.so.1";
constexpr VkExternalMemoryHandleTypeFlagBits opaque = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
constexpr std::array extensions{VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME};

// llvmpipe refuses memory that is no larger than the buffer.
constexpr std::size_t room_behind = 4096;

void check(VkResult result, const char* call) {
    if (result != VK_SUCCESS)
        throw DeviceError("Vulkan's " + std::string{call} + " returned " + std::to_string(result));
}

/// A Vulkan struct with only its type set.
template <class Struct>
Struct empty(VkStructureType type) {
    Struct result{};
    result.sType = type;
    return result;
}

/// The library's only symbol, which finds all others. The library stays loaded, because drivers
/// that it has loaded do not survive its end.
PFN_vkGetInstanceProcAddr load() {
    static void* const library = ::dlopen(file, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw DeviceError(std::string{"there is no "} + file);
    return reinterpret_cast<PFN_vkGetInstanceProcAddr>(::dlsym(library, "vkGetInstanceProcAddr"));
}

/// A device whose objects stay until the process ends. When NVIDIA's driver ends an instance, no GL
/// context is current any more.
class Device final : public VulkanMemory {
  public:
    /// Throws DeviceError if there is no device of that name, or it does not export memory.
    void open(const DeviceUuid& uuid) {
        make_instance();
        const VkPhysicalDevice physical = find(uuid);
        make_device(physical);
        choose_type(physical);
    }

    ExportedMemory allocate(std::size_t bytes) const override {
        auto exported =
            empty<VkExportMemoryAllocateInfo>(VK_STRUCTURE_TYPE_EXPORT_MEMORY_ALLOCATE_INFO);
        exported.handleTypes = opaque;
        auto info = empty<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
        info.pNext = &exported;
        info.allocationSize = (bytes + room_behind + alignment_ - 1) / alignment_ * alignment_;
        info.memoryTypeIndex = type_;
        VkDeviceMemory memory = VK_NULL_HANDLE;
        const auto allocate = of_device<PFN_vkAllocateMemory>("vkAllocateMemory");
        check(allocate(device_, &info, nullptr, &memory), "vkAllocateMemory");
        ExportedMemory result{info.allocationSize, descriptor_of(memory), descriptor_of(memory)};
        // The descriptors hold the memory.
        of_device<PFN_vkFreeMemory>("vkFreeMemory")(device_, memory, nullptr);
        if (!result.for_gl.is_open() || !result.for_compute.is_open())
            throw DeviceError("Vulkan's vkGetMemoryFdKHR failed");
        return result;
    }

  private:
    template <class Function>
    Function of_instance(const char* name) const {
        return reinterpret_cast<Function>(load()(instance_, name));
    }
    template <class Function>
    Function of_device(const char* name) const {
        const auto get = of_instance<PFN_vkGetDeviceProcAddr>("vkGetDeviceProcAddr");
        return reinterpret_cast<Function>(get(device_, name));
    }

    void make_instance() {
        auto application = empty<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
        application.apiVersion = VK_API_VERSION_1_1;
        auto info = empty<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
        info.pApplicationInfo = &application;
        check(of_instance<PFN_vkCreateInstance>("vkCreateInstance")(&info, nullptr, &instance_),
              "vkCreateInstance");
    }

    VkPhysicalDevice find(const DeviceUuid& uuid) const {
        const auto list = of_instance<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices");
        const auto describe =
            of_instance<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2");
        std::uint32_t count = 0;
        check(list(instance_, &count, nullptr), "vkEnumeratePhysicalDevices");
        std::vector<VkPhysicalDevice> devices(count);
        check(list(instance_, &count, devices.data()), "vkEnumeratePhysicalDevices");
        for (const VkPhysicalDevice device : devices) {
            auto id = empty<VkPhysicalDeviceIDProperties>(
                VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES);
            auto properties =
                empty<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
            properties.pNext = &id;
            describe(device, &properties);
            if (std::ranges::equal(id.deviceUUID, uuid)) return device;
        }
        throw DeviceError("Vulkan has no device that is GL's");
    }

    void make_device(VkPhysicalDevice physical) {
        constexpr float priority = 1;
        auto queue = empty<VkDeviceQueueCreateInfo>(
            VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO); // a device must have a queue
        queue.queueCount = 1;
        queue.pQueuePriorities = &priority;
        auto info = empty<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
        info.queueCreateInfoCount = 1;
        info.pQueueCreateInfos = &queue;
        info.enabledExtensionCount = extensions.size();
        info.ppEnabledExtensionNames = extensions.data();
        check(of_instance<PFN_vkCreateDevice>("vkCreateDevice")(physical, &info, nullptr, &device_),
              "vkCreateDevice");
    }

    /// Chooses the device's own memory among the types that buffers take.
    void choose_type(VkPhysicalDevice physical) {
        const VkMemoryRequirements wanted = requirements();
        VkPhysicalDeviceMemoryProperties memory{};
        of_instance<PFN_vkGetPhysicalDeviceMemoryProperties>("vkGetPhysicalDeviceMemoryProperties")(
            physical, &memory);
        alignment_ = wanted.alignment;
        for (type_ = 0; type_ < memory.memoryTypeCount; ++type_) {
            const bool fits = (wanted.memoryTypeBits >> type_ & 1U) != 0;
            const bool is_own = (memory.memoryTypes[type_].propertyFlags &
                                 VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT) != 0;
            if (fits && is_own) return;
        }
        throw DeviceError("Vulkan exports no memory of the device");
    }

    VkMemoryRequirements requirements() const {
        auto external = empty<VkExternalMemoryBufferCreateInfo>(
            VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_BUFFER_CREATE_INFO);
        external.handleTypes = opaque;
        auto info = empty<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
        info.pNext = &external;
        info.size = 1U << 20U;
        info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                     VK_BUFFER_USAGE_TRANSFER_DST_BIT;
        VkBuffer buffer = VK_NULL_HANDLE;
        check(of_device<PFN_vkCreateBuffer>("vkCreateBuffer")(device_, &info, nullptr, &buffer),
              "vkCreateBuffer");
        VkMemoryRequirements result{};
        of_device<PFN_vkGetBufferMemoryRequirements>("vkGetBufferMemoryRequirements")(
            device_, buffer, &result);
        of_device<PFN_vkDestroyBuffer>("vkDestroyBuffer")(device_, buffer, nullptr);
        return result;
    }

    /// The descriptor of memory; closed if that fails.
    FileDescriptor descriptor_of(VkDeviceMemory memory) const {
        auto info = empty<VkMemoryGetFdInfoKHR>(VK_STRUCTURE_TYPE_MEMORY_GET_FD_INFO_KHR);
        info.memory = memory;
        info.handleType = opaque;
        int number = -1;
        const auto get = of_device<PFN_vkGetMemoryFdKHR>("vkGetMemoryFdKHR");
        return FileDescriptor{get(device_, &info, &number) == VK_SUCCESS ? number : -1};
    }

    VkInstance instance_ = nullptr;
    VkDevice device_ = nullptr;
    std::uint32_t type_ = 0;
    std::size_t alignment_ = 1;
};

} // namespace

const VulkanMemory& vulkan_memory(const DeviceUuid& uuid) {
    struct Known {
        Device device;
        std::string failure{};
    };
    static std::mutex mutex;
    static auto& all = *new std::map<DeviceUuid, Known>; // see Device
    const std::scoped_lock lock{mutex};
    const auto [found, is_new] = all.try_emplace(uuid);
    Known& known = found->second;
    if (is_new) {
        try {
            known.device.open(uuid);
        } catch (const DeviceError& error) {
            known.failure = error.what();
        }
    }
    if (!known.failure.empty()) throw DeviceError(known.failure);
    return known.device;
}

} // namespace lineatlas::interop
