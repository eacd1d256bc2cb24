#include "layer.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

#include "gl_watch.hpp"
#include "opencl_layer_entry.hpp"
#include "sharing.hpp"
#include "state.hpp"

// How LINEATLAS_TEST_LAYER says the driver behaves, by one word or several; without it, as it
// should.
//   external      lists cl_khr_external_memory in place of cl_khr_gl_sharing
//   events        also lists cl_khr_gl_event, and GL sees what is released without clFinish
//   crash, hang   in clCreateContext with a GL context
//   refuse        clCreateContext fails
//   lie           clCreateContext succeeds, but no buffer can be opened
//   stale         objects can be opened, but acquiring them brings nothing
//   buffers-only  textures cannot be opened
//   other-device  clGetGLContextInfoKHR names no device
//   no-query      there is no clGetGLContextInfoKHR

namespace lineatlas::test {

State& state() {
    static State state;
    return state;
}

bool behaves(std::string_view name) {
    const char* value = std::getenv("LINEATLAS_TEST_LAYER");
    return value != nullptr && std::string_view{value}.find(name) != std::string_view::npos;
}

void violation(const std::string& message) {
    ++state().counts.violations;
    std::fprintf(stderr, "gl_sharing_layer: %s\n", message.c_str());
}

void check_use(cl_mem object, const char* by) {
    const auto found = state().opened.find(object);
    if (found == state().opened.end() || found->second.acquired) return;
    violation(std::string{by} + " uses a GL object that is not acquired");
}

namespace {

cl_int CL_API_CALL get_device_info(cl_device_id device, cl_device_info name, size_t size,
                                   void* value, size_t* size_needed) {
    const cl_icd_dispatch& driver = *state().driver;
    if (name != CL_DEVICE_EXTENSIONS) {
        return driver.clGetDeviceInfo(device, name, size, value, size_needed);
    }
    size_t length = 0;
    driver.clGetDeviceInfo(device, name, 0, nullptr, &length);
    std::string extensions(length, '\0');
    driver.clGetDeviceInfo(device, name, length, extensions.data(), nullptr);
    extensions.resize(std::strlen(extensions.c_str()));
    extensions += behaves("external") ? " cl_khr_external_memory cl_khr_external_memory_opaque_fd"
                                      : " cl_khr_gl_sharing";
    if (behaves("events")) extensions += " cl_khr_gl_event";
    if (size_needed != nullptr) *size_needed = extensions.size() + 1;
    if (value == nullptr) return CL_SUCCESS;
    if (size <= extensions.size()) return CL_INVALID_VALUE;
    std::memcpy(value, extensions.c_str(), extensions.size() + 1);
    return CL_SUCCESS;
}

void* CL_API_CALL get_function(cl_platform_id platform, const char* name) {
    if (is_sharing_function(name)) return sharing_function(name);
    return state().driver->clGetExtensionFunctionAddressForPlatform(platform, name);
}

} // namespace

void begin_layer(const cl_icd_dispatch& driver, cl_icd_dispatch& table) {
    state().driver = &driver;
    table.clGetDeviceInfo = get_device_info;
    table.clGetExtensionFunctionAddressForPlatform = get_function;
    add_sharing(table);
    add_checks(table);
    watch_gl();
}

} // namespace lineatlas::test

lineatlas::test::LayerCounts lineatlas_test_take_layer_counts() {
    return std::exchange(lineatlas::test::state().counts, {});
}
