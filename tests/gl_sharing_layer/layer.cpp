#include "layer.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <CL/cl_layer.h>

#include "gl_watch.hpp"
#include "sharing.hpp"
#include "state.hpp"

// How LINEATLAS_TEST_LAYER says the driver behaves; without it, as it should.
//   events        also lists cl_khr_gl_event, and GL sees what is released without clFinish
//   crash, hang   in clCreateContext with a GL context
//   refuse        clCreateContext fails
//   lie           clCreateContext succeeds, but no buffer can be opened
//   stale         buffers can be opened, but acquiring them brings nothing
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
    return value != nullptr && name == value;
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
    extensions += " cl_khr_gl_sharing";
    if (behaves("events")) extensions += " cl_khr_gl_event";
    if (size_needed != nullptr) *size_needed = extensions.size() + 1;
    if (value == nullptr) return CL_SUCCESS;
    if (size <= extensions.size()) return CL_INVALID_VALUE;
    std::memcpy(value, extensions.c_str(), extensions.size() + 1);
    return CL_SUCCESS;
}

void* CL_API_CALL get_function(cl_platform_id platform, const char* name) {
    const std::string_view wanted = name;
    if (wanted == "clGetGLContextInfoKHR" || wanted == "clCreateEventFromGLsyncKHR") {
        return sharing_function(name);
    }
    return state().driver->clGetExtensionFunctionAddressForPlatform(platform, name);
}

} // namespace
} // namespace lineatlas::test

lineatlas::test::LayerCounts lineatlas_test_take_layer_counts() {
    return std::exchange(lineatlas::test::state().counts, {});
}

cl_int CL_API_CALL clGetLayerInfo(cl_layer_info name, size_t size, void* value,
                                  size_t* size_needed) {
    if (name != CL_LAYER_API_VERSION) return CL_INVALID_VALUE;
    constexpr cl_layer_api_version version = CL_LAYER_API_VERSION_100;
    if (size_needed != nullptr) *size_needed = sizeof(version);
    if (value == nullptr) return CL_SUCCESS;
    if (size < sizeof(version)) return CL_INVALID_VALUE;
    std::memcpy(value, &version, sizeof(version));
    return CL_SUCCESS;
}

cl_int CL_API_CALL clInitLayer(cl_uint entries, const cl_icd_dispatch* driver,
                               cl_uint* entries_result, const cl_icd_dispatch** result) {
    static cl_icd_dispatch table{};
    constexpr auto own_entries = static_cast<cl_uint>(sizeof(table) / sizeof(table.clFinish));
    if (entries < own_entries) return CL_INVALID_VALUE;
    lineatlas::test::state().driver = driver;
    table = *driver;
    table.clGetDeviceInfo = lineatlas::test::get_device_info;
    table.clGetExtensionFunctionAddressForPlatform = lineatlas::test::get_function;
    lineatlas::test::add_sharing(table);
    lineatlas::test::add_checks(table);
    lineatlas::test::watch_gl();
    *entries_result = own_entries;
    *result = &table;
    return CL_SUCCESS;
}
