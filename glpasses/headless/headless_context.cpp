#include "glpasses/headless_context.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/driver_copy.hpp"
#include "core/memory_limit.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

std::string advice() {
    return "; install an OpenGL driver (on Debian and Ubuntu: apt install libegl1 libopengl0 "
           "libgl1-mesa-dri)" +
           memory_limit_remark();
}

/// Throws if a library is missing without which libepoxy would end the process.
void check_libraries() {
    const auto has = [](const char* name) { return dlopen(name, RTLD_LAZY) != nullptr; };
    if (!has("libEGL.so.1")) throw DeviceError("there is no libEGL.so.1" + advice());
    if (!has("libOpenGL.so.0") && !has("libGL.so.1"))
        throw DeviceError("there is no libOpenGL.so.0" + advice());
}

/// Displays that need no window system, best first.
EGLDisplay open_display() {
    std::array<EGLDisplay, 2> candidates{EGL_NO_DISPLAY, EGL_NO_DISPLAY};
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        candidates[0] =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    }
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
        EGLDeviceEXT device = nullptr;
        EGLint count = 0;
        if (eglQueryDevicesEXT(1, &device, &count) == EGL_TRUE && count > 0) {
            candidates[1] = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
        }
    }
    for (EGLDisplay display : candidates) {
        if (display == EGL_NO_DISPLAY) continue;
        if (eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
    }
    throw DeviceError("EGL offers no headless display" + advice());
}

/// A core context of a version; with major 0 the context that the driver makes by default.
/// EGL_NO_CONTEXT if the driver makes none.
EGLContext create_context(EGLDisplay display, int major, int minor) {
    const std::array<EGLint, 7> core{EGL_CONTEXT_MAJOR_VERSION,
                                     major,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     minor,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
    // No config: nothing is drawn to an EGL surface.
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                            major > 0 ? core.data() : nullptr);
}

/// The best version that a driver without 4.5 offers, for a message.
std::string best_version(EGLDisplay display) {
    for (const auto& [major, minor] :
         {std::pair{4, 4}, {4, 3}, {4, 2}, {4, 1}, {4, 0}, {3, 3}, {3, 2}, {0, 0}}) {
        EGLContext context = create_context(display, major, minor);
        if (context == EGL_NO_CONTEXT) continue;
        std::string version;
        if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
            const auto* text = reinterpret_cast<const char*>(glGetString(GL_VERSION));
            version = text != nullptr ? text : "";
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        eglDestroyContext(display, context);
        if (!version.empty()) return "its best is OpenGL " + version;
    }
    return "it offers no OpenGL at all";
}

/// Exit status of a copy of the process if there is no context. That is no fault of the driver.
constexpr int refused = 2;

/// Runs in a copy of the process: makes a context and draws a few pixels, with `room` bytes left
/// for a frame.
[[noreturn]] void try_driver(std::size_t room) {
    begin_driver_copy();
    take_memory(room);
    try {
        EGLDisplay display = open_display();
        eglBindAPI(EGL_OPENGL_API);
        EGLContext context = create_context(display, 4, 5);
        if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
            GLuint pixels = 0, framebuffer = 0;
            glCreateRenderbuffers(1, &pixels);
            glNamedRenderbufferStorage(pixels, GL_RGBA8, 16, 16);
            glCreateFramebuffers(1, &framebuffer);
            glNamedFramebufferRenderbuffer(framebuffer, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                           pixels);
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
            glClear(GL_COLOR_BUFFER_BIT);
            std::uint32_t pixel = 0;
            glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
        }
    } catch (const DeviceError&) {
        ::_exit(refused);
    }
    ::_exit(0);
}

/// The status of a copy that tries the driver, as waitpid() returns it; nothing if there is no
/// memory for a copy.
std::optional<int> status_of_copy(std::size_t room) {
    const pid_t copy = ::fork();
    if (copy < 0) return std::nullopt;
    if (copy == 0) try_driver(room);
    constexpr std::chrono::milliseconds step{5};
    constexpr std::chrono::seconds most{60};
    int status = 0;
    for (auto waited = step; ::waitpid(copy, &status, WNOHANG) == 0; waited += step) {
        if (waited > most) ::kill(copy, SIGKILL);
        std::this_thread::sleep_for(step);
    }
    return status;
}

/// Throws if the driver would end this process. Under a memory limit a driver may end a process
/// that asks for a context: Mesa 25 does, by SIGSEGV. So a copy of the process asks first. If it
/// gets no context, a second copy asks without room for a frame: with a little more memory Mesa
/// 26.1 ends a process that it had refused a context.
void mistrust_driver() {
    if (!memory_limit()) return;
    constexpr std::size_t room = std::size_t{64} << 20U;
    const auto is = [](const std::optional<int>& status, int code) {
        return !status || (WIFEXITED(*status) && WEXITSTATUS(*status) == code);
    };
    std::optional<int> status = status_of_copy(room);
    // Near its limit a driver fails by chance.
    for (int more = 3; more > 0 && status && is(status, 0); --more) status = status_of_copy(room);
    if (is(status, 0)) return;
    // This process will say so itself, unless memory was the reason.
    if (is(status, refused) && is(status_of_copy(0), refused)) return;
    const std::string how =
        WIFSIGNALED(*status) ? std::string{" ("} + strsignal(WTERMSIG(*status)) + ")" : "";
    throw DeviceError("the driver of OpenGL failed a trial" + how + ": it needs more memory" +
                      memory_limit_remark());
}

} // namespace

struct HeadlessContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~State() {
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    }
};

HeadlessContext::HeadlessContext() : state_(std::make_unique<State>()) {
    check_libraries();
    mistrust_driver();
    state_->display = open_display();
    eglBindAPI(EGL_OPENGL_API);
    state_->context = create_context(state_->display, 4, 5);
    if (state_->context == EGL_NO_CONTEXT) {
        throw DeviceError(
            "the driver offers no OpenGL 4.5 core context: " + best_version(state_->display) +
            "; a newer driver is needed" + memory_limit_remark());
    }
    make_current();
}

HeadlessContext::~HeadlessContext() {
    const EGLenum api = eglQueryAPI(); // whose current context EGL answers
    eglBindAPI(EGL_OPENGL_API);
    if (eglGetCurrentContext() == state_->context)
        eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglBindAPI(api);
}

void HeadlessContext::make_current() {
    eglBindAPI(EGL_OPENGL_API);
    if (eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context) !=
        EGL_TRUE) {
        throw DeviceError(
            "EGL can't make a context current on this thread; if the thread has one of GLX, as "
            "with a window of X, call from another thread");
    }
}

namespace gl {

CurrentContextKeeper::CurrentContextKeeper()
    : api_((check_libraries(), eglQueryAPI())), display_(eglGetCurrentDisplay()),
      context_(eglGetCurrentContext()), draw_(eglGetCurrentSurface(EGL_DRAW)),
      read_(eglGetCurrentSurface(EGL_READ)) {}

CurrentContextKeeper::~CurrentContextKeeper() {
    if (context_ != EGL_NO_CONTEXT) {
        eglMakeCurrent(display_, draw_, read_, context_);
    } else if (EGLDisplay display = eglGetCurrentDisplay(); display != EGL_NO_DISPLAY) {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglBindAPI(api_);
}

} // namespace gl
} // namespace lineatlas
