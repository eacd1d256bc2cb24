#include "lineatlas/renderer.hpp"

#include <chrono>
#include <cmath>
#include <map>

#include <glm/gtc/matrix_inverse.hpp>

#include "core/atlas_layout.hpp"
#include "core/pens.hpp"
#include "glpasses/atlas_pass.hpp"
#include "glpasses/depth_pass.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/handover.hpp"
#include "glpasses/stroke_pass.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

using compute::Buffer;
using interop::SharedBuffer;

// A surface hides a line if it stands before it by more than this many pixel widths: the line's own
// neighbourhood, a curved surface or a third face at a corner, must not.
constexpr float depth_tolerance_pixels = 1.0F;

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span{values});
}

std::uint32_t probes_per_axis(std::uint32_t probes) {
    const auto root = static_cast<std::uint32_t>(std::lround(std::sqrt(probes)));
    if (root < 1 || root > 4 || root * root != probes) {
        throw UsageError("probes must be 1, 4, 9 or 16, not " + std::to_string(probes));
    }
    return root;
}

void check(const FrameOptions& options) {
    if (options.depth_scale < 1 || options.depth_scale > 4) {
        throw UsageError("depth-scale must be 1, 2, 3 or 4, not " +
                         std::to_string(options.depth_scale));
    }
    if (!(options.step >= 0.01F) || !std::isfinite(options.step)) {
        throw UsageError("step must be a number of pixels of at least 0.01");
    }
    if (!(options.width > 0) || options.width > 1000) {
        throw UsageError("width must lie above 0 and be at most 1000 pixels");
    }
}

/// Window depth that one pixel's width is worth, in the direction of sight, times w.
float depth_per_pixel(const Camera& camera) {
    const glm::mat4& p = camera.projection;
    const bool perspective = std::abs(p[2][3]) > 0;
    const float depth_rate = perspective ? p[3][2] : p[2][2];
    return std::abs(depth_rate / (p[1][1] * static_cast<float>(camera.size.y)));
}

interop::ConnectOptions connect_options(const DeviceOptions& options) {
    interop::ConnectOptions result;
    if (options.compute != "opencl" && options.compute != "reference") {
        throw UsageError("unknown compute backend \"" + options.compute +
                         "\"; there is opencl, reference");
    }
    result.reference = options.compute == "reference";
    result.device = options.device;
    for (const auto mode : {interop::SharingMode::gl_sharing, interop::SharingMode::host_pointer,
                            interop::SharingMode::copy}) {
        if (options.interop == interop::name_of(mode)) result.mode = mode;
    }
    if (!options.interop.empty() && !result.mode) {
        throw UsageError("unknown interop \"" + options.interop +
                         "\"; there is gl-sharing, host-pointer, copy");
    }
    return result;
}

/// Times stages by waiting for them, or just runs them.
class StageClock {
  public:
    StageClock(compute::Backend& backend, bool measure) : backend_(backend), measure_(measure) {}

    template <class Action>
    void operator()(const char* name, Action&& action) {
        if (!measure_) return action();
        const auto start = std::chrono::steady_clock::now();
        action();
        glFinish();
        backend_.finish();
        const std::chrono::duration<double, std::milli> elapsed =
            std::chrono::steady_clock::now() - start;
        for (StageTime& stage : stages_) {
            if (stage.name == name) {
                stage.milliseconds += elapsed.count();
                return;
            }
        }
        stages_.push_back({name, elapsed.count()});
    }

    std::vector<StageTime> take() { return std::move(stages_); }

  private:
    compute::Backend& backend_;
    bool measure_;
    std::vector<StageTime> stages_;
};

/// What is uploaded once per line set.
struct SceneBuffers {
    std::unique_ptr<Buffer> vertices, triangles, segments, front;
    gl::Buffer gl_vertices, gl_indices;
    std::uint32_t triangle_count = 0;
    std::uint32_t segment_count = 0;

    compute::SegmentTable table() const {
        return {*vertices, *triangles, *segments, triangle_count, segment_count};
    }
    std::uint64_t segment_bytes() const {
        return vertices->size() + triangles->size() + segments->size() + front->size();
    }
};

gl::Buffer upload_gl(std::span<const std::byte> data) {
    gl::Buffer buffer = gl::Buffer::create();
    const std::byte nothing{};
    glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(std::max<std::size_t>(data.size(), 1)),
                         data.empty() ? &nothing : data.data(), 0);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        throw DeviceError("GL has no memory for a model of " + std::to_string(data.size() >> 20U) +
                          " MiB");
    }
    return buffer;
}

std::unique_ptr<Buffer> upload_compute(compute::Backend& backend, std::span<const std::byte> data) {
    std::unique_ptr<Buffer> buffer = backend.allocate(data.size());
    backend.upload(*buffer, data);
    return buffer;
}

} // namespace

class Renderer::State {
  public:
    explicit State(const DeviceOptions& options)
        : connection_(interop::connect(connect_options(options))), handover_(*connection_.backend) {
        const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        software_gl_ = std::string_view{renderer}.find("llvmpipe") != std::string_view::npos;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest_texture_);
        glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest_texture_buffer_);
        record_ = shared(sizeof(FrameRecord));
    }

    std::string description() const {
        return backend().description() + ", sharing by " +
               std::string{interop::name_of(connection_.mode)};
    }

    void set_lines(const LineSet& lines) {
        scene_ = {};
        clipped_.reset();
        offsets_.reset();
        arcs_.reset();
        scene_.vertices = upload_compute(backend(), bytes_of(lines.vertices));
        scene_.triangles = upload_compute(backend(), bytes_of(lines.triangles));
        scene_.segments = upload_compute(backend(), bytes_of(lines.segments));
        scene_.front = backend().allocate(lines.triangles.size());
        scene_.gl_vertices = upload_gl(bytes_of(lines.vertices));
        scene_.gl_indices = upload_gl(bytes_of(lines.triangles));
        scene_.triangle_count = static_cast<std::uint32_t>(lines.triangles.size());
        scene_.segment_count = static_cast<std::uint32_t>(lines.segments.size());
        const std::size_t n = lines.segments.size();
        clipped_ = shared(n * sizeof(ClippedSegment));
        offsets_ = shared((n + 1) * sizeof(std::uint32_t));
        arcs_ = backend().allocate((n + 1) * sizeof(std::uint32_t));
    }

    FrameStats draw(const Camera& camera, const FrameOptions& options, GLuint framebuffer);
    Samples read_samples();

  private:
    /// What a frame needs to know while it runs.
    struct Frame {
        const Camera& camera;
        const FrameOptions& options;
        StageClock clock;
        std::uint32_t probes;
        AtlasLayout layout;
        bool raster;
        float tolerance;
        glm::vec2 viewport;
    };

    compute::Backend& backend() const { return *connection_.backend; }
    std::unique_ptr<SharedBuffer> shared(std::size_t bytes) const {
        return interop::make_shared_buffer(*connection_.backend, connection_.mode, bytes);
    }
    compute::ClippedTable clipped_table() {
        return {clipped_->compute(), offsets_->compute(), *arcs_};
    }

    Frame begin(const Camera& camera, const FrameOptions& options);
    void draw_depth(Frame& frame);
    void project(Frame& frame);
    void sample(Frame& frame);
    void sample_raster(Frame& frame);
    void compact(Frame& frame);
    /// Enlarges what the frame's totals exceed; true if the frame must be sampled again.
    bool grow(const Frame& frame);
    void draw_strokes(Frame& frame, GLuint framebuffer);
    gl::PenTexture pen_texture(const std::string& name, float width);

    interop::Connection connection_;
    interop::Handover handover_;
    bool software_gl_ = false;
    GLint largest_texture_ = 0;
    GLint largest_texture_buffer_ = 0;
    SceneBuffers scene_;
    std::unique_ptr<SharedBuffer> clipped_, offsets_, depth_, alpha_, runs_, record_;
    std::unique_ptr<Buffer> arcs_;
    std::uint32_t sample_capacity_ = 0;
    std::uint32_t run_capacity_ = 0;
    FrameRecord totals_{};
    AtlasLayout last_layout_{1, 1};
    gl::DepthPass depth_pass_;
    gl::AtlasPass atlas_pass_;
    gl::StrokePass stroke_pass_;
    std::map<std::pair<std::string, float>, std::pair<gl::Texture2D, float>> pens_;
};

Renderer::State::Frame Renderer::State::begin(const Camera& camera, const FrameOptions& options) {
    check(options);
    const std::uint32_t probes = probes_per_axis(options.probes);
    const glm::ivec2 depth_size = camera.size * options.depth_scale;
    if (depth_size.x > largest_texture_ || depth_size.y > largest_texture_) {
        throw UsageError("a depth buffer of " + std::to_string(depth_size.x) + "x" +
                         std::to_string(depth_size.y) + " is larger than this device's limit of " +
                         std::to_string(largest_texture_) +
                         "; choose a smaller --size or --depth-scale");
    }
    const float diagonal = std::hypot(static_cast<float>(camera.size.x),
                                      static_cast<float>(camera.size.y));
    const auto longest = static_cast<std::uint32_t>(std::ceil(diagonal / options.step)) + 1;
    const AtlasLayoutKind kind = options.atlas_layout == AtlasLayoutChoice::wrap
                                     ? AtlasLayoutKind::wrap
                                     : AtlasLayoutKind::gutter;
    const AtlasLayout layout =
        make_atlas_layout(kind, longest, static_cast<std::uint32_t>(largest_texture_));
    const bool raster = options.atlas == AtlasForm::raster ||
                        (options.atlas == AtlasForm::automatic && !software_gl_);

    if (sample_capacity_ == 0 || layout.width != last_layout_.width ||
        layout.pitch != last_layout_.pitch) {
        // A first guess; the frame itself tells how much it needs.
        sample_capacity_ = std::max(sample_capacity_, 1U << 20U);
        alpha_ = shared(layout.texels(sample_capacity_));
        last_layout_ = layout;
    }
    if (!runs_) {
        run_capacity_ = 1U << 15U;
        runs_ = shared(run_capacity_ * sizeof(Run));
    }
    const std::size_t depth_bytes =
        static_cast<std::size_t>(depth_size.x) * static_cast<std::size_t>(depth_size.y) *
        sizeof(float);
    if (!raster && (!depth_ || depth_->size() < depth_bytes)) depth_ = shared(depth_bytes);

    return {.camera = camera,
            .options = options,
            .clock = StageClock{backend(), options.measure_stages},
            .probes = probes,
            .layout = layout,
            .raster = raster,
            .tolerance = depth_tolerance_pixels * depth_per_pixel(camera),
            .viewport = glm::vec2{camera.size}};
}

void Renderer::State::draw_depth(Frame& frame) {
    frame.clock("depth", [&] {
        depth_pass_.draw({.vertices = scene_.gl_vertices.id(),
                          .indices = scene_.gl_indices.id(),
                          .triangle_count = scene_.triangle_count},
                         frame.camera.clip_from_world(), frame.camera.size,
                         frame.options.depth_scale);
        if (!frame.raster) depth_pass_.copy_to(depth_->gl());
    });
}

void Renderer::State::project(Frame& frame) {
    const glm::mat4 clip_from_world = frame.camera.clip_from_world();
    frame.clock("facing", [&] {
        if ((frame.options.lines & mask_of(LineKind::silhouette)) == 0) return;
        backend().facing(
            {.table = scene_.table(), .eye = frame.camera.eye(), .front = *scene_.front});
    });
    frame.clock("project_clip", [&] {
        backend().project_clip(
            {.table = scene_.table(),
             .front = *scene_.front,
             .clip_from_world = clip_from_world,
             .world_from_clip = glm::mat4{glm::inverse(glm::dmat4{clip_from_world})},
             .viewport = frame.viewport,
             .step = frame.options.step,
             .kind_mask = frame.options.lines,
             .out = clipped_table()});
    });
    frame.clock("scan", [&] {
        backend().scan(offsets_->compute(), scene_.segment_count, compute::ScanKind::saturate);
        backend().scan(*arcs_, scene_.segment_count, compute::ScanKind::wrap);
    });
}

void Renderer::State::sample(Frame& frame) {
    if (frame.raster) return sample_raster(frame);
    frame.clock("atlas", [&] {
        backend().atlas({.clipped = clipped_table(),
                         .segment_count = scene_.segment_count,
                         .depth = depth_->compute(),
                         .depth_size = depth_pass_.size(),
                         .viewport = frame.viewport,
                         .depth_scale = static_cast<float>(frame.options.depth_scale),
                         .probes = frame.probes,
                         .tolerance = frame.tolerance,
                         .layout = frame.layout,
                         .capacity = sample_capacity_,
                         .alpha = alpha_->compute()});
    });
}

void Renderer::State::sample_raster(Frame& frame) {
    // The number of atlas rows to draw and read decides the pass's size, so the total is needed here.
    frame.clock("atlas", [&] {
        std::uint32_t total = 0;
        handover_.to_gl(
            {{*clipped_, clipped_->size()}, {*offsets_, offsets_->size()}, {*alpha_, 0}});
        glGetNamedBufferSubData(offsets_->gl(),
                                static_cast<GLintptr>(scene_.segment_count * sizeof(total)),
                                sizeof(total), &total);
        if (total <= sample_capacity_) {
            atlas_pass_.draw({.clipped = clipped_->gl(),
                              .offsets = offsets_->gl(),
                              .segment_count = scene_.segment_count},
                             {.depth = depth_pass_.texture(),
                              .viewport = frame.viewport,
                              .depth_scale = static_cast<float>(frame.options.depth_scale),
                              .probes = frame.probes,
                              .tolerance = frame.tolerance},
                             frame.layout, total, alpha_->gl());
        }
        const std::size_t drawn = total <= sample_capacity_ ? frame.layout.texels(total) : 0;
        handover_.to_compute({{*clipped_, 0}, {*offsets_, 0}, {*alpha_, drawn}});
    });
}

void Renderer::State::compact(Frame& frame) {
    frame.clock("compact", [&] {
        backend().compact_runs({.table = scene_.table(),
                                .clipped = clipped_table(),
                                .alpha = alpha_->compute(),
                                .layout = frame.layout,
                                .capacity = sample_capacity_,
                                .viewport = frame.viewport,
                                .step = frame.options.step,
                                .half_width = 0.5F * frame.options.width,
                                .runs = runs_->compute(),
                                .run_capacity = run_capacity_,
                                .record = record_->compute()});
        backend().download(record_->compute(), std::as_writable_bytes(std::span{&totals_, 1}));
    });
}

bool Renderer::State::grow(const Frame& frame) {
    bool grown = false;
    if (totals_.sample_total > sample_capacity_) {
        const std::uint64_t wanted =
            std::uint64_t{totals_.sample_total} + totals_.sample_total / 4;
        const std::uint64_t limit = static_cast<std::uint64_t>(largest_texture_buffer_) /
                                    frame.layout.pitch * frame.layout.width;
        if (totals_.sample_total > limit) {
            const bool uncountable = totals_.sample_total == 0xFFFFFFFFU;
            throw DeviceError((uncountable ? "over 4 billion"
                                           : std::to_string(totals_.sample_total)) +
                              " visibility samples are needed, this device's atlas holds " +
                              std::to_string(limit) +
                              "; use a larger --step, a smaller --size or fewer --lines kinds");
        }
        sample_capacity_ = static_cast<std::uint32_t>(std::min(wanted, limit));
        alpha_ = shared(frame.layout.texels(sample_capacity_));
        handover_.to_compute({{*alpha_, 0}});
        grown = true;
    }
    if (totals_.run_total > run_capacity_) {
        run_capacity_ = totals_.run_total + totals_.run_total / 4;
        runs_ = shared(std::size_t{run_capacity_} * sizeof(Run));
        handover_.to_compute({{*runs_, 0}});
        grown = true;
    }
    return grown;
}

gl::PenTexture Renderer::State::pen_texture(const std::string& name, float width) {
    const auto key = std::pair{name, width};
    auto found = pens_.find(key);
    if (found == pens_.end()) {
        const PenMark mark = make_pen(name, width);
        gl::Texture2D texture;
        if (mark.size.x > 0) {
            texture = gl::Texture2D::create();
            glTextureStorage2D(texture.id(), 1, GL_R8, mark.size.x, mark.size.y);
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
            glTextureSubImage2D(texture.id(), 0, 0, 0, mark.size.x, mark.size.y, GL_RED,
                                GL_UNSIGNED_BYTE, mark.coverage.data());
            glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        }
        found = pens_.emplace(key, std::pair{std::move(texture), mark.repeat_length}).first;
    }
    return {.texture = found->second.first.id(), .texels_per_repeat = found->second.second};
}

void Renderer::State::draw_strokes(Frame& frame, GLuint framebuffer) {
    frame.clock("handover", [&] {
        handover_.to_gl({{*record_, sizeof(FrameRecord)},
                         {*runs_, std::size_t{totals_.points[0]} * sizeof(Run)},
                         {*alpha_, frame.layout.texels(totals_.sample_total)}});
    });
    frame.clock("strokes", [&] {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        stroke_pass_.draw(
            {.runs = runs_->gl(), .record = record_->gl(), .alpha = alpha_->gl()},
            {.viewport = frame.viewport,
             .width = frame.options.width,
             .color = frame.options.color,
             .pen = pen_texture(frame.options.pen, frame.options.width),
             .form = frame.options.stroke_shader == StrokeShader::geometry
                         ? gl::StrokeForm::geometry_shader
                         : gl::StrokeForm::vertex_shader});
    });
}

FrameStats Renderer::State::draw(const Camera& camera, const FrameOptions& options,
                                 GLuint framebuffer) {
    if (!scene_.vertices) throw UsageError("renderer: set_lines() must come before draw()");
    Frame frame = begin(camera, options);
    handover_.to_compute({{*clipped_, 0}, {*offsets_, 0}, {*alpha_, 0}, {*runs_, 0}, {*record_, 0}});
    project(frame);
    backend().flush(); // runs while GL draws the depth
    draw_depth(frame);
    if (!frame.raster) {
        const glm::ivec2 size = depth_pass_.size();
        const std::size_t bytes =
            static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * sizeof(float);
        frame.clock("handover", [&] { handover_.to_compute({{*depth_, bytes}}); });
    }
    do {
        sample(frame);
        compact(frame);
    } while (grow(frame));
    draw_strokes(frame, framebuffer);
    handover_.to_gl({{*clipped_, 0}, {*offsets_, 0}});
    if (!frame.raster) handover_.to_gl({{*depth_, 0}});

    return {.triangles = scene_.triangle_count,
            .segments = scene_.segment_count,
            .samples = totals_.sample_total,
            .runs = totals_.run_total,
            .segment_bytes = scene_.segment_bytes() + clipped_->size() + offsets_->size() +
                             arcs_->size(),
            .sample_bytes = alpha_->size(),
            .stages = frame.clock.take()};
}

Renderer::Samples Renderer::State::read_samples() {
    Samples result;
    result.offsets.resize(std::size_t{scene_.segment_count} + 1);
    const auto offset_bytes = std::as_writable_bytes(std::span{result.offsets});
    std::vector<std::uint8_t> texels(last_layout_.texels(totals_.sample_total));
    result.runs.resize(totals_.points[0]);
    handover_.to_compute({{*offsets_, 0}, {*alpha_, 0}, {*runs_, 0}});
    backend().download(offsets_->compute(), offset_bytes);
    backend().download(alpha_->compute(), std::as_writable_bytes(std::span{texels}));
    backend().download(runs_->compute(), std::as_writable_bytes(std::span{result.runs}));
    handover_.to_gl({{*offsets_, 0}, {*alpha_, 0}, {*runs_, 0}});
    result.alpha.reserve(totals_.sample_total);
    for (std::size_t i = 0; i + 1 < result.offsets.size(); ++i) {
        const std::uint32_t l = result.offsets[i + 1] - result.offsets[i];
        if (l == 0) continue;
        const auto* first = texels.data() + last_layout_.address(result.offsets[i]);
        result.alpha.insert(result.alpha.end(), first, first + l);
    }
    return result;
}

Renderer::Renderer(const DeviceOptions& options) : state_(std::make_unique<State>(options)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

std::string Renderer::description() const { return state_->description(); }
void Renderer::set_lines(const LineSet& lines) { state_->set_lines(lines); }
FrameStats Renderer::draw(const Camera& camera, const FrameOptions& options,
                          std::uint32_t framebuffer) {
    return state_->draw(camera, options, framebuffer);
}
Renderer::Samples Renderer::read_samples() { return state_->read_samples(); }

} // namespace lineatlas
