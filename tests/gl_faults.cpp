#include "gl_faults.hpp"

#include <epoxy/gl.h>

namespace lineatlas::test {
namespace {

bool error_pending = false;

bool fails() {
    ++gl_faults().creations;
    int& wanted = gl_faults().fail_creation;
    if (wanted == 0 || --wanted > 0) return false;
    error_pending = true;
    return true;
}

/// libepoxy calls GL through variables. Before its first call one holds a function that finds the
/// real one, if it still holds that very function, and calls whatever it holds then. So during a
/// call the variable has what it had without a hook.
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
        struct Unhooked {
            Function hook = *slot;
            Unhooked() { *slot = original; }
            ~Unhooked() { install(hook); }
        };
        const Unhooked now;
        return (*slot)(arguments...);
    }
    static inline Function original = nullptr;
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
        gl_faults().live += n;
        Hook<create>::call(n, names);
    });
    Hook<destroy>::install([](GLsizei n, const GLuint* names) {
        gl_faults().live -= n;
        Hook<destroy>::call(n, names);
    });
}

} // namespace

GlFaults& gl_faults() {
    static GlFaults faults;
    return faults;
}

void hook_gl() {
    may_fail_all<&epoxy_glNamedBufferStorage, &epoxy_glTextureStorage2D,
                 &epoxy_glNamedRenderbufferStorage, &epoxy_glCompileShader, &epoxy_glLinkProgram>();
    Hook<&epoxy_glMapNamedBufferRange>::install(
        [](GLuint buffer, GLintptr offset, GLsizeiptr length, GLbitfield access) -> void* {
            if (fails()) return nullptr;
            return Hook<&epoxy_glMapNamedBufferRange>::call(buffer, offset, length, access);
        });
    Hook<&epoxy_glGetError>::install([]() -> GLenum {
        if (error_pending) {
            error_pending = false;
            return GL_OUT_OF_MEMORY;
        }
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
        gl_faults().live += n;
        Hook<&epoxy_glCreateTextures>::call(target, n, names);
    });
    Hook<&epoxy_glDeleteTextures>::install([](GLsizei n, const GLuint* names) {
        gl_faults().live -= n;
        Hook<&epoxy_glDeleteTextures>::call(n, names);
    });
    Hook<&epoxy_glCreateProgram>::install([]() -> GLuint {
        ++gl_faults().live;
        return Hook<&epoxy_glCreateProgram>::call();
    });
    Hook<&epoxy_glDeleteProgram>::install([](GLuint program) {
        --gl_faults().live;
        Hook<&epoxy_glDeleteProgram>::call(program);
    });
    Hook<&epoxy_glCreateShader>::install([](GLenum type) -> GLuint {
        ++gl_faults().live;
        return Hook<&epoxy_glCreateShader>::call(type);
    });
    Hook<&epoxy_glDeleteShader>::install([](GLuint shader) {
        --gl_faults().live;
        Hook<&epoxy_glDeleteShader>::call(shader);
    });
}

} // namespace lineatlas::test
