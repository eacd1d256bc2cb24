#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/device_options.hpp"
#include "lineatlas/export.hpp"
#include "lineatlas/image.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/pick.hpp"
#include "lineatlas/profile.hpp"
#include "lineatlas/progress.hpp"
#include "lineatlas/style.hpp"

/// @file
/// Drawing lines in OpenGL, over the program's own picture and by its own depth if it likes.
/// @code{.cpp}
/// renderer.set_lines(lines);
/// options.style.pen.width = 3;
/// options.own_depth = DepthTexture{.texture = depth_texture};
/// renderer.draw({view, projection, size}, options, bound_framebuffer); // each frame
/// @endcode

namespace lineatlas {

class Assembly;
namespace compute {
struct TableMemory; // lineatlas/compute_device.hpp
}

/// How visibility is computed and strokes are drawn (Table 1).
enum class Method {
    atlas, ///< the segment atlas (§4)
    /// Lines cut against the faces before them: exact, with no depth buffer and no samples (beyond
    /// the paper)
    exact,
    spine,       ///< the spine test in the fragment shader (§3)
    item_buffer, ///< an item buffer (Northrup & Markosian 2000, Cole & Finkelstein 2008)
    opengl,      ///< depth-tested GL lines, the yardstick; no pens, no silhouettes
};

/// Where a stage that has two forms runs.
enum class StageForm {
    automatic, ///< where the stage and what must be copied for it take less time (docs/devices.md)
    raster,    ///< in a pass of GL
    compute,   ///< in kernels
};

/// The forms of stages, for measurements and for finding faults. Pictures of the two other forms
/// differ only by rounding.
struct StageForms {
    /// Samples, as proxy lines into a texture (§4.2) or by a kernel over samples.
    StageForm atlas = StageForm::automatic;
    /// Depth (§3.2), and a fill by that depth. The two forms cover the same texels, except a few in
    /// 100,000. For the methods atlas and spine, and for the fill of exact.
    StageForm depth = StageForm::automatic;
    /// Strokes (§4.4). Kernels draw pictures of 8 bits with marks that are even across the stroke
    /// (solid, dashed), butt and round caps, and joins without bevels, but no profiles and no
    /// focus. GL draws all of a frame that asks for anything else.
    StageForm strokes = StageForm::automatic;
};

/// What a frame keeps for `Renderer::read_intervals`.
enum class KeptIntervals {
    none,    ///< nothing
    visible, ///< visible pieces of lines
    all,     ///< hidden ones too: together the whole of every line inside the picture
};

/// A depth buffer that the program has drawn itself, with the camera of the frame.
///
/// A 2D texture with any format that has depth, fixed point or floating; not multisampled (resolve
/// it first: glBlitFramebuffer). It must be drawn without polygon offset, which would move the
/// surfaces that lines lie on. The texture is only read, and may be an attachment of the
/// framebuffer that is drawn to.
struct DepthTexture {
    std::uint32_t texture = 0; ///< its name in GL
    glm::ivec2 origin{0, 0};   ///< texel at the lower left corner of the viewport
    int scale = 1;             ///< texels per pixel of the viewport and axis: 1 to 4
    glm::vec2 range{0, 1};     ///< what glDepthRange() was when it was drawn
};

/// How a frame is drawn.
struct FrameOptions {
    Method method = Method::atlas; ///< how visibility is computed
    /// Depth probes per sample: 1, 4, 9 or 16 (§3.2). An item buffer is supersampled by the same
    /// number and has three layers if it is more than one.
    std::uint32_t probes = 9;
    int depth_scale = 2; ///< depth texels per pixel and axis: 1 to 4
    /// A depth buffer that hides lines, in place of the one that the renderer draws of the line
    /// set's triangles; `depth_scale` and the form of `depth` have no effect then. Methods atlas
    /// and spine only.
    std::optional<DepthTexture> own_depth{};
    float step = 2; ///< k: pixels between samples, 0.01 to 10000 (§4.1)
    /// The kinds to draw, of those that were extracted. Nothing: the usual kinds and
    /// Style::more_lines.
    std::optional<LineKindMask> lines{};
    StageForms forms{}; ///< where stages run
    /// The look of the lines. The method spine uses only the pen's mark, width, colour and opacity.
    /// item_buffer also uses joins and caps. opengl uses only width, colour and opacity.
    Style style{};
    /// Leave out triangles and segments that are hidden as a whole, if the model is large enough
    /// for that to pay. Changes nothing in the picture.
    bool cull_hidden = true;
    /// In slow motion, average visibility with that of the frame before, so that lines don't
    /// sparkle, and carry texture coordinates of silhouettes over, so that textures don't crawl. A
    /// still picture, and the first one after a jump, do not change. Method atlas only.
    bool steady = true;
    KeptIntervals intervals = KeptIntervals::none; ///< atlas and exact only
    /// Draw the picture. False: a frame is only computed, for its intervals.
    bool draw = true;
    bool measure_stages = false; ///< wait after every stage and report its time; slower
    bool profile = false;        ///< keep times for Renderer::take_profiles()
};

/// The options by which `lineatlas draw` draws one picture unless its own options say otherwise:
/// Method::exact and default_style(). FrameOptions{} is for many frames in a row: Method::atlas, as
/// the tool draws sequences.
LINEATLAS_API FrameOptions default_frame_options();

/// The target of a picture that is drawn tile by tile.
struct TileTarget {
    std::uint32_t framebuffer = 0; ///< or `bound_framebuffer`
    int tile_size = 2048; ///< most pixels a side of a tile; the framebuffer must be as large
    /// Called before a tile is drawn into the framebuffer's lower left corner, to clear it.
    std::function<void(const PictureTile&)> begin{};
    /// Called after a tile was drawn, to take its pixels.
    std::function<void(const PictureTile&)> end{};
    Progress progress{}; ///< asked before each tile, in your GL state; see Renderer::draw_tiles()
};

/// The time of a stage of a frame, from one wait for the device to the next.
struct StageTime {
    std::string name;    ///< depth, pyramid, facing, silhouette, chain, project_clip, scan, atlas,
                         ///< compact, strokes, ...
    double milliseconds; ///< with its share of waiting
};

/// What one frame did.
struct FrameStats {
    std::uint32_t triangles = 0;       ///< of the line set
    std::uint32_t triangles_drawn = 0; ///< for the depth; fewer if most of a large model is hidden
    std::uint32_t segments = 0;        ///< candidates, silhouettes included
    std::uint32_t samples = 0;         ///< visibility samples, §4.1
    std::uint32_t runs = 0;            ///< visible runs drawn
    std::uint64_t mesh_bytes = 0;      ///< compute memory of vertices and triangles
    std::uint64_t segment_bytes = 0;   ///< of the segment tables
    std::uint64_t sample_bytes = 0;    ///< of the atlas
    std::uint64_t run_bytes = 0;       ///< of the visible runs
    std::vector<StageTime> stages;     ///< when measured
};

/// The framebuffer that is bound for drawing when a call is made.
inline constexpr std::uint32_t bound_framebuffer = 0xFFFFFFFF;

/// Draws a line set through the segment atlas (§4).
///
/// A renderer belongs to the GL 4.5 context, core or compatibility, that is current when the
/// renderer is made. That context must be current in every call, on any thread, by one thread at a
/// time. Several renderers may share a context. Renderers of different contexts may work at the
/// same time on different threads. A call throws UsageError if no context or another context is
/// current, or if the context carries out no drawing (glNewList()), and DeviceError if GL is too
/// old. Destroy a renderer with its context current. Otherwise nothing breaks, but its GL objects
/// stay until the context is destroyed.
///
/// All calls throw Error.
class LINEATLAS_API Renderer {
  public:
    /// Makes a renderer in the current GL context. Throws UsageError for a backend or sharing mode
    /// that does not exist, DeviceError if the machine has no such device or can't share buffers in
    /// that mode.
    explicit Renderer(const DeviceOptions& options = {});
    ~Renderer();
    /// A moved-from renderer may only be assigned to or destroyed.
    Renderer(Renderer&&) noexcept;
    /// The context of the old renderer must be current, because that renderer is destroyed.
    Renderer& operator=(Renderer&&) noexcept;

    /// @name The device
    /// @code{.cpp}
    /// std::cout << renderer.description() << '\n' << renderer.note() << '\n';
    /// renderer.set_device({.compute = "cpp"});
    /// @endcode
    /// @{

    /// The compute backend in use and how it shares buffers, for people.
    std::string description() const;

    /// The memory that the tables of all frames so far take on the compute device, in the order of
    /// their first use. docs/architecture.md says what each table holds.
    std::vector<compute::TableMemory> tables() const;

    /// One line for people if the device is not the expected one: no OpenCL driver works, or a
    /// driver did not build a kernel and the next device has taken over. The latter may happen when
    /// a frame first needs the kernel. Else empty, and always empty if DeviceOptions names a
    /// device.
    std::string note() const;

    /// Changes backend, device and sharing mode between frames. Lines and pens are copied from the
    /// old device. Results of the last frame can no longer be read, and the next frame is not
    /// averaged with it. Throws as the constructor does, and then nothing has changed. Lines cannot
    /// be copied from a lost device: make a new renderer.
    void set_device(const DeviceOptions& options);

    /// The amount that DeviceOptions::compare_with has found equal.
    struct Comparison {
        std::uint64_t kernels = 0;  ///< kernels that ran
        std::uint64_t elements = 0; ///< elements of the tables that they wrote
    };
    /// Counted from the renderer's first frame.
    Comparison comparison() const;

    /// @}
    /// @name Lines, pens and objects
    /// @code{.cpp}
    /// renderer.set_lines(lines);
    /// renderer.set_transforms(std::vector<glm::mat4>(lines.objects.size(), glm::mat4{1}));
    /// renderer.set_positions(first_vertex, new_positions); // the shape changes
    /// renderer.set_hidden(std::vector<std::uint32_t>{3, 7}); // all other objects are shown
    /// @endcode
    /// @{

    /// Gives the picture for pens whose Pen::mark is `mark`. Throws UsageError if `mark` is not the
    /// name of a file (it needs a `/` or a `.`), or if the picture is empty.
    void set_pen_image(const std::string& mark, Image image);

    /// Uploads the lines and triangles to draw, in place of earlier ones. Throws UsageError for an
    /// index that is out of range and for a vertex that is not finite; the earlier lines stay then.
    void set_lines(const LineSet& lines);
    /// The same with the parts of an assembly, which may change and be set again. Parts that were
    /// in the assembly the last time stay moved or hidden, and cost nothing. New parts stand where
    /// they were made. Each part is an object. set_transforms() takes a matrix for every number,
    /// also for removed parts; theirs is ignored. Results of the last frame can no longer be read.
    void set_lines(const Assembly& parts);

    /// Moves the objects (LineSet::objects; the whole model if it has none) by a matrix each, from
    /// the place where the object was made to the world. The next frame shows the move; nothing is
    /// rebuilt. Creases stay as they are. Silhouettes are found anew, smooth ones by normals that
    /// turn with their objects, also with mirrored and stretched ones. Throws UsageError before
    /// set_lines(), for another number of matrices, and for a matrix that is not affine, not finite
    /// or singular; then nothing has changed.
    void set_transforms(std::span<const glm::mat4> world_from_object);

    /// Changes the shape: moves the vertices (LineSet::vertices) from `first` on to other
    /// positions, in the coordinates of their objects. Lines keep their kinds and their edges.
    /// Smooth silhouettes follow the normals of the changed triangles, even if the file had its own
    /// normals. Throws UsageError for vertices that do not exist, and for positions that are not
    /// finite.
    void set_positions(std::uint32_t first, std::span<const glm::vec3> positions);

    /// Hides these objects (of LineSet::objects, by number) and shows all others. A hidden object
    /// has no lines and hides nothing. The next frame shows the change; nothing is rebuilt, and
    /// after the first time no memory is allocated. Throws UsageError before set_lines(), and for
    /// an object that does not exist; then nothing has changed.
    void set_hidden(std::span<const std::uint32_t> objects);

    /// @}
    /// @name Drawing
    /// @code{.cpp}
    /// renderer.prepare(options); // no frame has to wait for kernels
    /// const FrameStats stats = renderer.draw(camera, options, bound_framebuffer);
    /// @endcode
    /// @{

    /// Builds all kernels that frames with these options need, whatever the lines and the camera
    /// are, so that no draw() with these options builds any. May be called before set_lines().
    /// After set_lines() it also builds the forms that PoCL needs for 65,536 and more segments,
    /// vertices or triangles. Built kernels stay for all renderers of the process on that device
    /// (docs/embedding.md). After set_device() other kernels may be needed. Options that concern
    /// only the picture have no effect. `progress` is called before each kernel, in your GL state.
    /// Kernels that were built before it returned false stay built. Throws as draw() does for wrong
    /// options.
    void prepare(const FrameOptions& options, const Progress& progress = {});

    /// Draws a frame over the content of `framebuffer` (or `bound_framebuffer`) in the camera's
    /// viewport, premultiplied. Method opengl clears the depth there. Throws UsageError,
    /// before anything is drawn, for options and a style out of range, for a camera whose picture
    /// is empty or too large or whose matrices are not finite or have no inverse, and for a
    /// framebuffer that is not complete or lacks the depth attachment that method opengl needs.
    FrameStats draw(const Camera& camera, const FrameOptions& options, std::uint32_t framebuffer);

    /// The largest TileTarget::tile_size with which a picture of this size can be drawn here; 0 if
    /// draw() can draw it whole. Throws UsageError for a size that cannot be drawn at all.
    int tile_size(glm::ivec2 size, const FrameOptions& options) const;

    /// Draws a picture that may be larger than any framebuffer, without seams: visibility is that
    /// of the whole picture, and strokes continue over the borders of tiles. Rows of tiles come
    /// from top to bottom. Takes only the method exact, and atlas in its compute form.
    /// `cull_hidden` and `steady` have no effect. Throws Cancelled if TileTarget::progress returns
    /// false; the renderer can still be used then. Throws UsageError as draw() does.
    FrameStats draw_tiles(const Camera& camera, const FrameOptions& options,
                          const TileTarget& target);

    /// @}
    /// @name Results of the last frame
    /// @code{.cpp}
    /// options.intervals = KeptIntervals::visible;
    /// renderer.draw(camera, options, framebuffer);
    /// for (const Interval& piece : renderer.read_intervals()) std::cout << piece.segment << '\n';
    /// if (const auto pick = renderer.pick({320, 240}, 4)) std::cout << pick->object << '\n';
    /// @endcode
    /// @{

    /// The visibility of every sample of a frame in order of the segment table.
    struct Samples {
        std::vector<std::uint32_t> offsets; ///< first sample of each segment, then the total
        std::vector<std::uint8_t> alpha;    ///< per sample, 0 hidden to 255 visible
        std::vector<Run> runs;              ///< what was drawn
        /// The share of lines that density control leaves, 0 to 1: for each priority
        /// (LA_DENSITY_BINS) the picture's cells of LA_DENSITY_CELL pixels (larger above 8192
        /// pixels a side), row by row. Empty without density control.
        std::vector<float> density{};
    };
    /// The samples of the last frame, for tests and studies. Waits for the device. With
    /// `cull_hidden`, segments that are hidden as a whole have no samples, and if the style
    /// measures no lengths, they do not count in the arc lengths of their paths (Run::start_arc).
    /// Throws UsageError unless the last frame was drawn by the method atlas or item_buffer.
    Samples read_samples();

    /// The visible pieces of the lines of the last frame, and with KeptIntervals::all also the
    /// hidden pieces, in order of LineSet::segments and along each segment. By the method atlas the
    /// depth buffer gives their ends, between the samples. Results differ between devices only by
    /// rounding. Waits for the device, and reads only the intervals from it. Throws UsageError if
    /// the last frame kept no intervals (FrameOptions::intervals).
    std::vector<Interval> read_intervals();

    /// What the last frame shows at `position`, in pixels from the lower left corner of its
    /// viewport: the nearest visible line within `radius` pixels, or else the face there, or
    /// nothing. Always found by the exact method, whatever the frame's method: a program's own
    /// depth has no effect, lines that a style leaves out count, and objects that have moved since
    /// are at their new places. Throws UsageError before the first frame of the lines, for a
    /// position that is not finite, and for a radius that is not from 0 to 1000.
    std::optional<Pick> pick(glm::vec2 position, float radius);
    /// The same for what a camera would show now, among lines of these kinds, without a frame.
    /// Throws UsageError for a camera that draw() does not take.
    std::optional<Pick> pick(const Camera& camera, glm::vec2 position, float radius,
                             LineKindMask lines = all_line_kinds);

    /// The parts of the intervals of the last frame that have the background on one side. Only for
    /// a style whose pens have a rule for outlines.
    std::vector<OutlinePart> read_outlines();

    /// The profiles of frames drawn with `FrameOptions::profile` that were not taken yet, in order.
    /// GL and the device return the times of a frame while later frames are drawn. With `wait` the
    /// call waits for the times of the last frame. Frames more than four behind are dropped, and
    /// counted.
    std::vector<FrameProfile> take_profiles(bool wait = true);
    /// @}

  private:
    class LINEATLAS_LOCAL State;
    std::unique_ptr<State> state_;
};

} // namespace lineatlas
