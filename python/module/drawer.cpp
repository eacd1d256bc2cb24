#include "drawer.hpp"

#include <utility>

#include "images/pixels.hpp"
#include "io/pen_images.hpp"
#include "lineatlas/error.hpp"
#include "process.hpp"

namespace lineatlas::python {

namespace {

/// From 16 bits to 8, rounded.
std::vector<std::uint8_t> to_bytes(std::span<const std::byte> values) {
    const auto* value = reinterpret_cast<const std::uint16_t*>(values.data());
    std::vector<std::uint8_t> bytes(values.size() / sizeof(std::uint16_t));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>((*value++ + 128) / 257);
    return bytes;
}

} // namespace

ModelLines find_lines(std::shared_ptr<const Model> model, const LineOptions& options) {
    LineSet lines = extract_lines(model->mesh, options);
    return {std::move(model), std::move(lines), options.kinds};
}

/// From here to its end this thread has the drawer, and the drawer's context is current.
class Drawer::InUse {
  public:
    explicit InUse(const Drawer& drawer) : lock_(drawer.lock()) {
        if (!drawer.state_) throw UsageError("the renderer is closed");
        drawer.state_->context.make_current();
    }

  private:
    std::unique_lock<std::mutex> lock_;
    gl::CurrentContextKeeper keeper_;
};

Drawer::Drawer(ModelLines subject, const DeviceOptions& device)
    : subject_(std::make_shared<ModelLines>(std::move(subject))) {
    enter_drivers();
    const gl::CurrentContextKeeper keeper;
    state_ = std::make_unique<State>(device);
    state_->renderer.set_lines(subject_->lines);
}

Drawer::~Drawer() {
    close();
}

/// Checked first: a thread that the fork has left behind may have had the mutex.
std::unique_lock<std::mutex> Drawer::lock() const {
    enter_drivers();
    return std::unique_lock{mutex_};
}

void Drawer::close() {
    if (has_lost_drivers()) {
        static_cast<void>(state_.release()); // to take it apart would wait for drivers
        return;
    }
    const std::unique_lock held = lock();
    if (!state_) return;
    const gl::CurrentContextKeeper keeper;
    state_->context.make_current();
    state_.reset();
}

void Drawer::set_subject(ModelLines subject) {
    const InUse use{*this};
    state_->renderer.set_lines(subject.lines);
    subject_ = std::make_shared<ModelLines>(std::move(subject));
}

std::shared_ptr<const ModelLines> Drawer::subject() const {
    const std::unique_lock held = lock();
    return subject_;
}

std::string Drawer::description() {
    const InUse use{*this};
    return state_->renderer.description();
}

std::string Drawer::note() {
    const InUse use{*this};
    return state_->renderer.note();
}

void Drawer::set_pens(const Style& style) {
    for (auto& [mark, image] : read_pen_images(style, state_->known_pens)) {
        state_->known_pens.insert(mark);
        state_->renderer.set_pen_image(mark, std::move(image));
    }
}

gl::Canvas& Drawer::canvas(glm::ivec2 size, int bits) {
    std::optional<gl::Canvas>& canvas = state_->canvas;
    if (!canvas || canvas->size() != size || canvas->bits() != bits) {
        canvas.reset(); // before the next one takes memory
        canvas.emplace(size, bits);
    }
    return *canvas;
}

Picture Drawer::draw(const Camera& camera, const FrameOptions& options, bool transparent) {
    const InUse use{*this};
    set_pens(options.style);
    // Colours divided by a small alpha need more than the 8 bits that are left in the end.
    gl::Canvas& target = canvas(camera.size, transparent ? 16 : 8);
    target.clear(transparent ? glm::vec4{0} : glm::vec4{options.style.paper.color, 1});
    const FrameStats stats = state_->renderer.draw(camera, options, target.framebuffer());
    const bool counted = options.method == Method::atlas || options.method == Method::item_buffer;
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

FoundIntervals Drawer::intervals(const Camera& camera, FrameOptions options, bool hidden) {
    const InUse use{*this};
    options.intervals = hidden ? KeptIntervals::all : KeptIntervals::visible;
    options.draw = false;
    state_->renderer.draw(camera, options, 0);
    return {subject_, state_->renderer.read_intervals()};
}

} // namespace lineatlas::python
