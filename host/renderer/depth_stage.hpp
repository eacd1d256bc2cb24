#pragma once

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
/// The raster form draws of a large model only the clusters that may be seen, in two steps: first
/// those that were seen in the last frame, then those of the others that the depth so far does not
/// hide. The depth is exactly that of all triangles. The compute form finds the clusters by itself,
/// and writes the pyramid too.
class DepthStage {
  public:
    explicit DepthStage(const interop::Connection& connection);
    ~DepthStage();
    DepthStage(const DepthStage&) = delete;
    DepthStage& operator=(const DepthStage&) = delete;

    void set_scene(const SceneBuffers& scene);

    /// Draws the depth into the texture, for GL passes only.
    void draw_texture(Frame& frame);
    /// Draws depth or the numbers of triangles, whichever kernels look at, with the pyramid. GL's
    /// textures hold the result only after fill_texture().
    void draw_for_compute(Frame& frame);
    /// Copies the numbers that kernels drew to GL's texture. Call it before GL passes look at
    /// textures.
    void fill_texture(Frame& frame);
    /// Call before the tiles of a frame.
    void begin_tiles() { triangles_drawn_ = 0; }
    /// Draws the part of a depth buffer that samples in a tile of the picture can reach, for
    /// pictures whose whole depth buffer would be too large. Makes no pyramid.
    compute::DepthTile draw_tile(Frame& frame, const PictureTile& tile);
    /// The depth buffer that probes of kernels look at.
    compute::DepthBuffer probed(Frame& frame);
    /// The depth buffer that probes of GL passes look at.
    gl::ProbeParams probed_by_gl(Frame& frame);
    SurfaceStage& surfaces() { return surfaces_; }

    /// Whether the frame's depth is drawn by kernels, if it draws any.
    bool wants_kernels(const Frame& frame) const;
    /// The texels that kernels may have drawn to, and a word per cluster, 1 if the cluster may be
    /// seen. Both are of the last drawing by kernels.
    const TexelRectangle& drawn_texels() const { return drawn_texels_; }
    compute::Buffer& seen() const { return *visible_; }

    /// Says that the host has waited for all that the device got so far. Then the two functions
    /// below need no wait of their own.
    void device_is_done() {
        if (copy_of_seen_ == Copy::begun) copy_of_seen_ = Copy::done;
    }
    /// Triangles that the last frame drew.
    std::uint32_t triangles_drawn() {
        find_drawn();
        return triangles_drawn_;
    }
    /// The triangles that the last frame drew, as pieces of SceneBuffers::gl_triangles(). No other
    /// triangle can be seen. Means nothing after a frame without depth, such as that of an item
    /// buffer.
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
    /// Chooses the form of the current frame.
    void choose_form(const Frame& frame);
    void prepare(const Frame& frame);
    /// Draws the texture by GL.
    void draw_raster(Frame& frame);
    /// Copies the numbers of the triangles that GL has drawn in `part`, for kernels.
    void copy_surfaces(Frame& frame, const TexelRectangle& part);
    /// The raster form of draw_tile().
    void draw_tile_by_gl(Frame& frame, glm::ivec2 whole, const TexelRectangle& part);
    /// Draws `part` of a depth buffer of `whole` texels. Only `covered` is wanted of it.
    void draw_by_kernels(Frame& frame, glm::ivec2 whole, const TexelRectangle& part,
                         const TexelRectangle& covered);
    /// The tiles that kernels left blank in their last frame, see DepthArgs::blank.
    compute::Buffer& blank_tiles();
    /// Draws the whole depth buffer by kernels.
    void draw_by_kernels(Frame& frame);
    /// Takes over which clusters kernels have drawn, unless that is known.
    void find_drawn();
    /// Adds the clusters that `selected` names to those that were drawn.
    void add_drawn(std::span<const Cluster> clusters, const std::vector<std::uint32_t>& selected);
    /// The texels that probes may reach, as whole tiles. Texels beside them are never read.
    TexelRectangle covered(const Frame& frame) const;
    /// Converts the program's own depth in place of drawing.
    void import_depth(Frame& frame);
    /// Copies the part of the texture that the model covers to the buffer, and builds the pyramid.
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
    bool by_kernels_ = false;                   ///< the current frame's form
    bool drawn_is_known_ = true;
    enum class Copy { none, begun, done };
    Copy copy_of_seen_ = Copy::none;    ///< to appeared_, of what kernels have drawn
    glm::ivec2 size_{0, 0};             ///< of the depth buffer that kernels drew
    TexelRectangle drawn_texels_;       ///< of that
    std::span<const Cluster> clusters_; ///< of the model
    interop::SharedTable depth_, tiles_;
    compute::Table visible_{device_, compute::table::visible_clusters}; ///< a word per cluster
    std::optional<glm::ivec2> blank_of_; ///< size of the numbers that blank tiles are of; none: GL
                                         ///< has drawn since
    compute::Table blank_{device_, compute::table::blank_tiles};
    std::vector<std::uint32_t> seen_;       ///< per cluster: seen in the last frame
    std::vector<std::uint32_t> appeared_;   ///< per cluster: to be drawn in the second step
    std::vector<gl::TriangleRange> ranges_; ///< drawn so far in this frame
    std::uint32_t triangles_drawn_ = 0;
};

} // namespace lineatlas
