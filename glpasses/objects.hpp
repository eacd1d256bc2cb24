#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace lineatlas::gl {

/// While such an object lives, GL objects that are destroyed on this thread are not deleted in GL
/// but left to their context. It is for times when that context is not current: in another context
/// their names may belong to other objects.
class ForgetObjects {
  public:
    ForgetObjects() { ++depth(); }
    ~ForgetObjects() { --depth(); }
    ForgetObjects(const ForgetObjects&) = delete;
    ForgetObjects& operator=(const ForgetObjects&) = delete;

    static bool active() { return depth() > 0; }

  private:
    static int& depth() {
        thread_local int value = 0;
        return value;
    }
};

/// Owns one GL object; moved, never copied. `Traits` creates and deletes it.
template <class Traits>
class Object {
  public:
    Object() = default;
    explicit Object(GLuint id) : id_(id) {}
    ~Object() { reset(); }
    Object(Object&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        if (this != &other) {
            reset();
            id_ = std::exchange(other.id_, 0);
        }
        return *this;
    }
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    static Object create() { return Object{Traits::create()}; }
    GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

  private:
    void reset() {
        if (id_ != 0 && !ForgetObjects::active()) Traits::destroy(id_);
        id_ = 0;
    }

    GLuint id_ = 0;
};

struct BufferTraits {
    static GLuint create() {
        GLuint id = 0;
        glCreateBuffers(1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};

template <GLenum target>
struct TextureTraits {
    static GLuint create() {
        GLuint id = 0;
        glCreateTextures(target, 1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};

struct FramebufferTraits {
    static GLuint create() {
        GLuint id = 0;
        glCreateFramebuffers(1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};

struct RenderbufferTraits {
    static GLuint create() {
        GLuint id = 0;
        glCreateRenderbuffers(1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};

struct VertexArrayTraits {
    static GLuint create() {
        GLuint id = 0;
        glCreateVertexArrays(1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};

struct SamplerTraits {
    static GLuint create() {
        GLuint id = 0;
        glCreateSamplers(1, &id);
        return id;
    }
    static void destroy(GLuint id) { glDeleteSamplers(1, &id); }
};

using Buffer = Object<BufferTraits>;
using Texture2D = Object<TextureTraits<GL_TEXTURE_2D>>;
using TextureBuffer = Object<TextureTraits<GL_TEXTURE_BUFFER>>;
using Sampler = Object<SamplerTraits>;
using Framebuffer = Object<FramebufferTraits>;
using Renderbuffer = Object<RenderbufferTraits>;
using VertexArray = Object<VertexArrayTraits>;

} // namespace lineatlas::gl
