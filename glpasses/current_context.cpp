#include "current_context.hpp"

#include <string>
#include <string_view>

#include <dlfcn.h>
#include <epoxy/gl.h>

#include "lineatlas/error.hpp"

namespace lineatlas::gl {
namespace {

using System = CurrentContext::System;

/// A parameterless function of a window-system library, if this process has that library loaded
/// already. Loading it here would be wrong: a context can only be current through a library that is
/// in use.
void* call(const char* library, const char* name) {
    void* handle = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
    if (handle == nullptr) return nullptr;
    auto* function = reinterpret_cast<void* (*)()>(dlsym(handle, name));
    dlclose(handle); // gives back this reference, not the library
    return function != nullptr ? function() : nullptr;
}

} // namespace

CurrentContext current_context() {
    if (void* context = call("libEGL.so.1", "eglGetCurrentContext")) {
        return {System::egl, context, call("libEGL.so.1", "eglGetCurrentDisplay")};
    }
    for (const char* library : {"libGLX.so.0", "libGL.so.1"}) {
        if (void* context = call(library, "glXGetCurrentContext")) {
            return {System::glx, context, call(library, "glXGetCurrentDisplay")};
        }
    }
    return {};
}

CurrentContext require_context() {
    const CurrentContext current = current_context();
    if (current.context == nullptr) {
        throw UsageError("renderer: no OpenGL context is current on this thread; make one current "
                         "first");
    }
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    if (text == nullptr) { // between glBegin() and glEnd(), for one, where nothing can be asked
        throw UsageError("renderer: the current OpenGL context does not answer; call outside of "
                         "glBegin() and glEnd()");
    }
    const std::string_view version = text;
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    const bool embedded = version.starts_with("OpenGL ES");
    if (embedded || major * 10 + minor < 45) {
        throw DeviceError("renderer: the current context is OpenGL " + std::string{version} +
                          "; 4.5 (core) is needed: ask for it when the context is made");
    }
    return current;
}

bool is_software() {
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    if (name == nullptr) return false;
    const std::string_view renderer = name;
    return renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos;
}

void require_alive() {
    const GLenum status = glGetGraphicsResetStatus();
    if (status == GL_NO_ERROR) return;
    const char* cause = status == GL_GUILTY_CONTEXT_RESET     ? "this program's commands"
                        : status == GL_INNOCENT_CONTEXT_RESET ? "another program's commands"
                                                              : "an unknown cause";
    throw DeviceError(std::string{"the OpenGL context was lost: the driver was reset by "} + cause +
                      "; make a new context and a new renderer");
}

} // namespace lineatlas::gl
