#pragma once

#include <string>
#include <vector>

#include "glpasses/objects.hpp"
#include "glpasses/program.hpp"

namespace lineatlas::test {

/// One piece of GL state.
struct StateValue {
    std::string name;
    std::vector<double> values;
    bool operator==(const StateValue&) const = default;
};

/// All state of the current context that a program can set, as far as GL 4.5 tells; more than
/// gl::StateGuard knows of. In a compatibility context also what OpenGL 3.1 has removed, but for
/// matrices, lights and materials, which no call of the renderer comes near.
std::vector<StateValue> dump_state();

/// What two dumps differ in, as text; empty if in nothing.
std::string differences(const std::vector<StateValue>& before,
                        const std::vector<StateValue>& after);

/// Binds objects to everything that takes some, and sets all other state to odd values. They stay
/// while it lives.
class OddState {
  public:
    OddState();
    ~OddState();
    OddState(const OddState&) = delete;
    OddState& operator=(const OddState&) = delete;

  private:
    static void set_removed();
    void bind_buffers();
    void bind_textures();
    void set_raster();
    void set_pixels();

    gl::Program program_;
    gl::VertexArray vertex_array_;
    std::vector<gl::Buffer> buffers_;
    std::vector<GLuint> textures_;
    gl::Sampler sampler_;
    gl::Framebuffer draw_framebuffer_, read_framebuffer_;
    gl::Renderbuffer renderbuffer_;
    GLuint pipeline_ = 0, feedback_ = 0;
};

} // namespace lineatlas::test
