#include "gl_faults.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

#include <epoxy/gl.h>

namespace lineatlas::test {
namespace {

GLenum pending_error = GL_NO_ERROR;

/// Several threads may count at the same time.
void count_live(long by) {
    std::atomic_ref{gl_faults().live} += by;
}

bool fails() {
    ++std::atomic_ref{gl_faults().creations};
    int& wanted = gl_faults().fail_creation;
    if (wanted == 0 || --wanted > 0) return false;
    pending_error = GL_OUT_OF_MEMORY;
    return true;
}

/// True if a GL with the limits of GlFaults has no memory for this.
bool is_beyond(GLsizei width, GLsizei height, long bytes) {
    const GlFaults& faults = gl_faults();
    const bool too_long = faults.largest_side != 0 && std::max(width, height) > faults.largest_side;
    const bool too_large = faults.largest_allocation != 0 && bytes > faults.largest_allocation;
    if (too_large) pending_error = GL_OUT_OF_MEMORY;
    if (too_long) pending_error = GL_INVALID_VALUE;
    return too_long || too_large;
}

long bytes_per_texel(GLenum format) {
    switch (format) {
    case GL_R8:
    case GL_R8UI:
        return 1;
    case GL_R16UI:
        return 2;
    case GL_RGBA16:
        return 8;
    case GL_RGB32F:
    case GL_RGB32UI:
        return 12;
    case GL_RGBA32F:
        return 16;
    default:
        return 4;
    }
}

/// libepoxy calls GL through variables. Before its first call a variable holds a resolver. If the
/// variable still holds the resolver when that runs, the resolver replaces it by the real function.
/// Then it calls the function in the variable. So during the first call the variable holds the same
/// as without a hook.
template <auto slot>
struct Hook;

template <class Result, class... Arguments, Result (**slot)(Arguments...)>
struct Hook<slot> {
    using Function = Result (*)(Arguments...);

    static void install(Function hook) {
        original = *slot;
        *slot = hook;
    }
    static Result call(Arguments... arguments) {
        if (is_found) return original(arguments...);
        struct Unhooked {
            std::scoped_lock<std::mutex> lock{mutex}; // threads may start at the same time
            Function hook = *slot;
            Unhooked() { *slot = original; }
            ~Unhooked() {
                install(hook);
                is_found = true;
            }
        };
        const Unhooked now;
        return (*slot)(arguments...);
    }
    static inline std::atomic<Function> original = nullptr;
    static inline std::atomic<bool> is_found = false;
    static inline std::mutex mutex;
};

template <auto slot>
void may_fail() {
    Hook<slot>::install([](auto... arguments) {
        if (!fails()) Hook<slot>::call(arguments...);
    });
}
template <auto... slots>
void may_fail_all() {
    (may_fail<slots>(), ...);
}

template <auto create, auto destroy>
void count() {
    Hook<create>::install([](GLsizei n, GLuint* names) {
        count_live(n);
        Hook<create>::call(n, names);
    });
    Hook<destroy>::install([](GLsizei n, const GLuint* names) {
        count_live(-n);
        Hook<destroy>::call(n, names);
    });
}

void hook_memory() {
    Hook<&epoxy_glNamedBufferStorage>::install(
        [](GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
            if (fails() || is_beyond(0, 0, size)) return;
            Hook<&epoxy_glNamedBufferStorage>::call(buffer, size, data, flags);
        });
    Hook<&epoxy_glNamedBufferData>::install(
        [](GLuint buffer, GLsizeiptr size, const void* data, GLenum use) {
            if (fails() || is_beyond(0, 0, size)) return;
            Hook<&epoxy_glNamedBufferData>::call(buffer, size, data, use);
        });
    Hook<&epoxy_glTextureStorage2D>::install(
        [](GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
            const long bytes = long{width} * height * bytes_per_texel(format);
            if (fails() || is_beyond(width, height, bytes)) return;
            Hook<&epoxy_glTextureStorage2D>::call(texture, levels, format, width, height);
        });
    Hook<&epoxy_glNamedRenderbufferStorage>::install(
        [](GLuint buffer, GLenum format, GLsizei width, GLsizei height) {
            const long bytes = long{width} * height * bytes_per_texel(format);
            if (fails() || is_beyond(width, height, bytes)) return;
            Hook<&epoxy_glNamedRenderbufferStorage>::call(buffer, format, width, height);
        });
}

void hook_limits() {
    Hook<&epoxy_glGetIntegerv>::install([](GLenum name, GLint* values) {
        Hook<&epoxy_glGetIntegerv>::call(name, values);
        const int side = gl_faults().largest_side, texels = gl_faults().largest_buffer_texture;
        if (name == GL_MAX_TEXTURE_BUFFER_SIZE && texels != 0) values[0] = texels;
        if (side == 0) return;
        if (name == GL_MAX_TEXTURE_SIZE || name == GL_MAX_RENDERBUFFER_SIZE) values[0] = side;
        if (name == GL_MAX_VIEWPORT_DIMS) values[0] = values[1] = side;
    });
    Hook<&epoxy_glViewportIndexedf>::install(
        [](GLuint index, GLfloat x, GLfloat y, GLfloat width, GLfloat height) {
            const auto side = static_cast<float>(gl_faults().largest_side);
            if (side != 0 && std::max(width, height) > side) ++gl_faults().beyond;
            Hook<&epoxy_glViewportIndexedf>::call(index, x, y, width, height);
        });
    Hook<&epoxy_glTextureBuffer>::install([](GLuint texture, GLenum format, GLuint buffer) {
        GLint64 bytes = 0;
        glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &bytes);
        const long most = gl_faults().largest_buffer_texture;
        if (most != 0 && bytes / bytes_per_texel(format) > most) ++gl_faults().beyond;
        Hook<&epoxy_glTextureBuffer>::call(texture, format, buffer);
    });
    Hook<&epoxy_glGetString>::install([](GLenum name) -> const GLubyte* {
        const std::string& renderer = gl_faults().renderer;
        if (name == GL_RENDERER && !renderer.empty()) {
            return reinterpret_cast<const GLubyte*>(renderer.c_str());
        }
        return Hook<&epoxy_glGetString>::call(name);
    });
}

} // namespace

GlFaults& gl_faults() {
    static GlFaults faults;
    return faults;
}

void hook_gl() {
    may_fail_all<&epoxy_glCompileShader, &epoxy_glLinkProgram>();
    hook_memory();
    hook_limits();
    Hook<&epoxy_glMapNamedBufferRange>::install(
        [](GLuint buffer, GLintptr offset, GLsizeiptr length, GLbitfield access) -> void* {
            if (fails()) return nullptr;
            return Hook<&epoxy_glMapNamedBufferRange>::call(buffer, offset, length, access);
        });
    Hook<&epoxy_glGetError>::install([]() -> GLenum {
        if (pending_error != GL_NO_ERROR) return std::exchange(pending_error, GL_NO_ERROR);
        return Hook<&epoxy_glGetError>::call();
    });
    Hook<&epoxy_glGetGraphicsResetStatus>::install([]() -> GLenum {
        return gl_faults().context_lost ? GL_INNOCENT_CONTEXT_RESET
                                        : Hook<&epoxy_glGetGraphicsResetStatus>::call();
    });
    count<&epoxy_glCreateBuffers, &epoxy_glDeleteBuffers>();
    count<&epoxy_glCreateFramebuffers, &epoxy_glDeleteFramebuffers>();
    count<&epoxy_glCreateRenderbuffers, &epoxy_glDeleteRenderbuffers>();
    count<&epoxy_glCreateVertexArrays, &epoxy_glDeleteVertexArrays>();
    count<&epoxy_glCreateSamplers, &epoxy_glDeleteSamplers>();
    Hook<&epoxy_glCreateTextures>::install([](GLenum target, GLsizei n, GLuint* names) {
        count_live(n);
        Hook<&epoxy_glCreateTextures>::call(target, n, names);
    });
    Hook<&epoxy_glDeleteTextures>::install([](GLsizei n, const GLuint* names) {
        count_live(-n);
        Hook<&epoxy_glDeleteTextures>::call(n, names);
    });
    Hook<&epoxy_glCreateProgram>::install([]() -> GLuint {
        count_live(1);
        return Hook<&epoxy_glCreateProgram>::call();
    });
    Hook<&epoxy_glDeleteProgram>::install([](GLuint program) {
        count_live(-1);
        Hook<&epoxy_glDeleteProgram>::call(program);
    });
    Hook<&epoxy_glCreateShader>::install([](GLenum type) -> GLuint {
        count_live(1);
        return Hook<&epoxy_glCreateShader>::call(type);
    });
    Hook<&epoxy_glDeleteShader>::install([](GLuint shader) {
        count_live(-1);
        Hook<&epoxy_glDeleteShader>::call(shader);
    });
}

} // namespace lineatlas::test
