#include "drawer.hpp"

#include <utility>

#include "images/pixels.hpp"
#include "io/pen_images.hpp"
#include "lineatlas/error.hpp"

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
    return {std::move(model), std::move(lines)};
}

/// From here to its end this thread has the drawer, and the drawer's context is current.
class Drawer::InUse {
  public:
    explicit InUse(const Drawer& drawer) : lock_(drawer.mutex_) {
        if (!drawer.state_) throw UsageError("the renderer is closed");
        drawer.state_->context.make_current();
    }

  private:
    std::lock_guard<std::mutex> lock_;
    gl::CurrentContextKeeper keeper_;
};

Drawer::Drawer(ModelLines subject, const DeviceOptions& device)
    : subject_(std::make_shared<ModelLines>(std::move(subject))) {
    const gl::CurrentContextKeeper keeper;
    state_ = std::make_unique<State>(device);
    state_->renderer.set_lines(subject_->lines);
}

Drawer::~Drawer() {
    close();
}

void Drawer::close() {
    const std::lock_guard lock{mutex_};
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
    const std::lock_guard lock{mutex_};
    return subject_;
}

std::string Drawer::description() {
    const InUse use{*this};
    return state_->renderer.description();
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

std::vector<std::uint8_t> Drawer::draw(const Camera& camera, const FrameOptions& options,
                                       bool transparent) {
    const InUse use{*this};
    set_pens(options.style);
    // Colours divided by a small alpha need more than the 8 bits that are left in the end.
    gl::Canvas& target = canvas(camera.size, transparent ? 16 : 8);
    target.clear(transparent ? glm::vec4{0} : glm::vec4{options.style.paper.color, 1});
    state_->renderer.draw(camera, options, target.framebuffer());
    std::vector<std::uint8_t> values = target.read();
    if (!transparent) return values;
    const Pixels pixels{.size = camera.size,
                        .channels = 4,
                        .bits = 16,
                        .premultiplied = true,
                        .values = std::as_bytes(std::span{values})};
    return to_bytes(straight(pixels));
}

FoundIntervals Drawer::intervals(const Camera& camera, FrameOptions options, bool hidden) {
    const InUse use{*this};
    options.intervals = hidden ? KeptIntervals::all : KeptIntervals::visible;
    options.draw = false;
    state_->renderer.draw(camera, options, 0);
    return {subject_, state_->renderer.read_intervals()};
}

} // namespace lineatlas::python
