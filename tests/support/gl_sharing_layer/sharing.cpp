#include "sharing.hpp"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <span>

#include <dlfcn.h>
#include <unistd.h>

#include "gl_watch.hpp"
#include "imported_memory.hpp"
#include "state.hpp"

namespace lineatlas::test {
namespace {

void* current(const char* library, const char* function) {
    void* handle = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
    if (handle == nullptr) return nullptr;
    auto* get = reinterpret_cast<void* (*)()>(dlsym(handle, function));
    dlclose(handle);
    return get != nullptr ? get() : nullptr;
}

bool is_gl_property(cl_context_properties name) {
    return name >= CL_GL_CONTEXT_KHR && name <= CL_CGL_SHAREGROUP_KHR;
}

/// The value of a property, 0 if it is not there.
cl_context_properties value_of(const cl_context_properties* properties,
                               cl_context_properties name) {
    for (; properties != nullptr && *properties != 0; properties += 2) {
        if (*properties == name) return properties[1];
    }
    return 0;
}

bool has_gl_property(const cl_context_properties* properties) {
    for (; properties != nullptr && *properties != 0; properties += 2) {
        if (is_gl_property(*properties)) return true;
    }
    return false;
}

/// True if the context and the display are current and of the same window system.
bool names_current_context(const cl_context_properties* properties) {
    const auto is = [&](cl_context_properties name, const char* library, const char* function) {
        void* object = current(library, function);
        return object != nullptr &&
               value_of(properties, name) == reinterpret_cast<cl_context_properties>(object);
    };
    return (is(CL_GL_CONTEXT_KHR, "libEGL.so.1", "eglGetCurrentContext") &&
            is(CL_EGL_DISPLAY_KHR, "libEGL.so.1", "eglGetCurrentDisplay")) ||
           (is(CL_GL_CONTEXT_KHR, "libGLX.so.0", "glXGetCurrentContext") &&
            is(CL_GLX_DISPLAY_KHR, "libGLX.so.0", "glXGetCurrentDisplay"));
}

[[noreturn]] void hang() {
    for (;;) pause();
}

cl_context fail(cl_int* result, cl_int status) {
    if (result != nullptr) *result = status;
    return nullptr;
}

cl_context CL_API_CALL create_context(const cl_context_properties* properties, cl_uint count,
                                      const cl_device_id* devices,
                                      void(CL_CALLBACK* notify)(const char*, const void*, size_t,
                                                                void*),
                                      void* data, cl_int* result) {
    if (!has_gl_property(properties)) {
        return state().driver->clCreateContext(properties, count, devices, notify, data, result);
    }
    if (behaves("crash")) {
        std::signal(SIGSEGV, SIG_DFL); // PoCL has a handler that goes on
        std::raise(SIGSEGV);
    }
    if (behaves("hang")) hang();
    if (behaves("refuse")) return fail(result, CL_INVALID_OPERATION);
    if (!names_current_context(properties)) {
        return fail(result, CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR);
    }
    std::vector<cl_context_properties> others;
    for (; *properties != 0; properties += 2) {
        if (!is_gl_property(*properties)) others.insert(others.end(), properties, properties + 2);
    }
    others.push_back(0);
    ++state().counts.contexts;
    return state().driver->clCreateContext(others.data(), count, devices, notify, data, result);
}

cl_int CL_API_CALL get_gl_context_info(const cl_context_properties* properties, cl_gl_context_info,
                                       size_t size, void* value, size_t* size_needed) {
    if (!names_current_context(properties)) return CL_INVALID_GL_SHAREGROUP_REFERENCE_KHR;
    if (size_needed != nullptr) *size_needed = 0;
    if (behaves("other-device")) return CL_SUCCESS;
    if (size_needed != nullptr) *size_needed = sizeof(cl_device_id);
    if (value == nullptr) return CL_SUCCESS;
    if (size < sizeof(cl_device_id)) return CL_INVALID_VALUE;
    const auto platform =
        reinterpret_cast<cl_platform_id>(value_of(properties, CL_CONTEXT_PLATFORM));
    return state().driver->clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 1,
                                          static_cast<cl_device_id*>(value), nullptr);
}

/// Bytes that a driver with real sharing would never show, so that a missing acquire is noticed.
std::vector<std::byte> garbage(std::size_t bytes) {
    return std::vector<std::byte>(bytes, std::byte{0xCD});
}

cl_mem CL_API_CALL create_from_buffer(cl_context context, cl_mem_flags flags, cl_GLuint buffer,
                                      cl_int* result) {
    if (behaves("lie")) {
        if (result != nullptr) *result = CL_INVALID_GL_OBJECT;
        return nullptr;
    }
    const Unwatched own;
    GLint64 bytes = 0;
    glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &bytes);
    const auto size = static_cast<std::size_t>(bytes);
    std::vector<std::byte> content = garbage(size);
    cl_mem memory = state().driver->clCreateBuffer(context, flags | CL_MEM_COPY_HOST_PTR, size,
                                                   content.data(), result);
    if (memory != nullptr) {
        state().opened[memory] = {buffer, size, 0, 0, 0, 0, false, false, std::move(content)};
    }
    return memory;
}

cl_mem CL_API_CALL create_from_texture(cl_context context, cl_mem_flags flags, cl_GLenum,
                                       cl_GLint level, cl_GLuint texture, cl_int* result) {
    const Unwatched own;
    GLint format = 0, width = 0, height = 0;
    glGetTextureLevelParameteriv(texture, level, GL_TEXTURE_INTERNAL_FORMAT, &format);
    glGetTextureLevelParameteriv(texture, level, GL_TEXTURE_WIDTH, &width);
    glGetTextureLevelParameteriv(texture, level, GL_TEXTURE_HEIGHT, &height);
    if (format != GL_R32F || behaves("buffers-only")) {
        if (result != nullptr) *result = CL_INVALID_IMAGE_FORMAT_DESCRIPTOR;
        return nullptr;
    }
    const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
    const cl_image_format image_format{CL_R, CL_FLOAT};
    cl_image_desc description{};
    description.image_type = CL_MEM_OBJECT_IMAGE2D;
    description.image_width = w;
    description.image_height = h;
    std::vector<std::byte> content = garbage(w * h * sizeof(float));
    cl_mem memory = state().driver->clCreateImage(
        context, flags | CL_MEM_COPY_HOST_PTR, &image_format, &description, content.data(), result);
    if (memory == nullptr) ++state().counts.no_images;
    if (memory != nullptr) {
        state().opened[memory] = {texture, w * h * sizeof(float), w, h, GL_RED, GL_FLOAT, false,
                                  false,   std::move(content)};
    }
    return memory;
}

cl_mem CL_API_CALL create_with_properties(cl_context context, const cl_mem_properties* properties,
                                          cl_mem_flags flags, size_t size, void* host,
                                          cl_int* result) {
    const cl_icd_dispatch& driver = *state().driver;
    if (properties == nullptr || properties[0] != CL_EXTERNAL_MEMORY_HANDLE_OPAQUE_FD_KHR)
        return driver.clCreateBufferWithProperties(context, properties, flags, size, host, result);
    const Unwatched own;
    std::shared_ptr<std::byte> imported = import(static_cast<int>(properties[1]), size);
    if (imported == nullptr) {
        if (result != nullptr) *result = CL_INVALID_VALUE;
        return nullptr;
    }
    std::vector<std::byte> content = garbage(size);
    cl_mem memory =
        driver.clCreateBuffer(context, flags | CL_MEM_COPY_HOST_PTR, size, content.data(), result);
    if (memory != nullptr) {
        state().opened[memory] = {.gl = 0,
                                  .bytes = size,
                                  .width = 0,
                                  .height = 0,
                                  .format = 0,
                                  .type = 0,
                                  .acquired = false,
                                  .in_flight = false,
                                  .content = std::move(content),
                                  .imported = std::move(imported)};
    }
    return memory;
}

constexpr std::size_t origin[3] = {0, 0, 0};

void copy_to_compute(cl_command_queue queue, cl_mem memory, Opened& object) {
    const Unwatched own;
    const cl_icd_dispatch& driver = *state().driver;
    if (object.width == 0) {
        if (object.imported != nullptr)
            std::memcpy(object.content.data(), object.imported.get(), object.bytes);
        else
            glGetNamedBufferSubData(object.gl, 0, static_cast<GLsizeiptr>(object.bytes),
                                    object.content.data());
        driver.clEnqueueWriteBuffer(queue, memory, CL_TRUE, 0, object.bytes, object.content.data(),
                                    0, nullptr, nullptr);
        return;
    }
    glGetTextureImage(object.gl, 0, object.format, object.type, static_cast<GLsizei>(object.bytes),
                      object.content.data());
    const std::size_t region[3] = {object.width, object.height, 1};
    driver.clEnqueueWriteImage(queue, memory, CL_TRUE, origin, region, 0, 0, object.content.data(),
                               0, nullptr, nullptr);
}

void copy_from_compute(cl_command_queue queue, cl_mem memory, Opened& object) {
    const cl_icd_dispatch& driver = *state().driver;
    if (object.width == 0) {
        driver.clEnqueueReadBuffer(queue, memory, CL_TRUE, 0, object.bytes, object.content.data(),
                                   0, nullptr, nullptr);
        return;
    }
    const std::size_t region[3] = {object.width, object.height, 1};
    driver.clEnqueueReadImage(queue, memory, CL_TRUE, origin, region, 0, 0, object.content.data(),
                              0, nullptr, nullptr);
}

void copy_to_gl(const Opened& object) {
    const Unwatched own;
    if (object.imported != nullptr) {
        std::memcpy(object.imported.get(), object.content.data(), object.bytes);
    } else if (object.width == 0) {
        glNamedBufferSubData(object.gl, 0, static_cast<GLsizeiptr>(object.bytes),
                             object.content.data());
    } else {
        glTextureSubImage2D(object.gl, 0, 0, 0, static_cast<GLsizei>(object.width),
                            static_cast<GLsizei>(object.height), object.format, object.type,
                            object.content.data());
    }
}

cl_int CL_API_CALL acquire(cl_command_queue queue, cl_uint count, const cl_mem* objects,
                           cl_uint event_count, const cl_event* events, cl_event*) {
    const bool awaited =
        gl_is_fenced() && std::ranges::any_of(std::span{events, event_count}, [](cl_event event) {
            return state().fences.contains(event);
        });
    if (!gl_is_finished() && !awaited) violation("an acquire follows GL commands without glFinish");
    for (const cl_mem memory : std::span{objects, count}) {
        const auto found = state().opened.find(memory);
        if (found == state().opened.end()) return CL_INVALID_GL_OBJECT;
        if (found->second.acquired) violation("an object is acquired twice");
        found->second.acquired = true;
        ++state().counts.acquired;
        if (!behaves("stale")) copy_to_compute(queue, memory, found->second);
    }
    return CL_SUCCESS;
}

cl_int CL_API_CALL release(cl_command_queue queue, cl_uint count, const cl_mem* objects, cl_uint,
                           const cl_event*, cl_event*) {
    for (const cl_mem memory : std::span{objects, count}) {
        const auto found = state().opened.find(memory);
        if (found == state().opened.end()) return CL_INVALID_GL_OBJECT;
        if (!found->second.acquired) violation("an object is released that is not acquired");
        found->second.acquired = false;
        found->second.in_flight = true;
        ++state().counts.released;
        copy_from_compute(queue, memory, found->second);
    }
    if (behaves("events")) arrive_in_gl();
    return CL_SUCCESS;
}

cl_event CL_API_CALL create_event(cl_context context, cl_GLsync, cl_int* result) {
    cl_event event = state().driver->clCreateUserEvent(context, result);
    if (event == nullptr) return nullptr;
    const Unwatched own;
    glFinish();
    state().driver->clSetUserEventStatus(event, CL_COMPLETE);
    state().fences[event] = true;
    ++state().counts.fences;
    return event;
}

} // namespace

void add_sharing(cl_icd_dispatch& table) {
    table.clCreateContext = create_context;
    table.clGetGLContextInfoKHR = get_gl_context_info;
    table.clCreateFromGLBuffer = create_from_buffer;
    table.clCreateFromGLTexture = create_from_texture;
    table.clEnqueueAcquireGLObjects = acquire;
    table.clEnqueueReleaseGLObjects = release;
    table.clCreateEventFromGLsyncKHR = create_event;
    table.clCreateBufferWithProperties = create_with_properties;
}

namespace {

const std::map<std::string_view, void*>& functions() {
    static const std::map<std::string_view, void*> all{
        {"clGetGLContextInfoKHR", reinterpret_cast<void*>(get_gl_context_info)},
        {"clCreateEventFromGLsyncKHR", reinterpret_cast<void*>(create_event)},
        {"clEnqueueAcquireExternalMemObjectsKHR", reinterpret_cast<void*>(acquire)},
        {"clEnqueueReleaseExternalMemObjectsKHR", reinterpret_cast<void*>(release)}};
    return all;
}

} // namespace

bool is_sharing_function(std::string_view name) {
    return functions().contains(name);
}

void* sharing_function(std::string_view name) {
    const bool lacks = name == "clGetGLContextInfoKHR" && behaves("no-query");
    return lacks ? nullptr : functions().at(name);
}

void arrive_in_gl() {
    for (auto& [memory, object] : state().opened) {
        if (!object.in_flight) continue;
        copy_to_gl(object);
        object.in_flight = false;
    }
}

} // namespace lineatlas::test
