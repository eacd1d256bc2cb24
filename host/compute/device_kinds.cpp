#include <algorithm>

#include "choose_device.hpp"
#include "cpp/cpp_device.hpp"
#include "lineatlas/error.hpp"
#include "opencl/choose_opencl.hpp"

namespace lineatlas::compute {
namespace {

std::unique_ptr<Device> make_cpp(std::string_view) {
    return make_cpp_device();
}

std::vector<DeviceKind> own_kinds() {
    std::vector<DeviceKind> kinds;
    if (std::optional<DeviceKind> opencl = opencl_kind()) kinds.push_back(*std::move(opencl));
    kinds.push_back({"cpp", "kernels as C++ on all cores", make_cpp});
    return kinds;
}

std::vector<DeviceKind>& table() {
    static std::vector<DeviceKind> kinds = own_kinds();
    return kinds;
}

} // namespace

const std::vector<DeviceKind>& device_kinds() {
    return table();
}

void register_device(DeviceKind kind) {
    if (std::ranges::find(table(), kind.name, &DeviceKind::name) != table().end()) {
        throw UsageError("there is a compute backend \"" + kind.name + "\" already");
    }
    table().push_back(std::move(kind));
}

std::string device_kind_names() {
    std::string names;
    for (const DeviceKind& kind : table()) names += (names.empty() ? "" : ", ") + kind.name;
    return names;
}

namespace {

const DeviceKind& find_kind(std::string_view name) {
    const auto found = std::ranges::find(table(), name, &DeviceKind::name);
    if (found != table().end()) return *found;
    throw UsageError("unknown compute backend \"" + std::string{name} + "\"; there is " +
                     device_kind_names());
}

} // namespace

void check_device_kind(std::string_view name) {
    find_kind(name);
}

std::unique_ptr<Device> make_device(std::string_view name, std::string_view device) {
    return find_kind(name).make(device);
}

} // namespace lineatlas::compute
