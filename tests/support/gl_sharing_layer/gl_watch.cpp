#include "gl_watch.hpp"

#include "state.hpp"

namespace lineatlas::test {
namespace {

int unwatched = 0;
bool finished = false;
bool fenced = false;

void command() {
    finished = fenced = false;
    for (const auto& [object, opened] : state().opened) {
        if (opened.in_flight) return violation("a GL command follows a release without clFinish");
    }
}
void finish() {
    finished = true;
    ++state().counts.gl_waits;
}
void fence() {
    fenced = true;
}

/// libepoxy calls GL through variables. Before its first call a variable holds a resolver. If the
/// variable still holds the resolver when that runs, the resolver replaces it by the real function.
/// Then it calls the function in the variable. So during a call the variable holds the same as
/// without a watcher.
template <auto slot, void (*note)()>
struct Watcher;

template <class Result, class... Arguments, Result (**slot)(Arguments...), void (*note)()>
struct Watcher<slot, note> {
    static void install() {
        original = *slot;
        *slot = watched;
    }

  private:
    struct Uninstalled {
        Uninstalled() { *slot = original; }
        ~Uninstalled() { install(); }
    };

    static Result watched(Arguments... arguments) {
        if (unwatched == 0) note();
        const Uninstalled now;
        return (*slot)(arguments...);
    }

    static inline Result (*original)(Arguments...) = nullptr;
};

template <auto... slots>
void watch_commands() {
    (Watcher<slots, command>::install(), ...);
}

} // namespace

void watch_gl() {
    watch_commands<&epoxy_glDrawArrays, &epoxy_glDrawArraysIndirect, &epoxy_glDrawElements,
                   &epoxy_glDrawArraysInstanced, &epoxy_glMultiDrawElementsIndirect,
                   &epoxy_glMultiDrawElements, &epoxy_glClearBufferfv, &epoxy_glClearBufferuiv,
                   &epoxy_glCopyImageSubData, &epoxy_glClearNamedBufferData,
                   &epoxy_glClearNamedBufferSubData, &epoxy_glClearNamedFramebufferfv,
                   &epoxy_glClearTexImage, &epoxy_glCopyNamedBufferSubData,
                   &epoxy_glNamedBufferSubData, &epoxy_glGetNamedBufferSubData,
                   &epoxy_glGetTextureImage, &epoxy_glGetTextureSubImage, &epoxy_glReadPixels,
                   &epoxy_glBlitNamedFramebuffer, &epoxy_glTextureSubImage2D>();
    Watcher<&epoxy_glFinish, finish>::install();
    Watcher<&epoxy_glFenceSync, fence>::install();
}

bool gl_is_finished() {
    return finished;
}
bool gl_is_fenced() {
    return fenced;
}

Unwatched::Unwatched() {
    ++unwatched;
}
Unwatched::~Unwatched() {
    --unwatched;
}

} // namespace lineatlas::test
