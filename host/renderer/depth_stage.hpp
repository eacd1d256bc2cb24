#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "frame.hpp"
#include "glpasses/depth_pass.hpp"
#include "glpasses/import_depth_pass.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/shared_table.hpp"
#include "surface_stage.hpp"

namespace lineatlas {

/// The pieces of the model that may be visible in a picture of this projection, as far as that can
/// be told without depth.
std::vector<gl::TriangleRange> pieces_in_view(SceneBuffers& scene,
                                              const glm::mat4& clip_from_world);

/// The depth of a frame: as a texture for GL passes, as a buffer for kernels, and as a pyramid.
///
/// In the raster form of a large model only what may be seen is drawn, in two steps that leave
/// exactly the depth that all triangles would: first the clusters that were seen in the last frame,
/// then, of the others, those that the depth so far does not hide. The compute form finds that out
/// by itself, and leaves the pyramid too.
class DepthStage {
  public:
    explicit DepthStage(const interop::Connection& connection);

    void set_scene(const SceneBuffers& scene);

    /// Draws the depth for GL passes only: into the texture.
    void draw_texture(Frame& frame);
    /// Draws what kernels look at, depth or the numbers of triangles, with the pyramid. GL's
    /// textures have it after fill_texture().
    void draw_for_compute(Frame& frame);
    /// Before GL passes look at textures: the numbers that kernels drew go there.
    void fill_texture(Frame& frame);
    /// Before the tiles of a frame.
    void begin_tiles() { triangles_drawn_ = 0; }
    /// Draws a part of a depth buffer that is too large to be held whole: what is within reach of
    /// the samples of a tile of the picture. Of the pyramid nothing is made.
    compute::DepthTile draw_tile(Frame& frame, const PictureTile& tile);
    /// What probes look at, by kernels.
    compute::DepthBuffer probed(Frame& frame);
    /// The same by GL's passes.
    gl::ProbeParams probed_by_gl(Frame& frame);
    SurfaceStage& surfaces() { return surfaces_; }

    /// Whether the frame's depth is drawn by kernels, if it draws any.
    bool wants_kernels(const Frame& frame) const;
    /// Of what they drew last: the texels in which something may be, and a word per cluster, 1 if
    /// it may be seen.
    const TexelRectangle& drawn_texels() const { return drawn_texels_; }
    compute::Buffer& seen() const { return *visible_; }

    /// Triangles that the last frame drew.
    std::uint32_t triangles_drawn() {
        find_drawn();
        return triangles_drawn_;
    }
    /// Which those were, as pieces of SceneBuffers::gl_triangles(); no other triangle can be seen.
    /// Of a frame whose method draws no depth (an item buffer) they say nothing.
    std::span<const gl::TriangleRange> drawn() {
        find_drawn();
        return ranges_;
    }
    GLuint texture() const { return imported_ ? import_->texture() : pass_.texture(); }
    glm::ivec2 size() const {
        return imported_ ? import_->size() : by_kernels_ ? size_ : pass_.size();
    }
    interop::SharedTable& tiles() { return tiles_; }

  private:
    /// Of the current frame.
    void choose_form(const Frame& frame);
    void prepare(const Frame& frame);
    /// Draws the texture by GL.
    void draw_raster(Frame& frame);
    /// Of depth that GL has drawn, all of `part`: which triangles it shows, for kernels.
    void copy_surfaces(Frame& frame, const TexelRectangle& part);
    /// The raster form of draw_tile().
    void draw_tile_by_gl(Frame& frame, glm::ivec2 whole, const TexelRectangle& part);
    /// Draws a part of a depth buffer of `whole` texels, of which `covered` is wanted.
    void draw_by_kernels(Frame& frame, glm::ivec2 whole, const TexelRectangle& part,
                         const TexelRectangle& covered);
    /// What kernels know of the numbers from their last frame, see DepthArgs::blank.
    compute::Buffer& blank_tiles();
    /// Draws all of it, that way.
    void draw_by_kernels(Frame& frame);
    /// What kernels have drawn, where nobody knows yet.
    void find_drawn();
    /// Adds the clusters that `selected` names to those that were drawn.
    void add_drawn(std::span<const Cluster> clusters, const std::vector<std::uint32_t>& selected);
    /// The texels that probes may reach, as whole tiles: what lies beside them is never read.
    TexelRectangle covered(const Frame& frame) const;
    /// Converts the program's own depth in place of drawing.
    void import_depth(Frame& frame);
    /// Copies what the model covers of the texture to the buffer, and builds the pyramid.
    void build_pyramid(Frame& frame);
    /// Draws the clusters that `selected` names.
    void draw_clusters(Frame& frame, const std::vector<std::uint32_t>& selected);
    /// Which clusters may be seen, judged by the pyramid.
    void cull(Frame& frame, std::vector<std::uint32_t>& visible);

    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    gl::DepthPass pass_;
    SurfaceStage surfaces_;
    std::optional<gl::ImportDepthPass> import_; ///< made when first used
    bool imported_ = false;                     ///< the current frame's depth is the program's own
    const bool kernels_are_faster_;
    bool by_kernels_ = false; ///< the current frame's form
    bool drawn_is_known_ = true;
    glm::ivec2 size_{0, 0};             ///< of what kernels drew
    TexelRectangle drawn_texels_;       ///< of that
    std::span<const Cluster> clusters_; ///< of the model
    interop::SharedTable depth_, tiles_;
    compute::Table visible_{device_, compute::table::visible_clusters}; ///< a word per cluster
    std::optional<glm::ivec2> blank_of_; ///< numbers of that size; none: GL has drawn since
    compute::Table blank_{device_, compute::table::blank_tiles};
    std::vector<std::uint32_t> seen_;       ///< per cluster: seen in the last frame
    std::vector<std::uint32_t> appeared_;   ///< per cluster: to be drawn in the second step
    std::vector<gl::TriangleRange> ranges_; ///< drawn so far in this frame
    std::uint32_t triangles_drawn_ = 0;
};

} // namespace lineatlas
