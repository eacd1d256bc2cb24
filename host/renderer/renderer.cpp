#include "lineatlas/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "atlas_method.hpp"
#include "backdrop.hpp"
#include "compute/backends.hpp"
#include "compute/compare/comparing_backend.hpp"
#include "frame.hpp"
#include "glpasses/interop/connect.hpp"
#include "lineatlas/error.hpp"
#include "opengl_method.hpp"
#include "pen_textures.hpp"
#include "spine_method.hpp"

namespace lineatlas {
namespace {

interop::ConnectOptions connect_options(const DeviceOptions& options) {
    interop::ConnectOptions result{
        .backend = options.compute, .device = options.device, .mode = std::nullopt};
    for (const auto mode : {interop::SharingMode::gl_sharing, interop::SharingMode::host_pointer,
                            interop::SharingMode::copy}) {
        if (options.interop == interop::name_of(mode)) result.mode = mode;
    }
    if (!options.interop.empty() && !result.mode) {
        throw UsageError("unknown interop \"" + options.interop +
                         "\"; there is gl-sharing, host-pointer, copy");
    }
    if (!options.compare_with.empty()) {
        // Two backends cannot open one GL buffer.
        if (!result.mode) result.mode = interop::SharingMode::copy;
        if (result.mode == interop::SharingMode::gl_sharing) {
            throw UsageError("comparing backends needs interop host-pointer or copy");
        }
    }
    return result;
}

/// Connects, to a pair of backends if they are to be compared.
interop::Connection connect(const DeviceOptions& options) {
    interop::Connection connection = interop::connect(connect_options(options));
    if (options.compare_with.empty()) return connection;
    const std::string& other = options.compare_with;
    const std::string kind = other.substr(0, other.find(':'));
    connection.backend = compute::make_comparing_backend(
        std::move(connection.backend), compute::make_backend(kind, other == kind ? "" : other),
        options.compare_until);
    return connection;
}

void check(const Pen& pen, const std::string& name) {
    if (!(pen.width > 0) || pen.width > 1000) {
        throw UsageError(name + ": width must lie above 0 and be at most 1000 pixels");
    }
    for (const Profile* profile : {&pen.width_profile, &pen.opacity_profile}) {
        if (profile->empty() || profile->size() > 16) {
            throw UsageError(name + ": a profile has 1 to 16 values, not " +
                             std::to_string(profile->size()));
        }
    }
}

void check(const FrameOptions& options) {
    if (options.depth_scale < 1 || options.depth_scale > 4) {
        throw UsageError("depth-scale must be 1, 2, 3 or 4, not " +
                         std::to_string(options.depth_scale));
    }
    if (!(options.step >= 0.01F) || !std::isfinite(options.step)) {
        throw UsageError("step must be a number of pixels of at least 0.01");
    }
    const bool only_atlas = options.intervals != KeptIntervals::none || !options.draw;
    if (only_atlas && options.method != Method::atlas) {
        throw UsageError("renderer: intervals, and frames that are not drawn, need method atlas");
    }
    check(options.style.pen, "pen");
    if (options.style.hidden) check(options.style.hidden_pen, "hidden pen");
}

} // namespace

class Renderer::State {
  public:
    explicit State(const DeviceOptions& options)
        : connection_(connect(options)), atlas_(std::make_unique<AtlasMethod>(connection_)) {}

    void set_device(const DeviceOptions& options) {
        interop::Connection connection = connect(options);
        auto atlas = std::make_unique<AtlasMethod>(connection);
        std::optional<SceneBuffers::Tables> tables;
        if (scene_) {
            tables = scene_->copy_tables(*connection.backend);
            atlas->set_scene(*scene_);
        }
        // Nothing throws from here on. Buffers go before the backend that made them.
        atlas_ = std::move(atlas);
        spine_.reset();
        if (scene_) scene_->use(*connection.backend, std::move(*tables));
        connection_ = std::move(connection);
        samples_drawn_ = false;
    }

    Comparison comparison() const {
        const auto* comparing =
            dynamic_cast<const compute::ComparingBackend*>(connection_.backend.get());
        if (comparing == nullptr) return {};
        return {comparing->summary().stages, comparing->summary().elements};
    }

    std::string description() const {
        return connection_.backend->description() + ", sharing by " +
               std::string{interop::name_of(connection_.mode)};
    }

    void set_lines(const LineSet& lines) {
        scene_.reset();
        samples_drawn_ = false;
        scene_.emplace(*connection_.backend, lines);
        atlas_->set_scene(*scene_);
        if (spine_) spine_->set_scene(*scene_);
    }

    FrameStats draw(const Camera& camera, const FrameOptions& options, GLuint framebuffer) {
        Frame frame = begin(camera, options, framebuffer);
        samples_drawn_ = options.method == Method::atlas || options.method == Method::item_buffer;
        FrameStats stats = draw_method(frame);
        if (options.draw) backdrop_.draw_paper(frame, options.style.paper);
        std::ranges::move(frame.clock.take(), std::back_inserter(stats.stages));
        return stats;
    }

    FrameStats draw_tiles(const Camera& camera, const FrameOptions& options,
                          const TileTarget& target) {
        Frame frame = begin(camera, options, target.framebuffer);
        samples_drawn_ = false;
        FrameStats stats = atlas_->draw_tiles(frame, target);
        samples_drawn_ = true;
        return stats;
    }

    void set_pen_image(const std::string& mark, Image image) {
        pens_.set_image(mark, std::move(image));
    }

    Samples read_samples() {
        if (!samples_drawn_) {
            throw UsageError(
                "renderer: read_samples() needs a frame of method atlas or itembuffer");
        }
        return atlas_->read_samples();
    }

    std::vector<Interval> read_intervals() { return atlas_->read_intervals(); }

  private:
    Frame begin(const Camera& camera, const FrameOptions& options, GLuint framebuffer) {
        if (!scene_) throw UsageError("renderer: set_lines() must come before draw()");
        check(options);
        Frame frame{.camera = camera,
                    .options = options,
                    .scene = *scene_,
                    .framebuffer = framebuffer,
                    .pens = pens_,
                    .backdrop = backdrop_,
                    .clock = {*connection_.backend, options.measure_stages}};
        frame.stroke_params(options.style.pen); // refuses an unknown pen and
        frame.probes_per_axis(); // refuses what is not a square before anything is drawn
        return frame;
    }

    FrameStats draw_method(Frame& frame) {
        switch (frame.options.method) {
        case Method::atlas:
        case Method::item_buffer:
            return atlas_->draw(frame);
        case Method::spine:
            if (!spine_) spine_.emplace(connection_).set_scene(*scene_);
            return spine_->draw(frame);
        case Method::opengl:
            if (!opengl_) opengl_.emplace();
            return opengl_->draw(frame);
        }
        throw UsageError("renderer: unknown method");
    }

    interop::Connection connection_;
    std::optional<SceneBuffers> scene_;
    PenTextures pens_;
    Backdrop backdrop_;
    std::unique_ptr<AtlasMethod> atlas_;
    bool samples_drawn_ = false; ///< the last frame left samples to read
    // Shaders of the other methods are compiled when they are first used.
    std::optional<SpineMethod> spine_;
    std::optional<OpenGlMethod> opengl_;
};

Renderer::Renderer(const DeviceOptions& options) : state_(std::make_unique<State>(options)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

std::string Renderer::description() const {
    return state_->description();
}
void Renderer::set_device(const DeviceOptions& options) {
    state_->set_device(options);
}
Renderer::Comparison Renderer::comparison() const {
    return state_->comparison();
}
void Renderer::set_pen_image(const std::string& mark, Image image) {
    state_->set_pen_image(mark, std::move(image));
}
void Renderer::set_lines(const LineSet& lines) {
    state_->set_lines(lines);
}
FrameStats Renderer::draw(const Camera& camera, const FrameOptions& options,
                          std::uint32_t framebuffer) {
    return state_->draw(camera, options, framebuffer);
}
std::vector<Interval> Renderer::read_intervals() {
    return state_->read_intervals();
}
FrameStats Renderer::draw_tiles(const Camera& camera, const FrameOptions& options,
                                const TileTarget& target) {
    return state_->draw_tiles(camera, options, target);
}
Renderer::Samples Renderer::read_samples() {
    return state_->read_samples();
}

} // namespace lineatlas
