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

/// All state of the current context that a program can set and read in GL 4.5: more than
/// gl::StateGuard knows of. In a compatibility context also the state that OpenGL 3.1 has removed,
/// except matrices, lights and materials, because no call of the renderer touches these.
std::vector<StateValue> dump_state();

/// The differences between two dumps, as text; empty if there are none.
std::string differences(const std::vector<StateValue>& before,
                        const std::vector<StateValue>& after);

/// Binds objects to all binding points and sets all other state to odd values. The objects live as
/// long as it does.
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
