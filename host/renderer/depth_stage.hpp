#pragma once

#include <memory>
#include <span>
#include <vector>

#include "frame.hpp"
#include "glpasses/depth_pass.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/handover.hpp"

namespace lineatlas {

/// The depth of a frame: as a texture for GL passes, as a buffer for kernels, and as a pyramid.
///
/// Of a large model only what may be seen is drawn, in two steps that leave exactly the depth that
/// all triangles would: first the clusters that were seen in the last frame, then, of the others,
/// those that the depth so far does not hide.
class DepthStage {
  public:
    explicit DepthStage(const interop::Connection& connection);

    void set_scene(const SceneBuffers& scene);

    /// Draws the texture only.
    void draw_texture(Frame& frame);
    /// Draws the texture and hands depth and pyramid to compute.
    void draw_for_compute(Frame& frame);
    /// Takes depth and pyramid back from compute: at the end of the frame, or before GL reads the
    /// pyramid.
    void take_back();

    /// Triangles that the last frame drew.
    std::uint32_t triangles_drawn() const { return triangles_drawn_; }
    /// Which those were, as pieces of SceneBuffers::gl_triangles(); no other triangle can be seen.
    /// Of a frame whose method draws no depth (an item buffer) they say nothing.
    std::span<const gl::TriangleRange> drawn() const { return ranges_; }
    const gl::DepthPass& pass() const { return pass_; }
    compute::Buffer& buffer() const { return depth_->compute(); }
    interop::SharedBuffer& tiles() const { return *tiles_; }

  private:
    void prepare(const Frame& frame);
    /// Copies what the model covers of the texture to the buffer, passes it on and builds the
    /// pyramid.
    void build_pyramid(Frame& frame);
    /// Draws the clusters that `selected` names.
    void draw_clusters(Frame& frame, const std::vector<std::uint8_t>& selected);
    /// Which clusters may be seen, judged by the pyramid.
    void cull(Frame& frame, std::vector<std::uint8_t>& visible);

    compute::Backend& backend_;
    interop::SharingMode mode_;
    interop::Handover handover_;
    gl::DepthPass pass_;
    std::unique_ptr<interop::SharedBuffer> depth_, tiles_;
    std::unique_ptr<compute::Buffer> visible_;
    std::vector<std::uint8_t> seen_;        ///< per cluster: seen in the last frame
    std::vector<std::uint8_t> appeared_;    ///< per cluster: to be drawn in the second step
    std::vector<gl::TriangleRange> ranges_; ///< drawn so far in this frame
    std::uint32_t triangles_drawn_ = 0;
};

} // namespace lineatlas
