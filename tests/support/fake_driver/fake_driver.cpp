// A driver of OpenCL with devices in name alone. LINEATLAS_TEST_DRIVER says what it does:
//   abort    ends the process that asks for its devices
//   refuse   has no platform
//   twins    has two platforms of one name, with a device of one name each
//   family   has two platforms of one name, with a Card Plus and a Card
//   silent   as one of the twins; its compiler refuses all programs and does not say why

#include <array>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <CL/cl_icd.h>

namespace {

std::string_view wanted() {
    const char* const text = std::getenv("LINEATLAS_TEST_DRIVER");
    return text != nullptr ? text : "";
}

cl_icd_dispatch table{};

} // namespace

// The loader reads the first member of all objects that a driver returns.
struct _cl_platform_id {
    cl_icd_dispatch* dispatch = &table;
};
struct _cl_device_id {
    cl_icd_dispatch* dispatch = &table;
    cl_platform_id platform = nullptr;
};
struct _cl_context {
    cl_icd_dispatch* dispatch = &table;
};
struct _cl_command_queue {
    cl_icd_dispatch* dispatch = &table;
};
struct _cl_program {
    cl_icd_dispatch* dispatch = &table;
};

namespace {

std::array<_cl_platform_id, 2> platforms;
std::array<_cl_device_id, 2> devices;
_cl_context context;
_cl_command_queue queue;
_cl_program program;

cl_int answer(std::string_view text, size_t size, void* value, size_t* size_needed) {
    if (size_needed != nullptr) *size_needed = text.size() + 1;
    if (value == nullptr) return CL_SUCCESS;
    if (size < text.size() + 1) return CL_INVALID_VALUE;
    std::memcpy(value, text.data(), text.size());
    static_cast<char*>(value)[text.size()] = '\0';
    return CL_SUCCESS;
}

template <class Value>
cl_int answer_value(const Value& number, size_t size, void* value, size_t* size_needed) {
    if (size_needed != nullptr) *size_needed = sizeof(number);
    if (value != nullptr && size >= sizeof(number)) std::memcpy(value, &number, sizeof(number));
    return CL_SUCCESS;
}

cl_int CL_API_CALL platform_ids(cl_uint entries, cl_platform_id* found, cl_uint* count) {
    if (wanted() == "refuse") return CL_PLATFORM_NOT_FOUND_KHR;
    const cl_uint all = wanted() == "twins" || wanted() == "family" ? 2 : 1;
    if (count != nullptr) *count = all;
    for (cl_uint i = 0; found != nullptr && i < all && i < entries; ++i) found[i] = &platforms[i];
    return CL_SUCCESS;
}

cl_int CL_API_CALL platform_info(cl_platform_id, cl_platform_info name, size_t size, void* value,
                                 size_t* size_needed) {
    switch (name) {
    case CL_PLATFORM_NAME:
        return answer("Fake", size, value, size_needed);
    case CL_PLATFORM_VERSION:
        return answer("OpenCL 1.2 Fake", size, value, size_needed);
    case CL_PLATFORM_EXTENSIONS:
        return answer("cl_khr_icd", size, value, size_needed);
    case CL_PLATFORM_ICD_SUFFIX_KHR:
        return answer("FAKE", size, value, size_needed);
    default:
        return answer("", size, value, size_needed);
    }
}

cl_int CL_API_CALL device_ids(cl_platform_id platform, cl_device_type, cl_uint entries,
                              cl_device_id* found, cl_uint* count) {
    if (wanted() == "abort") std::abort();
    _cl_device_id& own = devices[static_cast<std::size_t>(platform - platforms.data())];
    own.platform = platform;
    if (count != nullptr) *count = 1;
    if (found != nullptr && entries > 0) *found = &own;
    return CL_SUCCESS;
}

cl_int CL_API_CALL device_info(cl_device_id device, cl_device_info name, size_t size, void* value,
                               size_t* size_needed) {
    switch (name) {
    case CL_DEVICE_TYPE:
        return answer_value(cl_device_type{CL_DEVICE_TYPE_GPU}, size, value, size_needed);
    case CL_DEVICE_PLATFORM:
        return answer_value(device->platform, size, value, size_needed);
    case CL_DEVICE_MAX_WORK_GROUP_SIZE:
        return answer_value(size_t{256}, size, value, size_needed);
    case CL_DEVICE_LOCAL_MEM_SIZE:
    case CL_DEVICE_GLOBAL_MEM_SIZE:
    case CL_DEVICE_MAX_MEM_ALLOC_SIZE:
        return answer_value(cl_ulong{1} << 30U, size, value, size_needed);
    case CL_DEVICE_SINGLE_FP_CONFIG:
        return answer_value(cl_device_fp_config{0}, size, value, size_needed);
    case CL_DEVICE_NAME:
        return answer(wanted() == "family" && device == devices.data() ? "Card Plus" : "Card", size,
                      value, size_needed);
    case CL_DEVICE_VERSION:
        return answer("OpenCL 1.2 Fake", size, value, size_needed);
    default:
        return answer("", size, value, size_needed);
    }
}

cl_context CL_API_CALL create_context(const cl_context_properties*, cl_uint, const cl_device_id*,
                                      void(CL_CALLBACK*)(const char*, const void*, size_t, void*),
                                      void*, cl_int* status) {
    const bool works = wanted() == "silent";
    if (status != nullptr) *status = works ? CL_SUCCESS : CL_INVALID_VALUE;
    return works ? &context : nullptr;
}
cl_command_queue CL_API_CALL create_queue(cl_context, cl_device_id, cl_command_queue_properties,
                                          cl_int* status) {
    if (status != nullptr) *status = CL_SUCCESS;
    return &queue;
}
cl_mem CL_API_CALL create_buffer(cl_context, cl_mem_flags, size_t, void*, cl_int* status) {
    if (status != nullptr) *status = CL_MEM_OBJECT_ALLOCATION_FAILURE;
    return nullptr;
}
cl_program CL_API_CALL create_program(cl_context, cl_uint, const char**, const size_t*,
                                      cl_int* status) {
    if (status != nullptr) *status = CL_SUCCESS;
    return &program;
}
cl_int CL_API_CALL build_program(cl_program, cl_uint, const cl_device_id*, const char*,
                                 void(CL_CALLBACK*)(cl_program, void*), void*) {
    return CL_BUILD_PROGRAM_FAILURE;
}
cl_int CL_API_CALL compile_program(cl_program, cl_uint, const cl_device_id*, const char*, cl_uint,
                                   const cl_program*, const char**,
                                   void(CL_CALLBACK*)(cl_program, void*), void*) {
    return CL_COMPILE_PROGRAM_FAILURE;
}
cl_int CL_API_CALL program_info(cl_program, cl_program_info name, size_t size, void* value,
                                size_t* size_needed) {
    if (name == CL_PROGRAM_NUM_DEVICES) return answer_value(cl_uint{1}, size, value, size_needed);
    return answer_value(cl_device_id{&devices[0]}, size, value, size_needed); // CL_PROGRAM_DEVICES
}
cl_int CL_API_CALL build_info(cl_program, cl_device_id, cl_program_build_info, size_t size,
                              void* value, size_t* size_needed) {
    return answer("", size, value, size_needed);
}

template <class Object>
cl_int CL_API_CALL count_reference(Object) {
    return CL_SUCCESS; // all objects live as long as the process
}

bool fill_table() {
    table.clGetPlatformIDs = platform_ids;
    table.clGetPlatformInfo = platform_info;
    table.clGetDeviceIDs = device_ids;
    table.clGetDeviceInfo = device_info;
    table.clRetainDevice = count_reference<cl_device_id>;
    table.clReleaseDevice = count_reference<cl_device_id>;
    table.clCreateContext = create_context;
    table.clRetainContext = count_reference<cl_context>;
    table.clReleaseContext = count_reference<cl_context>;
    table.clCreateCommandQueue = create_queue;
    table.clRetainCommandQueue = count_reference<cl_command_queue>;
    table.clReleaseCommandQueue = count_reference<cl_command_queue>;
    table.clFinish = count_reference<cl_command_queue>;
    table.clCreateBuffer = create_buffer;
    table.clCreateProgramWithSource = create_program;
    table.clRetainProgram = count_reference<cl_program>;
    table.clReleaseProgram = count_reference<cl_program>;
    table.clBuildProgram = build_program;
    table.clCompileProgram = compile_program;
    table.clGetProgramInfo = program_info;
    table.clGetProgramBuildInfo = build_info;
    return true;
}

const bool is_filled = fill_table();

} // namespace

extern "C" [[gnu::visibility("default")]] void* clGetExtensionFunctionAddress(const char* name) {
    const std::string_view function = name;
    if (function == "clIcdGetPlatformIDsKHR") return reinterpret_cast<void*>(platform_ids);
    if (function == "clGetPlatformInfo") return reinterpret_cast<void*>(platform_info);
    return nullptr;
}
extern "C" [[gnu::visibility("default")]] cl_int
clIcdGetPlatformIDsKHR(cl_uint entries, cl_platform_id* found, cl_uint* count) {
    return platform_ids(entries, found, count);
}
extern "C" [[gnu::visibility("default")]] cl_int clGetPlatformInfo(cl_platform_id platform,
                                                                   cl_platform_info name,
                                                                   size_t size, void* value,
                                                                   size_t* needed) {
    return platform_info(platform, name, size, value, needed);
}
