#include "lineatlas/renderer.hpp"

#include <optional>
#include <utility>

#include "atlas_method.hpp"
#include "backdrop.hpp"
#include "check_options.hpp"
#include "compute/compare/comparing_device.hpp"
#include "compute/kernels.hpp"
#include "compute/opencl/build_error.hpp"
#include "core/assembly_state.hpp"
#include "core/check_camera.hpp"
#include "core/check_lines.hpp"
#include "core/limits.hpp"
#include "core/picture_size.hpp"
#include "core/progress.hpp"
#include "exact_method.hpp"
#include "form_costs.hpp"
#include "frame.hpp"
#include "glpasses/current_context.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/objects.hpp"
#include "glpasses/state_guard.hpp"
#include "lineatlas/assembly.hpp"
#include "lineatlas/error.hpp"
#include "needed_kernels.hpp"
#include "opengl_method.hpp"
#include "pen_textures.hpp"
#include "picture_limits.hpp"
#include "spine_method.hpp"
#include "trial_frames.hpp"
#include "visibility/picking.hpp"

namespace lineatlas {
namespace {

GLuint framebuffer_name(GLuint framebuffer) {
    if (framebuffer == bound_framebuffer) {
        GLint bound = 0;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
        return static_cast<GLuint>(bound);
    }
    if (framebuffer != 0 && glIsFramebuffer(framebuffer) == GL_FALSE) {
        throw UsageError("renderer: there is no framebuffer " + std::to_string(framebuffer) +
                         " in this context; make it in the renderer's own context");
    }
    return framebuffer;
}

/// Throws UsageError for a framebuffer that a frame with these options cannot be drawn to.
void check_framebuffer(GLuint framebuffer, const FrameOptions& options) {
    const GLenum status = glCheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_UNDEFINED) {
        throw UsageError("renderer: this context has no framebuffer of its own; make one, and give "
                         "its name in place of 0");
    }
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw UsageError("renderer: the framebuffer " + std::to_string(framebuffer) +
                         " is not complete (glCheckFramebufferStatus() says why)");
    }
    if (options.method == Method::opengl && !has_depth_attachment(framebuffer)) {
        throw UsageError("method opengl: the framebuffer has no depth attachment; add one or use "
                         "method atlas");
    }
}

/// The progress callback, called in the program's own GL state. Both arguments must outlive it.
Progress outside(gl::StateGuard& guard, const Progress& progress) {
    if (!progress) return {};
    return [&](float done) {
        guard.restore();
        const bool goes_on = progress(done);
        guard.take();
        return goes_on;
    };
}

AutomaticForms forms_for(const interop::Connection& connection) {
    return lineatlas::forms_for(connection.device->tuning(),
                                interop::handover_rates(*connection.sharing));
}

} // namespace

class Renderer::State {
    friend class Renderer;

  public:
    explicit State(const DeviceOptions& options)
        : connection_(interop::connect(options)), automatic_(forms_for(connection_)),
          atlas_(std::make_unique<AtlasMethod>(connection_)) {}

    compute::Device& device() const { return connection_.stages->device(); }

    void use(interop::Connection connection) {
        auto atlas = std::make_unique<AtlasMethod>(connection);
        const AutomaticForms automatic = forms_for(connection);
        std::optional<SceneBuffers::Tables> tables;
        if (scene_) {
            tables = scene_->copy_tables(*connection.stages, *connection.sharing);
            atlas->set_scene(*scene_, *tables);
        }
        // Nothing throws from here on. Buffers go before the device that made them.
        recorder_.reset();
        atlas_ = std::move(atlas);
        automatic_ = automatic;
        spine_.reset();
        exact_.reset();
        picking_.reset();
        if (scene_) scene_->use(*connection.stages, *connection.sharing, std::move(*tables));
        std::swap(connection_, connection); // an assignment would end the device before the stages
        samples_drawn_ = broken_ = tried_ = false;
    }

    /// Call at the start of any call that uses GL. Refuses any context but the renderer's own. The
    /// guard that it returns keeps the program's state.
    gl::StateGuard enter() const {
        if (gl::require_context() != context_) {
            throw UsageError(
                "renderer: the current OpenGL context is not the one that this renderer "
                "was made in; make that one current");
        }
        gl::require_alive();
        return gl::StateGuard{};
    }

    void set_parts(const AssemblyState& parts) {
        bool updated = false;
        try {
            updated = scene_ && !broken_ && scene_->update_parts(parts);
        } catch (...) {
            scene_.reset(); // half a scene is none
            throw;
        }
        if (!updated) return set_lines(parts.lines, &parts);
        samples_drawn_ = has_frame_ = false;
        atlas_->forget_lines();
        if (exact_) exact_->forget_lines();
        if (picking_) picking_->forget_lines();
    }

    /// `parts`: the assembly that the lines are of, if its parts come and go.
    void set_lines(const LineSet& lines, const AssemblyState* parts = nullptr) {
        scene_.reset();
        samples_drawn_ = false;
        mend();
        broken_ = false;
        picking_.reset();
        has_frame_ = false;
        atlas_->release_scene();
        if (exact_) exact_->release_scene();
        scene_.emplace(*connection_.stages, *connection_.sharing, lines, parts);
        try {
            atlas_->set_scene(*scene_, scene_->tables());
            if (spine_) spine_->set_scene(*scene_);
            if (exact_) exact_->set_scene(*scene_);
        } catch (...) {
            scene_.reset(); // half a scene is none
            throw;
        }
    }

    /// The scene, to be moved.
    SceneBuffers& scene() {
        if (!scene_)
            throw UsageError(
                "renderer: set_lines() must come before calls that move or hide objects");
        return *scene_;
    }

    /// Runs an action that launches kernels on a device that has been tried. If the device fails to
    /// build a kernel, and the user has not chosen it, the next device takes over.
    template <class Action>
    auto where_kernels_build(Action&& action) -> decltype(action()) {
        for (;;) {
            try {
                if (!tried_) try_frames(device(), connection_.sharing->mode());
                tried_ = true;
                return action();
            } catch (const compute::BuildError& error) {
                if (!connection_.otherwise) throw;
                use(interop::connect_next(connection_, error.what()));
            }
        }
    }

    FrameStats draw(const Camera& camera, const FrameOptions& options, GLuint framebuffer) {
        check_frame(camera, options);
        framebuffer = framebuffer_name(framebuffer);
        if (options.draw) check_framebuffer(framebuffer, options);
        return draw_by(camera, options, framebuffer, [&](Frame& frame) {
            FrameStats stats = draw_method(frame);
            if (options.draw) backdrop_.draw_paper(frame, options.style.paper);
            return stats;
        });
    }

    void prepare(const FrameOptions& options, const Progress& progress) {
        check(options);
        const std::vector<compute::KernelForm> kernels =
            needed_kernels(options, automatic_, device());
        const bool many = scene_ && scene_->most_elements() >= compute::IdleLaunches::many_items;
        const ProgressPart part{progress, "preparing"};
        compute::IdleLaunches idle{device()};
        float done = 0;
        for (const compute::KernelForm& kernel : kernels) {
            part(done++ / static_cast<float>(kernels.size()));
            idle.launch(kernel);
            if (many && kernel.per_element) idle.launch(kernel, true);
        }
        part(1);
    }

    FrameStats draw_tiles(const Camera& camera, const FrameOptions& options,
                          const TileTarget& target) {
        if (options.own_depth) {
            throw UsageError("tiles: pictures in tiles draw their own depth; leave out "
                             "FrameOptions::own_depth");
        }
        if (target.tile_size < 1)
            throw UsageError("tiles: a tile must have at least one pixel a side");
        check_frame(camera, options);
        return draw_by(camera, options, framebuffer_name(target.framebuffer), [&](Frame& frame) {
            return options.method == Method::exact ? exact().draw_tiles(frame, target)
                                                   : atlas_->draw_tiles(frame, target);
        });
    }

    std::vector<Interval> read_intervals() {
        if (broken_) throw UsageError("renderer: read_intervals() needs a frame that was drawn");
        return has_exact_intervals_ && exact_ ? exact_->read_intervals() : atlas_->read_intervals();
    }

    std::optional<Pick> pick(glm::vec2 position, float radius) {
        if (!has_frame_) throw UsageError("renderer: pick() needs a frame that was drawn");
        LineKindMask kinds = drawn_kinds(options_.lines, options_.style);
        if (options_.method == Method::opengl) kinds &= ~mask_of(LineKind::silhouette);
        return pick_in(camera_.camera, position, radius, kinds);
    }

    std::optional<Pick> pick(const Camera& camera, glm::vec2 position, float radius,
                             LineKindMask kinds) {
        if (!scene_) throw UsageError("renderer: set_lines() must come before pick()");
        check_camera(camera);
        return pick_in(lineatlas::standard_camera(camera, scene_->bounds()).camera, position,
                       radius, kinds);
    }

    std::vector<OutlinePart> read_outlines() {
        if (broken_) throw UsageError("renderer: read_outlines() needs a frame that was drawn");
        return has_exact_intervals_ && exact_ ? exact_->read_outlines() : atlas_->read_outlines();
    }

  private:
    std::optional<Pick> pick_in(const Camera& camera, glm::vec2 position, float radius,
                                LineKindMask kinds) {
        check_pick(position, radius);
        if (scene_->has_moved()) scene_->move();
        const LineView view{.camera = camera,
                            .bounds = scene_->bounds(),
                            .contact = scene_->contact(),
                            .lines = kinds,
                            .step = finest_step};
        const PlacedLines lines = scene_->placed();
        try {
            if (!picking_) picking_.emplace(*connection_.stages, lines);
            return lineatlas::pick(*picking_, device(), lines, scene_->motion().objects(), view,
                                   position, radius);
        } catch (...) {
            picking_.reset(); // half made
            throw;
        }
    }

    DeviceError needs_whole_table(const Purpose& purpose) const {
        const std::uint64_t bytes = scene_->segment_count() * std::uint64_t{sizeof(ClippedSegment)};
        const std::uint64_t most = device().largest_buffer();
        return DeviceError{beyond_limit(purpose,
                                        "all line segments in one table of " + written_bytes(bytes),
                                        "a buffer of this device holds " + written_bytes(most))};
    }

    /// Throws DeviceError for options that need all segments in one buffer, if they are in chunks.
    void check_chunks(const FrameOptions& options) const {
        if (options.method == Method::item_buffer) throw needs_whole_table(purpose::all_items);
        const bool has_strokes = options.method == Method::atlas || options.method == Method::exact;
        if (has_strokes && options.draw && options.style.filter.halo > 0)
            throw needs_whole_table(purpose::all_halos);
    }

    /// Makes new tables in place of those that a failed frame has left half made.
    void mend() {
        if (!broken_) return;
        spine_.reset();
        exact_.reset();
        atlas_.reset(); // another may not fit beside it
        atlas_ = std::make_unique<AtlasMethod>(connection_);
    }

    /// Runs an action that draws. If it fails, tables may be on the side of GL or of compute, or
    /// half made. Then the next frame starts with new tables.
    template <class Action>
    FrameStats unbroken(Action&& action) {
        if (broken_) {
            mend();
            atlas_->set_scene(*scene_, scene_->tables());
        }
        broken_ = true;
        has_frame_ = false;
        FrameStats stats;
        try {
            stats = action();
        } catch (const DeviceError&) {
            gl::require_alive(); // a lost context would be the reason of the failure
            throw;
        }
        gl::require_alive();
        broken_ = false;
        has_frame_ = true;
        stats.triangles = scene_->triangle_count();
        stats.segments = scene_->segment_count();
        count_memory(stats);
        return stats;
    }

    /// Draws a frame by an action, and takes its times.
    template <class Action>
    FrameStats draw_by(const Camera& camera, const FrameOptions& options, GLuint framebuffer,
                       Action&& action) {
        std::optional<ProfileRecorder::Frame> profiled = begin_profile(options);
        Frame frame = begin(camera, options, framebuffer);
        move(frame);
        samples_drawn_ = false;
        FrameStats stats = unbroken([&] { return action(frame); });
        samples_drawn_ = options.method == Method::atlas || options.method == Method::item_buffer;
        has_exact_intervals_ = options.method == Method::exact;
        stats.stages = frame.clock.take();
        if (profiled) profiled->finish(stats);
        return stats;
    }

    void count_memory(FrameStats& stats) const {
        stats.mesh_bytes =
            compute::bytes_for(device(), {&purpose::model, &purpose::motion, &purpose::fill});
        stats.segment_bytes = compute::bytes_for(device(), {&purpose::segments, &purpose::exact});
        stats.sample_bytes = compute::bytes_for(device(), {&purpose::atlas});
        stats.run_bytes =
            compute::bytes_for(device(), {&purpose::strokes, &purpose::density, &purpose::halos});
    }

    std::optional<ProfileRecorder::Frame> begin_profile(const FrameOptions& options) {
        if (!options.profile) return std::nullopt;
        if (!recorder_) recorder_.emplace(device(), gl::is_software());
        return std::optional<ProfileRecorder::Frame>{std::in_place, *recorder_};
    }

    /// The camera as stages want it. Refuses a depth texture that cannot be read.
    StandardCamera standard_camera(const Camera& camera, const FrameOptions& options) const {
        if (!options.own_depth) return lineatlas::standard_camera(camera, scene_->bounds());
        DepthValues values =
            gl::check_depth_texture(options.own_depth->texture, options.own_depth->origin,
                                    camera.size * options.own_depth->scale);
        values.range = options.own_depth->range;
        return lineatlas::standard_camera(camera, scene_->bounds(), values);
    }

    /// Throws UsageError if a pen that draws has a mark without a picture.
    void check_marks(const Style& style) const {
        pens_.check(style.pen.mark);
        if (style.hidden) pens_.check(style.hidden_pen.mark);
        if (style.focus.on) pens_.check(style.focus.mark);
        for (const PenRule& rule : style.pens)
            if (rule.mark) pens_.check(*rule.mark);
    }

    /// Throws UsageError or DeviceError for options that cannot be drawn, before anything is drawn.
    void check_frame(const Camera& camera, const FrameOptions& options) const {
        if (!scene_) throw UsageError("renderer: set_lines() must come before draw()");
        check(options);
        check_camera(camera);
        if (options.draw) check_marks(options.style);
        if (scene_->chunk_count() > 1) check_chunks(options);
    }

    Frame begin(const Camera& camera, const FrameOptions& options, GLuint framebuffer) {
        options_ = options;
        scale_lengths(options_.style, camera.size);
        camera_ = standard_camera(camera, options);
        return {.camera = camera_.camera,
                .depth_mapping = camera_.depth,
                .options = options_,
                .automatic = automatic_,
                .scene = *scene_,
                .framebuffer = framebuffer,
                .pens = pens_,
                .backdrop = backdrop_,
                .clock = {*connection_.sharing, options.measure_stages,
                          options.profile ? &*recorder_ : nullptr}};
    }

    void move(Frame& frame) {
        frame.stroke_params(options_.style.pen); // refuses a pen that has no texture here
        if (scene_->has_moved()) frame.clock("transform", [&] { scene_->move(); });
    }

    /// Made when first used, for the current scene.
    ExactMethod& exact() {
        if (!exact_) exact_.emplace(connection_).set_scene(*scene_);
        return *exact_;
    }

    FrameStats draw_method(Frame& frame) {
        switch (frame.options.method) {
        case Method::atlas:
        case Method::item_buffer:
            return atlas_->draw(frame);
        case Method::exact:
            return exact().draw(frame);
        case Method::spine:
            if (!spine_) spine_.emplace(connection_).set_scene(*scene_);
            return spine_->draw(frame);
        case Method::opengl:
            if (!opengl_) opengl_.emplace();
            return opengl_->draw(frame);
        }
        throw UsageError("renderer: unknown method");
    }

    gl::CurrentContext context_ = gl::current_context();
    interop::Connection connection_;
    AutomaticForms automatic_; ///< of that connection
    StandardCamera camera_;    ///< of the current frame
    FrameOptions options_;     ///< of the current frame, with lengths for its size
    std::optional<SceneBuffers> scene_;
    std::optional<ProfileRecorder> recorder_; ///< from the first profiled frame on
    PenTextures pens_;
    Backdrop backdrop_;
    std::unique_ptr<AtlasMethod> atlas_;
    bool tried_ = false;               ///< compute::try_device() has tried the device
    bool broken_ = false;              ///< a frame was begun and not ended
    bool has_frame_ = false;           ///< the last frame shows the current lines
    bool samples_drawn_ = false;       ///< the last frame left samples to read
    bool has_exact_intervals_ = false; ///< the last frame's intervals are those of `exact_`
    // Tables and shaders of the other methods are made when they are first used.
    std::optional<ExactMethod> exact_;
    std::optional<SpineMethod> spine_;
    std::optional<OpenGlMethod> opengl_;
    std::optional<ExactIntervals> picking_; ///< the same
};

Renderer::Renderer(const DeviceOptions& options) {
    gl::require_context();
    const gl::StateGuard guard;
    state_ = std::make_unique<State>(options);
}
Renderer::~Renderer() {
    if (!state_) return;
    std::optional<gl::ForgetObjects> forget;
    if (gl::current_context() != state_->context_) forget.emplace();
    state_.reset();
}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&& other) noexcept {
    const Renderer old{std::move(*this)};
    state_ = std::move(other.state_);
    return *this;
}

std::string Renderer::description() const {
    return state_->device().description() + ", sharing by " +
           std::string{interop::name_of(state_->connection_.sharing->mode())};
}

std::vector<compute::TableMemory> Renderer::tables() const {
    const auto& all = state_->device().tables();
    return {all.begin(), all.end()};
}

std::string Renderer::note() const {
    return state_->connection_.note;
}

void Renderer::set_device(const DeviceOptions& options) {
    const gl::StateGuard guard = state_->enter();
    state_->use(interop::connect(options));
}
Renderer::Comparison Renderer::comparison() const {
    const auto* comparing = dynamic_cast<const compute::ComparingDevice*>(&state_->device());
    if (comparing == nullptr) return {};
    return {comparing->summary().kernels, comparing->summary().elements};
}
void Renderer::set_pen_image(const std::string& mark, Image image) {
    const gl::StateGuard guard = state_->enter();
    state_->pens_.set_image(mark, std::move(image));
}
void Renderer::set_lines(const LineSet& lines) {
    const gl::StateGuard guard = state_->enter();
    check_lines(lines);
    state_->set_lines(lines);
}
void Renderer::set_lines(const Assembly& parts) {
    const gl::StateGuard guard = state_->enter();
    state_->set_parts(*parts.state_);
}
void Renderer::set_transforms(std::span<const glm::mat4> world_from_object) {
    const gl::StateGuard guard = state_->enter();
    state_->scene().set_transforms(world_from_object);
}
void Renderer::set_positions(std::uint32_t first, std::span<const glm::vec3> positions) {
    const gl::StateGuard guard = state_->enter();
    state_->scene().set_positions(first, positions);
}
void Renderer::set_hidden(std::span<const std::uint32_t> objects) {
    const gl::StateGuard guard = state_->enter();
    state_->scene().set_hidden(objects);
}
std::optional<Pick> Renderer::pick(glm::vec2 position, float radius) {
    const gl::StateGuard guard = state_->enter();
    return state_->where_kernels_build([&] { return state_->pick(position, radius); });
}
std::optional<Pick> Renderer::pick(const Camera& camera, glm::vec2 position, float radius,
                                   LineKindMask lines) {
    const gl::StateGuard guard = state_->enter();
    return state_->where_kernels_build(
        [&] { return state_->pick(camera, position, radius, lines); });
}
FrameStats Renderer::draw(const Camera& camera, const FrameOptions& options,
                          std::uint32_t framebuffer) {
    const gl::StateGuard guard = state_->enter();
    return state_->where_kernels_build([&] { return state_->draw(camera, options, framebuffer); });
}
std::vector<Interval> Renderer::read_intervals() {
    const gl::StateGuard guard = state_->enter();
    return state_->read_intervals();
}
std::vector<OutlinePart> Renderer::read_outlines() {
    const gl::StateGuard guard = state_->enter();
    return state_->read_outlines();
}
std::vector<FrameProfile> Renderer::take_profiles(bool wait) {
    const gl::StateGuard guard = state_->enter();
    return state_->recorder_ ? state_->recorder_->take(wait) : std::vector<FrameProfile>{};
}
int Renderer::tile_size(glm::ivec2 size, const FrameOptions& options) const {
    const gl::StateGuard guard = state_->enter();
    check(options);
    check_picture(size);
    return tile_size_for(size, options, state_->device());
}
void Renderer::prepare(const FrameOptions& options, const Progress& progress) {
    gl::StateGuard guard = state_->enter();
    const Progress own = outside(guard, progress);
    state_->where_kernels_build([&] { state_->prepare(options, own); });
}
FrameStats Renderer::draw_tiles(const Camera& camera, const FrameOptions& options,
                                const TileTarget& target) {
    gl::StateGuard guard = state_->enter();
    // Callbacks of the program, between tiles, run in the program's own state.
    const auto between = [&guard](const auto& action) {
        return [&guard, &action](const PictureTile& tile) {
            guard.restore();
            action(tile);
            guard.take();
        };
    };
    bool has_tiles = false;
    const auto end = [&](const PictureTile& tile) {
        has_tiles = true;
        target.end(tile);
    };
    const TileTarget own{.framebuffer = target.framebuffer,
                         .tile_size = target.tile_size,
                         .begin = between(target.begin),
                         .end = between(end),
                         .progress = outside(guard, target.progress)};
    return state_->where_kernels_build([&] {
        try {
            return state_->draw_tiles(camera, options, own);
        } catch (const compute::BuildError& error) {
            if (has_tiles) throw DeviceError(error.what()); // none is drawn twice
            throw;
        }
    });
}
Renderer::Samples Renderer::read_samples() {
    const gl::StateGuard guard = state_->enter();
    if (!state_->samples_drawn_)
        throw UsageError("renderer: read_samples() needs a frame of method atlas or item-buffer");
    if (state_->scene_->chunk_count() > 1) throw state_->needs_whole_table(purpose::samples);
    return state_->atlas_->read_samples();
}

} // namespace lineatlas
