#include "quick_builds.hpp"

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace lineatlas::test {
namespace {

const cl_icd_dispatch* driver = nullptr;
const bool* wanted = nullptr;

using ContextKey = std::pair<std::vector<cl_context_properties>, std::vector<cl_device_id>>;
using Source = std::pair<cl_context, std::string>;

/// The objects in these tables are never released, so that no other object gets their addresses.
std::map<ContextKey, cl_context> contexts;
std::map<std::pair<Source, std::string>, cl_program> built;

std::map<cl_program, Source> sources;
std::map<cl_program, cl_program> built_instead; ///< the programs used in place of those that are
                                                ///< not built themselves

cl_context CL_API_CALL create_context(const cl_context_properties* properties, cl_uint count,
                                      const cl_device_id* devices,
                                      void(CL_CALLBACK* notify)(const char*, const void*, size_t,
                                                                void*),
                                      void* data, cl_int* status) {
    if (!*wanted) return driver->clCreateContext(properties, count, devices, notify, data, status);
    ContextKey key{{}, {devices, devices + count}};
    for (const cl_context_properties* p = properties; p != nullptr && *p != 0; p += 2)
        key.first.insert(key.first.end(), {p[0], p[1]});
    const auto known = contexts.find(key);
    cl_context context =
        known != contexts.end()
            ? known->second
            : driver->clCreateContext(properties, count, devices, notify, data, status);
    if (context == nullptr) return nullptr;
    contexts.emplace(key, context);
    const cl_int retained = driver->clRetainContext(context);
    if (status != nullptr) *status = retained;
    return context;
}

bool is_shared(cl_context context) {
    for (const auto& [key, known] : contexts)
        if (known == context) return true;
    return false;
}

/// Forgets an earlier program at the same address.
void forget(cl_program program) {
    sources.erase(program);
    built_instead.erase(program);
}

cl_program CL_API_CALL create_from_binary(cl_context context, cl_uint count,
                                          const cl_device_id* devices, const size_t* lengths,
                                          const unsigned char** binaries, cl_int* statuses,
                                          cl_int* status) {
    cl_program program = driver->clCreateProgramWithBinary(context, count, devices, lengths,
                                                           binaries, statuses, status);
    forget(program);
    return program;
}

cl_program CL_API_CALL create_program(cl_context context, cl_uint count, const char** texts,
                                      const size_t* lengths, cl_int* status) {
    cl_program program = driver->clCreateProgramWithSource(context, count, texts, lengths, status);
    forget(program);
    if (program == nullptr || !is_shared(context)) return program;
    std::string text;
    for (cl_uint i = 0; i < count; ++i) {
        const bool has_length = lengths != nullptr && lengths[i] != 0;
        text += has_length ? std::string(texts[i], lengths[i]) : std::string(texts[i]);
    }
    sources[program] = {context, text};
    return program;
}

cl_int CL_API_CALL build_program(cl_program program, cl_uint count, const cl_device_id* devices,
                                 const char* options, void(CL_CALLBACK* notify)(cl_program, void*),
                                 void* data) {
    const auto build = [&] {
        return driver->clBuildProgram(program, count, devices, options, notify, data);
    };
    const auto source = sources.find(program);
    if (source == sources.end()) return build();
    const std::pair key{source->second, std::string{options != nullptr ? options : ""}};
    if (const auto known = built.find(key); known != built.end()) {
        built_instead[program] = known->second;
        return CL_SUCCESS;
    }
    const cl_int status = build();
    if (status != CL_SUCCESS) return status;
    built[key] = program;
    return driver->clRetainProgram(program);
}

cl_program with_kernels_of(cl_program program) {
    const auto other = built_instead.find(program);
    return other != built_instead.end() ? other->second : program;
}

cl_kernel CL_API_CALL create_kernel(cl_program program, const char* name, cl_int* status) {
    return driver->clCreateKernel(with_kernels_of(program), name, status);
}

cl_int CL_API_CALL program_info(cl_program program, cl_program_info name, size_t size, void* value,
                                size_t* size_needed) {
    return driver->clGetProgramInfo(with_kernels_of(program), name, size, value, size_needed);
}

cl_int CL_API_CALL build_info(cl_program program, cl_device_id device, cl_program_build_info name,
                              size_t size, void* value, size_t* size_needed) {
    return driver->clGetProgramBuildInfo(with_kernels_of(program), device, name, size, value,
                                         size_needed);
}

} // namespace

const cl_icd_dispatch& build_once(const cl_icd_dispatch& below, const bool& when) {
    static cl_icd_dispatch table;
    driver = &below;
    wanted = &when;
    table = below;
    table.clCreateContext = create_context;
    table.clCreateProgramWithSource = create_program;
    table.clCreateProgramWithBinary = create_from_binary;
    table.clBuildProgram = build_program;
    table.clCreateKernel = create_kernel;
    table.clGetProgramInfo = program_info;
    table.clGetProgramBuildInfo = build_info;
    return table;
}

} // namespace lineatlas::test
