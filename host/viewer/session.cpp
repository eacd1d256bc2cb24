#include "session.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "cameras/camera_path.hpp"
#include "command_line/style_options.hpp"
#include "io/extension.hpp"
#include "io/isolated.hpp"
#include "io/pen_images.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/style_files.hpp"
#include "saving.hpp"
#include "style/member_names.hpp"

namespace lineatlas::viewer {
namespace {

bool same(const View& a, const View& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up && a.fov_y == b.fov_y &&
           a.projection == b.projection;
}

} // namespace

Session::Session(const DeviceOptions& device, ImageWriter& writer, std::function<void()> wake)
    : loader(std::move(wake)), writer_(writer), device_(device) {
    if (attempt([&] { renderer_ = std::make_unique<Renderer>(device_); })) return;
    device_ = {.compute = "cpp"}; // needs nothing
    renderer_ = std::make_unique<Renderer>(device_);
}

/// Tells of what fails.
bool Session::attempt(const std::function<void()>& action) {
    try {
        action();
        return true;
    } catch (const std::bad_alloc&) {
        messages.error("There is not enough memory for that");
    } catch (const std::exception& error) {
        messages.error(in_words_of_the_tool(error.what()));
    }
    return false;
}

void Session::open(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    if (extension == ".toml") return use_style(file.string());
    if (extension == ".json") return open_camera(file);
    loader.start({.file = file, .scene = {}, .up = up, .lines = line_options, .read = read_limits});
}

void Session::open_scene(const std::string& name) {
    loader.start({.file = {}, .scene = name, .up = glm::vec3{0, 1, 0}, .lines = line_options});
}

void Session::open_camera(const std::filesystem::path& file) {
    attempt([&] {
        const CameraPath path{file, navigation.goal(), origin()};
        navigation.glide_to(path.view(path.first_frame()));
    });
}

void Session::open_first_camera(const std::filesystem::path& file) {
    attempt([&] {
        const CameraPath checked{file, View{.up = up.value_or(glm::vec3{0, 1, 0})}};
        first_camera_ = file;
    });
}

/// Once, when the model is there whose origin its points are taken about.
std::optional<View> Session::take_first_camera() {
    std::optional<View> view;
    const std::filesystem::path file = std::exchange(first_camera_, {});
    if (file.empty()) return view;
    attempt([&] {
        const CameraPath path{file, View{.up = up.value_or(glm::vec3{0, 1, 0})}, origin()};
        view = path.view(path.first_frame());
    });
    return view;
}

glm::dvec3 Session::origin() const {
    return model_ ? model_->origin : glm::dvec3{0};
}

void Session::load_pens(const Style& style) {
    const auto read = [&](const auto& path) { return read_image_isolated(path, read_limits); };
    for (const auto& [mark, image] : read_pen_images(style, {}, read)) {
        renderer_->set_pen_image(mark, image);
    }
}

void Session::use_style(const std::string& name) {
    attempt([&] {
        const Style style = name.empty() ? Style{} : load_style(name);
        load_pens(style);
        settings.style = style;
        settings.style_name = name;
        changed();
    });
}

void Session::use_device(const DeviceOptions& device) {
    attempt([&] {
        renderer_->set_device(device);
        device_ = device;
        timings.clear();
        timings_due_ = 0;
        changed();
    });
}

std::string Session::device_description() const {
    const std::string note = renderer_->note();
    return renderer_->description() + (note.empty() ? "" : "; " + note);
}

void Session::show(std::shared_ptr<Model> model) {
    const bool done = attempt([&] {
        renderer_->set_lines(model->lines);
        model_ = model;
    });
    if (!done) return;
    const glm::ivec2 size = glm::max(size_, 1);
    const auto framed = [&] {
        return frame_points(model_->lines.vertices, size, *model_->source.up);
    };
    std::optional<View> first = take_first_camera();
    if (!first) first = model_->view ? *model_->view : framed();
    navigation.set_view(*first);
    for (const std::string& note : model_->notes) messages.notice(note);
    timings.clear();
    changed();
}

void Session::glide_to(StandardView view) {
    if (model_ == nullptr) return;
    const glm::vec3 up_axis = *model_->source.up;
    const View& now = navigation.view();
    navigation.glide_to(frame_points_from({direction_to(view, up_axis), up_axis},
                                          model_->lines.vertices, glm::max(size_, 1), now.fov_y,
                                          now.projection));
}

void Session::toggle_projection() {
    const bool parallel = navigation.goal().projection == Projection::orthographic;
    navigation.set_projection(parallel ? Projection::perspective : Projection::orthographic);
    changed();
}

void Session::fit() {
    if (model_ == nullptr) return;
    const View& view = navigation.goal();
    navigation.glide_to(frame_points_from({glm::normalize(view.eye - view.target), view.up},
                                          model_->lines.vertices, glm::max(size_, 1), view.fov_y,
                                          view.projection));
}

glm::dvec3 Session::point_at(glm::dvec2 point) const {
    if (model_ == nullptr) return {};
    const Ray ray = ray_at(navigation.view(), point, size_);
    const glm::dvec3 centre = 0.5F * (model_->lines.bounds.min + model_->lines.bounds.max);
    return pick(model_->lines, ray).value_or(centre);
}

Camera Session::camera() const {
    return make_camera(navigation.view(), size_, model_->lines.bounds);
}

bool Session::save_picture(const std::filesystem::path& path, int scale) {
    if (model_ == nullptr) return false;
    return attempt([&] {
        save({.model = *model_,
              .view = navigation.goal(),
              .size = size_ * scale,
              .options = frame_options(settings, 0)},
             path, *renderer_, writer_);
        messages.notice("Saved " + path.string());
        changed(); // the renderer's last frame was another one
    });
}

bool Session::save_style(const std::filesystem::path& path) {
    return attempt([&] {
        save_text(write_style(settings.style), path);
        messages.notice("Saved " + path.string());
    });
}

bool Session::save_camera(const std::filesystem::path& path) {
    return attempt([&] {
        save_text(camera_file(navigation.goal(), origin()), path);
        messages.notice("Saved " + path.string());
    });
}

void Session::resize(glm::ivec2 pixels) {
    if (pixels == size_) return;
    size_ = pixels;
    changed();
}

void Session::advance(double seconds) {
    messages.advance(seconds);
    navigation.advance(seconds);
    std::optional<Loader::Result> result = loader.take();
    if (!result) return;
    if (auto* model = std::get_if<std::shared_ptr<Model>>(&*result))
        show(std::move(*model));
    else
        messages.error(std::get<std::string>(*result));
}

bool Session::stale() const {
    if (model_ == nullptr || size_.x <= 0 || size_.y <= 0) return false;
    return stale_ || (moving_ && settings.steady) || !drawn_view_ ||
           !same(*drawn_view_, navigation.view());
}

void Session::draw_side(std::size_t side, const Camera& camera) {
    std::unique_ptr<gl::Canvas>& canvas = canvases_.at(side);
    if (canvas == nullptr || canvas->size() != size_) canvas = std::make_unique<gl::Canvas>(size_);
    canvas->clear({settings.style.paper.color, 1});
    FrameOptions options = frame_options(settings, side);
    options.steady = options.steady && moving_; // at rest nothing of the frames before is left
    options.profile = profile && side == 0;     // two methods in one graph would be none
    const FrameStats stats = renderer_->draw(camera, options, canvas->framebuffer());
    if (side == 0) stats_ = stats;
    if (options.profile) ++timings_due_;
}

void Session::draw() {
    moving_ = drawn_view_ && !same(*drawn_view_, navigation.view());
    stale_ = false;
    drawn_view_ = navigation.view();
    attempt([&] {
        const Camera seen = camera();
        if (settings.split) draw_side(1, seen);
        draw_side(0, seen);
    });
    if (!settings.split) canvases_[1].reset();
    ++frames_drawn_;
}

bool Session::take_timings() {
    if (timings_due_ == 0) return false;
    const std::vector<FrameProfile> frames = renderer_->take_profiles(false);
    for (const FrameProfile& frame : frames) timings_due_ -= 1 + static_cast<int>(frame.dropped);
    timings_due_ = std::max(timings_due_, 0);
    timings.add(frames);
    return !frames.empty();
}

} // namespace lineatlas::viewer
