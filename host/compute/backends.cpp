#include "backends.hpp"

#include <algorithm>

#include "lineatlas/error.hpp"
#include "opencl/opencl_backend.hpp"

namespace lineatlas::compute {
namespace {

std::unique_ptr<Backend> make_opencl(std::string_view device) {
    return make_opencl_backend(find_opencl_devices(device.empty() ? "opencl" : device).front());
}

std::unique_ptr<Backend> make_reference(std::string_view) {
    return make_reference_backend();
}

std::vector<BackendKind>& table() {
    // A new backend is one line here and a folder beside this file.
    static std::vector<BackendKind> kinds{
        {"opencl", "kernels on an OpenCL device", make_opencl},
        {"reference", "plain C++ on the CPU", make_reference},
    };
    return kinds;
}

} // namespace

const std::vector<BackendKind>& backend_kinds() {
    return table();
}

void register_backend(BackendKind kind) {
    if (std::ranges::find(table(), kind.name, &BackendKind::name) != table().end()) {
        throw UsageError("there is a compute backend \"" + kind.name + "\" already");
    }
    table().push_back(std::move(kind));
}

std::string backend_names() {
    std::string names;
    for (const BackendKind& kind : table()) names += (names.empty() ? "" : ", ") + kind.name;
    return names;
}

std::unique_ptr<Backend> make_backend(std::string_view name, std::string_view device) {
    const auto found = std::ranges::find(table(), name, &BackendKind::name);
    if (found != table().end()) return found->make(device);
    throw UsageError("unknown compute backend \"" + std::string{name} + "\"; there is " +
                     backend_names());
}

} // namespace lineatlas::compute
