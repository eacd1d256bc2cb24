#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "compute/stages/stages.hpp"
#include "core/assembly_state.hpp"
#include "core/line_pens.hpp"
#include "glpasses/depth_pass.hpp"
#include "glpasses/fill_pass.hpp"
#include "glpasses/interop/shared_table.hpp"
#include "glpasses/line_pass.hpp"
#include "glpasses/objects.hpp"
#include "glpasses/spine_pass.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"
#include "visibility/exact_intervals.hpp"
#include "visibility/moving_tables.hpp"

namespace lineatlas {

/// A line set on the device: tables that are uploaded once and read in every frame, by kernels and
/// by GL passes.
///
/// If a device's buffers are too small for the tables of all segments, the tables are in chunks of
/// whole paths. One chunk is the current one: table() is only that chunk's.
class SceneBuffers {
  public:
    /// Throws DeviceError when memory runs out, or where there is more than GL can count. `parts`:
    /// the assembly that the lines are of, if its parts come and go.
    SceneBuffers(compute::Stages& stages, interop::Sharing& sharing, const LineSet& lines,
                 const AssemblyState* parts = nullptr);

    /// Takes over changes of the assembly; they count once move() is called. Returns false, and
    /// changes nothing, if that needs tables of another size or the tables are of another scene.
    bool update_parts(const AssemblyState& parts);

    /// See Renderer. The changes count once move() is called.
    void set_transforms(std::span<const glm::mat4> world_from_object);
    void set_positions(std::uint32_t first, std::span<const glm::vec3> positions);
    void set_hidden(std::span<const std::uint32_t> objects);
    bool has_moved() const { return moved_; }
    void move();
    const SceneMotion& motion() const { return motion_; }
    /// Empties the `ranges` of `temporal` for segments of objects that have moved by more than
    /// `most_pixels` since they stood at `transforms_from`.
    void forget_jumps(std::span<const glm::mat4> transforms_from, const Camera& camera,
                      float most_pixels, compute::Buffer& ranges);

    /// Current places of vertices, for kernels and for GL, which read them at the same time.
    struct Moving : MovingTables {
        interop::SharedTable drawn; ///< the vertices, for GL
    };
    /// The tables that compute stages read.
    struct Tables : LineTables {
        std::unique_ptr<compute::Buffer> clusters;
        std::unique_ptr<compute::Buffer> cluster_triangles{}; ///< from the first set_positions() on
        std::unique_ptr<Moving> moving{};                     ///< of a model that moves; else null
        /// The tables that the kernels of `depth` draw from; null until first asked for.
        std::unique_ptr<compute::Buffer> meshlets{}, vertex_list{}, corners{};
        /// The tables that probes read if they know surfaces; null until first asked for.
        std::unique_ptr<compute::Buffer> numbers{}, patches{};
        /// What the kernels of `fill` read; null until first asked for.
        std::unique_ptr<compute::Buffer> colors{}, smooth_corners{};
    };
    const Tables& tables() const { return tables_; }
    /// Copies the tables to another device, from the memory of this one.
    Tables copy_tables(compute::Stages& stages, interop::Sharing& sharing);
    /// Uses these tables from the call on.
    void use(compute::Stages& stages, interop::Sharing& sharing, Tables tables) noexcept {
        stages_ = &stages;
        sharing_ = &sharing;
        tables_ = std::move(tables);
        normals_.forget();
        gl_normals_ = {}; // versions are counted anew
        select(0);
        moved_ = tables_.moving != nullptr;
    }

    /// The segments of the current chunk in the order of the line set.
    compute::SegmentTable candidate_table() const { return placed().chunk(chunk_); }
    /// The segments of the current chunk in the order that was set last since select(): that of the
    /// current frame.
    compute::SegmentTable table() const { return ordered_ ? *ordered_ : candidate_table(); }
    void set_order(const compute::SegmentTable& ordered) { ordered_.emplace(ordered); }
    /// The lines where they stand, for picking and other reads beside a frame.
    PlacedLines placed() const {
        return {tables_, tables_.moving ? tables_.moving->vertices() : *tables_.vertices,
                motion_.vertex_count(), triangle_count_,
                tables_.moving ? tables_.moving->corners() : nullptr};
    }
    std::size_t chunk_count() const { return tables_.chunks.size(); }
    void select(std::size_t chunk) {
        chunk_ = chunk;
        ordered_.reset();
    }
    /// The first segment of the current chunk in the whole segment table.
    std::uint32_t first_segment() const { return chunk().range.first; }
    /// The triangles for drawing, in an order of their own.
    gl::TriangleBuffers gl_triangles();
    /// In the order of gl_triangles().
    const gl::TriangleColors& gl_colors() const { return colors_; }
    /// The colours for kernels (FillArgs::colors); null for a model without colours.
    compute::Buffer* colors();
    /// Triangles that contours may run through, for fills in the light; none without contours.
    compute::SmoothTriangles smooth_triangles();
    /// The same for GL.
    std::optional<gl::SmoothTriangles> gl_smooth_triangles();
    gl::SegmentBuffers gl_segments();
    /// The fixed lines among `kinds` as pairs of vertices.
    gl::LineBuffers gl_lines(LineKindMask kinds);
    /// Pieces of gl_triangles(); none for a small model, which is not worth cutting up. Only the
    /// device has boxes that are up to date, see boxes().
    std::span<const Cluster> clusters() const {
        return is_cut_up() ? std::span<const Cluster>{clusters_} : std::span<const Cluster>{};
    }
    /// Pieces of gl_triangles(), for a model of any size.
    std::span<const Cluster> all_clusters() const { return clusters_; }
    /// all_clusters() as the kernels of `depth` draw them.
    compute::MeshletTables meshlets();
    /// What probes know of triangles as surfaces.
    struct Surfaces {
        compute::Buffer& numbers; ///< ProjectClipArgs::numbers
        compute::Buffer& patches; ///< SurfaceTables::patches
    };
    Surfaces surfaces();
    /// The surfaces for GL: a uint32 per triangle in each buffer.
    struct GlSurfaces {
        GLuint numbers, patches;
    };
    GlSurfaces gl_surfaces();
    /// clusters() with boxes that are up to date. Waits for the device after a motion.
    std::span<const Cluster> boxes();
    compute::Buffer& cluster_buffer() const {
        return tables_.moving ? tables_.moving->clusters() : *tables_.clusters;
    }
    /// The classes by which rules for pens tell lines apart.
    const LineClasses& classes() const { return classes_; }
    const Bounds& bounds() const { return motion_.bounds(); }
    /// The diagonal of the model as it was made. Motion does not change it.
    float diagonal() const { return diagonal_; }
    float contact() const { return contact_; } ///< contact_of() the model
    std::uint32_t triangle_count() const { return triangle_count_; }
    std::uint32_t segment_count() const { return tables_.segment_count(); }
    std::uint32_t most_elements() const {
        return std::max({motion_.vertex_count(), triangle_count_, segment_count()});
    }

  private:
    // For parts, in host/renderer/scene_parts.cpp.
    bool has_rooms_of(const AssemblyState& parts) const;
    void follow(const AssemblyState& parts);
    void update_part(const AssemblyState& parts, const AssemblyState::Change& change);
    void upload_part_lines(const AssemblyState& parts, const PartRooms& rooms);
    void upload_part_ends(const PartRooms& rooms, const LineSet& part);
    void upload_part_contours(const Contours& all, const PartRooms& rooms, const LineSet& part);
    void upload_part_triangles(std::uint32_t object, const PartRooms& rooms, const LineSet& part);
    void upload_part_surfaces(const PartRooms& rooms, const LineSet& part);

    bool is_cut_up() const;
    /// Where they stand now; none of a model without contours.
    std::optional<compute::ContourTables> contours_now() const {
        return tables_.contour_chunk().contours(tables_.moving ? tables_.moving->corners()
                                                               : nullptr);
    }
    /// Per triangle of gl_triangles() its corners among those of contours, or LA_NO_SURFACE.
    std::vector<glm::uvec3> smooth_corners(const compute::ContourTables& contours) const;
    /// Values of triangles in the order of gl_triangles().
    std::vector<glm::uvec3> in_order(const std::vector<glm::uvec3>& of_triangles) const;
    std::vector<glm::uvec3> ordered_triangles(); ///< the triangles themselves
    void upload_colors(const LineSet& lines);
    /// Runs an action that changes `motion_`, with tables of motion made before.
    template <class Change>
    void change(const Change& change);
    void start_moving(std::unique_ptr<Moving> made);
    std::unique_ptr<Moving> make_moving(compute::Stages& stages, interop::Sharing& sharing) const;
    GLuint gl_vertices();

    compute::Device& device() const { return stages_->device(); }
    const LineTables::Chunk& chunk() const { return tables_.chunks[chunk_]; }

    compute::Stages* stages_;
    interop::Sharing* sharing_;
    Tables tables_;
    std::size_t chunk_ = 0; ///< the current one
    std::optional<compute::SegmentTable> ordered_;
    SceneMotion motion_;
    LineClasses classes_;
    float diagonal_, contact_;
    bool moved_ = false; ///< since the last move()
    /// The state of the assembly that the tables hold.
    struct Followed {
        std::uint64_t layout;
        std::size_t changes;     ///< number of changes that were taken over
        std::size_t object_room; ///< see AssemblyState
    };
    std::optional<Followed> followed_;
    std::vector<Cluster> clusters_;
    bool boxes_are_old_ = false; ///< in `clusters_`
    ContourNormals normals_;     ///< of contours
    std::vector<std::uint32_t> cluster_objects_;
    std::vector<std::uint32_t> triangle_order_; ///< place of each of gl_triangles() among the line
                                                ///< set's triangles
    gl::Buffer gl_vertices_, gl_indices_;     ///< made when first asked for: kernels have their own
    gl::Buffer gl_color_indices_, gl_colors_; ///< empty for a model without colours
    gl::TriangleColors colors_;
    gl::Buffer gl_smooth_corners_, gl_normals_; ///< made when first asked for
    std::uint64_t normals_version_ = 0;         ///< LineTables::version of gl_normals_
    // What only the methods besides the atlas need; made when first asked for.
    gl::Buffer gl_segments_, gl_table_triangles_, gl_lines_;
    gl::Buffer gl_numbers_, gl_patches_; ///< made when first asked for
    LineKindMask line_kinds_ = 0;        ///< the kinds that `gl_lines_` holds
    std::uint32_t line_count_ = 0;
    std::uint32_t triangle_count_;
};

} // namespace lineatlas
