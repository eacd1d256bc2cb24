#include "drawer.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "assembling.hpp"
#include "compute/choose_device.hpp"
#include "core/corner_normals.hpp"
#include "core/line_pens.hpp"
#include "images/pixels.hpp"
#include "io/pen_images.hpp"
#include "lineatlas/error.hpp"
#include "process.hpp"

namespace lineatlas::python {

namespace {

/// Rounds values of 16 bits to 8 bits.
std::vector<std::uint8_t> to_bytes(std::span<const std::byte> values) {
    const auto* value = reinterpret_cast<const std::uint16_t*>(values.data());
    std::vector<std::uint8_t> bytes(values.size() / sizeof(std::uint16_t));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>((*value++ + 128) / 257);
    return bytes;
}

/// The part's mesh with positions relative to the origin of `other`.
Mesh mesh_beside(const Model& part, const Model& other) {
    Mesh mesh = part.mesh;
    const auto [x, y, z] = part.origin;
    const auto [other_x, other_y, other_z] = other.origin;
    const glm::dvec3 shift = glm::dvec3{x, y, z} - glm::dvec3{other_x, other_y, other_z};
    if (shift == glm::dvec3{0}) return mesh;
    for (glm::vec3& position : mesh.positions) position = glm::dvec3{position} + shift;
    for (PlacedSurface& surface : mesh.surfaces.surfaces) surface.model_from_shape[3] += shift;
    for (std::optional<EdgeCurve>& curve : mesh.edge_curves)
        if (curve) curve->center += shift;
    return mesh;
}

} // namespace

ModelLines find_lines(std::shared_ptr<const Model> model, const LineOptions& options,
                      const Progress& progress) {
    LineSet lines = extract_lines(model->mesh, options, progress);
    return {std::move(model), std::move(lines), options};
}

/// Gives this thread the drawer until the destructor. If the drawer has a renderer, the renderer's
/// context is current meanwhile.
class Drawer::InUse {
  public:
    explicit InUse(const Drawer& drawer) : lock_(drawer.lock()) {
        if (!drawer.state_) throw UsageError("the renderer is closed");
        if (drawer.state_->pictures) take(drawer);
    }
    /// The same, and makes the renderer if there is none.
    InUse(Drawer& drawer, Pictures*& pictures) : InUse(drawer) {
        if (!drawer.state_->pictures) {
            keeper_.emplace(); // before another context becomes current
            drawer.make_pictures();
        }
        pictures = drawer.state_->pictures.get();
    }

  private:
    void take(const Drawer& drawer) {
        keeper_.emplace();
        drawer.state_->pictures->context.make_current();
    }

    std::unique_lock<std::mutex> lock_;
    std::optional<gl::CurrentContextKeeper> keeper_;
};

Drawer::Drawer(ModelLines subject, const DeviceOptions& device)
    : made_(std::make_shared<ModelLines>(std::move(subject))), subject_(made_) {
    enter_drivers();
    if (device.interop.empty()) {
        compute::find_device(device); // throws if there is no such device
        state_ = std::make_unique<State>(State{device});
        return;
    }
    // A sharing mode can only be checked with GL, so the renderer is made at once.
    const gl::CurrentContextKeeper keeper;
    state_ = std::make_unique<State>(State{device});
    make_pictures();
}

Drawer::~Drawer() {
    close();
}

Drawer::Pictures& Drawer::make_pictures() {
    auto pictures = std::make_unique<Pictures>(state_->device);
    state_->visibility.reset(); // frees the device's memory for the renderer
    if (assembly_)
        pictures->renderer.set_lines(*assembly_);
    else
        pictures->renderer.set_lines(made_->lines);
    place(pictures->renderer, placement_);
    state_->pictures = std::move(pictures);
    return *state_->pictures;
}

LineVisibility& Drawer::make_visibility() {
    if (!state_->visibility)
        state_->visibility = std::make_unique<LineVisibility>(subject_->lines, state_->device);
    return *state_->visibility;
}

/// Locks the mutex. enter_drivers() comes first: after a fork, a thread that no longer exists may
/// hold the mutex.
std::unique_lock<std::mutex> Drawer::lock() const {
    enter_drivers();
    return std::unique_lock{mutex_};
}

bool Drawer::is_changed() const {
    const std::unique_lock held = lock();
    return subject_ != made_;
}

DeviceOptions Drawer::device() const {
    const std::unique_lock held = lock();
    if (!state_) throw UsageError("the renderer is closed");
    DeviceOptions device = state_->device;
    device.interop.clear();
    return device;
}

void Drawer::close() {
    if (has_lost_drivers()) {
        static_cast<void>(state_.release()); // leaked, because destructors would wait for drivers
        return;
    }
    const std::unique_lock held = lock();
    if (!state_) return;
    if (state_->pictures) {
        const gl::CurrentContextKeeper keeper;
        state_->pictures->context.make_current();
        state_->pictures.reset();
    }
    state_.reset();
}

void Drawer::set_subject(ModelLines subject) {
    const InUse use{*this};
    if (state_->pictures)
        state_->pictures->renderer.set_lines(subject.lines);
    else if (state_->visibility)
        state_->visibility->set_lines(subject.lines);
    made_ = subject_ = std::make_shared<ModelLines>(std::move(subject));
    placement_ = {};
    assembly_.reset();
}

/// The lines at their places of now, for code that knows no placements.
std::shared_ptr<const ModelLines> Drawer::placed(const Placement& placement) const {
    auto result = std::make_shared<ModelLines>(*made_);
    LineSet& lines = result->lines;
    if (!placement.vertices.empty()) {
        lines.vertices = placement.vertices;
        lines.bounds = placement.bounds;
        find_normals(lines);
    }
    if (!placement.transforms.empty()) move_objects(lines, placement.transforms);
    if (!placement.hidden.empty()) hide_objects(lines, placement.hidden);
    return result;
}

void Drawer::place(Renderer& renderer, const Placement& placement) {
    if (!placement.vertices.empty()) renderer.set_positions(0, placement.vertices);
    if (!placement.transforms.empty()) renderer.set_transforms(placement.transforms);
    if (!placement.hidden.empty()) renderer.set_hidden(placement.hidden);
}

void Drawer::set_transforms(std::vector<glm::mat4> world_from_object) {
    const InUse use{*this};
    Placement next = placement_;
    next.transforms = std::move(world_from_object);
    std::shared_ptr<const ModelLines> moved = placed(next); // may throw
    if (state_->pictures) state_->pictures->renderer.set_transforms(next.transforms);
    take(std::move(next), std::move(moved));
}

void Drawer::set_positions(std::span<const glm::vec3> positions) {
    const InUse use{*this};
    if (assembly_) {
        throw UsageError("positions: parts were added or removed; make a new Renderer of the "
                         "whole to change its shape");
    }
    LineSet shape; // only the members that move_vertices() needs
    shape.vertices = made_->lines.vertices;
    shape.vertex_sources = made_->lines.vertex_sources;
    shape.cut_vertices = made_->lines.cut_vertices;
    move_vertices(shape, positions);
    Placement next = placement_;
    next.vertices = std::move(shape.vertices);
    next.bounds = shape.bounds;
    std::shared_ptr<const ModelLines> moved = placed(next);
    if (state_->pictures) state_->pictures->renderer.set_positions(0, next.vertices);
    take(std::move(next), std::move(moved));
}

void Drawer::set_hidden(std::vector<std::uint32_t> objects) {
    const InUse use{*this};
    Placement next = placement_;
    next.hidden = std::move(objects);
    std::shared_ptr<const ModelLines> moved = placed(next);
    if (state_->pictures) state_->pictures->renderer.set_hidden(next.hidden);
    take(std::move(next), std::move(moved));
}

void Drawer::take(Placement next, std::shared_ptr<const ModelLines> moved) {
    if (state_->visibility) state_->visibility->set_lines(moved->lines);
    placement_ = std::move(next);
    subject_ = std::move(moved);
}

void Drawer::start_assembly() {
    if (assembly_) return;
    if (!placement_.vertices.empty()) {
        throw UsageError("parts come and go only while positions are those of the model; make a "
                         "new Renderer of what has changed its shape");
    }
    Assembly assembly;
    assembly.add(made_->lines);
    assembly_.emplace(std::move(assembly));
    if (state_->pictures) {
        state_->pictures->renderer.set_lines(*assembly_);
        place(state_->pictures->renderer, placement_);
    }
}

std::vector<std::uint32_t> Drawer::add(const Model& part, const Progress& progress) {
    const std::shared_ptr<const ModelLines> before = subject();
    const Mesh mesh = mesh_beside(part, *before->model);
    LineSet lines = extract_lines(mesh, before->options, progress);
    const InUse use{*this};
    start_assembly();
    auto model = std::make_shared<Model>(*made_->model);
    shift_sources(lines, static_cast<std::uint32_t>(model->mesh.positions.size()),
                  static_cast<std::uint32_t>(model->mesh.triangles.size()));
    append(model->mesh, mesh);
    std::vector<std::uint32_t> numbers = assembly_->add(lines);
    take_parts(std::move(model), numbers);
    return numbers;
}

void Drawer::remove(std::uint32_t object) {
    const InUse use{*this};
    const std::size_t count = std::max<std::size_t>(made_->lines.objects.size(), 1);
    if (object >= count) {
        throw UsageError("there is no object " + std::to_string(object) + " to remove, but " +
                         std::to_string(count));
    }
    start_assembly();
    assembly_->remove(object);
    take_parts(made_->model, std::span{&object, 1});
}

void Drawer::take_parts(std::shared_ptr<const Model> model,
                        std::span<const std::uint32_t> changed) {
    made_ = std::make_shared<ModelLines>(
        ModelLines{std::move(model), assembly_->lines(), made_->options});
    Placement next = placement_;
    if (!next.transforms.empty()) {
        next.transforms.resize(made_->lines.objects.size(), glm::mat4{1});
        for (const std::uint32_t object : changed) next.transforms[object] = glm::mat4{1};
    }
    std::erase_if(next.hidden, [&](std::uint32_t object) {
        return std::ranges::find(changed, object) != changed.end();
    });
    if (state_->pictures) state_->pictures->renderer.set_lines(*assembly_);
    std::shared_ptr<const ModelLines> moved = placed(next);
    take(std::move(next), std::move(moved));
}

std::optional<Pick> Drawer::pick(const Camera& camera, glm::vec2 position, float radius,
                                 std::shared_ptr<const ModelLines>& of) {
    const InUse use{*this};
    of = subject_;
    return state_->pictures ? state_->pictures->renderer.pick(camera, position, radius)
                            : make_visibility().pick(camera, position, radius);
}

std::shared_ptr<const ModelLines> Drawer::subject() const {
    const std::unique_lock held = lock();
    return subject_;
}

std::string Drawer::description() {
    const InUse use{*this};
    return state_->pictures ? state_->pictures->renderer.description()
                            : make_visibility().description();
}

std::string Drawer::take_note() {
    const InUse use{*this};
    std::string note = state_->pictures ? state_->pictures->renderer.note() : std::string{};
    if (note == state_->told) return {};
    state_->told = note;
    return note;
}

void Drawer::set_pens(Pictures& pictures, const Style& style) {
    for (auto& [mark, image] : read_pen_images(style, pictures.known_pens)) {
        pictures.known_pens.insert(mark);
        pictures.renderer.set_pen_image(mark, std::move(image));
    }
}

gl::Canvas& Drawer::canvas(Pictures& pictures, glm::ivec2 size, int bits) {
    std::unique_ptr<gl::Canvas>& canvas = pictures.canvas;
    if (!canvas || canvas->size() != size || canvas->bits() != bits) {
        canvas.reset(); // frees memory for the next canvas
        canvas = std::make_unique<gl::Canvas>(size, bits);
    }
    return *canvas;
}

namespace {

/// The kinds of line that the caller asked for. They are drawn whatever the style says.
std::optional<LineKindMask> asked_kinds(const ModelLines& subject) {
    const LineKindMask kinds = subject.options.lines;
    return kinds != all_line_kinds ? std::optional{kinds} : std::nullopt;
}

} // namespace

void Drawer::prepare(const FrameOptions& options, const Progress& progress) {
    Pictures* pictures = nullptr;
    const InUse use{*this, pictures};
    pictures->renderer.prepare(options, progress);
}

Picture Drawer::draw(const Camera& camera, FrameOptions options, bool transparent) {
    Pictures* pictures = nullptr;
    const InUse use{*this, pictures};
    options.lines = asked_kinds(*subject_);
    set_pens(*pictures, options.style);
    // Colours are divided by alpha. If alpha is small, that needs more than the result's 8 bits.
    gl::Canvas& target = canvas(*pictures, camera.size, transparent ? 16 : 8);
    target.clear(transparent ? glm::vec4{0} : glm::vec4{options.style.paper.color, 1});
    const FrameStats stats = pictures->renderer.draw(camera, options, target.framebuffer());
    const bool counted = options.method == Method::atlas || options.method == Method::exact ||
                         options.method == Method::item_buffer;
    std::optional<bool> shows_lines;
    if (counted && (stats.runs > 0 || !options.style.hidden)) shows_lines = stats.runs > 0;
    std::vector<std::uint8_t> values = target.read();
    if (!transparent) return {std::move(values), shows_lines};
    const Pixels pixels{.size = camera.size,
                        .channels = 4,
                        .bits = 16,
                        .premultiplied = true,
                        .values = std::as_bytes(std::span{values})};
    return {to_bytes(straight(pixels)), shows_lines};
}

FoundIntervals Drawer::intervals(const Camera& camera, FrameOptions options, bool hidden,
                                 const Progress& progress) {
    options.lines = asked_kinds(*subject());
    if (options.method == Method::exact) {
        const InUse use{*this};
        if (!state_->pictures) {
            const VisibilityOptions wanted{
                .lines = drawn_kinds(options.lines, options.style),
                .hidden = hidden,
                .step = options.step,
                .outlines = tells_outlines(options.style),
                .outline_depth = outline_depth(options.style, camera.size),
                .centre_overhang = centre_overhang(options.style, camera.size)};
            LineVisibility& visibility = make_visibility();
            std::vector<Interval> found = visibility.find(camera, wanted, progress);
            return {subject_, std::move(found), visibility.outlines()};
        }
    }
    Pictures* pictures = nullptr;
    const InUse use{*this, pictures};
    options.intervals = hidden ? KeptIntervals::all : KeptIntervals::visible;
    options.draw = false;
    pictures->renderer.draw(camera, options, 0);
    return {subject_, pictures->renderer.read_intervals(), pictures->renderer.read_outlines()};
}

} // namespace lineatlas::python
