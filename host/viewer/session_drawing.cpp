// How a Session draws pictures: it begins them, the drawing thread draws them, and the Session
// shows them when they are done. Movements are smooth, and pictures at rest exact.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/style_lengths.hpp"
#include "freed_memory.hpp"
#include "long_lines.hpp"
#include "session.hpp"

namespace lineatlas::viewer {
namespace {

/// The size of a picture for `size` pixels of the window.
glm::ivec2 in_pixels_of(Economy economy, glm::ivec2 size) {
    const int pixel = pixel_size(economy);
    return (size + pixel - 1) / pixel;
}

/// Where a place is seen, in pixels from the lower left corner, and how many pixels a unit there
/// has.
struct Seen {
    glm::dvec2 at;
    double scale;
};
Seen seen(const View& view, glm::ivec2 size, glm::dvec3 place) {
    const glm::dvec3 eye{view.eye}, to_target = glm::dvec3{view.target} - eye;
    const glm::dvec3 forward = glm::normalize(to_target);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3{view.up}));
    const glm::dvec3 up = glm::cross(right, forward);
    const glm::dvec3 way = place - eye;
    const bool parallel = view.projection == Projection::orthographic;
    const double depth = parallel ? glm::length(to_target) : glm::dot(way, forward);
    const double scale = size.y / (2 * std::tan(0.5 * view.fov_y) * depth);
    return {0.5 * glm::dvec2{size} + scale * glm::dvec2{glm::dot(way, right), glm::dot(way, up)},
            scale};
}

/// A canvas of the picture's size, all paper.
gl::Canvas& cleared(std::unique_ptr<gl::Canvas>& canvas, glm::ivec2 size, glm::vec3 paper) {
    if (canvas == nullptr || canvas->size() != size) canvas = std::make_unique<gl::Canvas>(size);
    canvas->clear({paper, 1});
    return *canvas;
}

/// Whether two models are one file, perhaps with other parts or cuts.
bool is_of_same_file(const Model* a, const Model* b) {
    return a != nullptr && b != nullptr && a->whole == b->whole;
}

} // namespace

Session::Placement Session::placement() const {
    const Placement whole{{0, 0}, glm::dvec2{size_}, false};
    if (shown_.window == glm::ivec2{0}) return whole;
    const bool same_size = shown_.window == size_;
    if (same_size && same(shown_.view, navigation.view())) return whole;
    const glm::dvec3 target{navigation.view().target};
    const Seen then = seen(shown_.view, shown_.window, target);
    const Seen now = seen(navigation.view(), size_, target);
    const double growth = now.scale / then.scale;
    if (!(growth > 0.01 && growth < 100)) return whole; // the target was behind the camera
    const glm::dvec2 low = now.at - growth * then.at;
    return {low, low + growth * glm::dvec2{shown_.window}, true};
}

void Session::draw() {
    auto picture = std::make_unique<Picture>();
    picture->view = navigation.view();
    picture->window = size_;
    picture->model = model_;
    moving_ = drawn_view_ && !same(*drawn_view_, navigation.view());
    const bool rests = std::exchange(refine_due_, false) && !moving_ && !stale_;
    picture->refined = rests && is_refined(settings);
    picture->stays = rests && !picture->refined;
    picture->tells_pace = !rests;
    picture->split = settings.split;
    stale_ = outdated_ = false;
    drawn_view_ = navigation.view();
    const bool has_sketch = sketch_ != nullptr && sketched_;
    const Economy suits = pace_.choose(frame_options(settings, 0), has_sketch);
    picture->economy = moving_ ? suits : Economy::none;
    if (!rests) refine_failed_ = false;
    if (rests && sketch_due()) {
        sketched_ = navigation.view(); // a sketch that fails is not tried again
        picture->renews_sketch = true;
    }
    for (std::size_t side = 0; side < picture->options.size(); ++side) {
        FrameOptions& options = picture->options.at(side) = frame_options(settings, side);
        save_time(options, picture->economy, size_);
        options.style = about_origin(options.style, origin());
        options.steady = options.steady && moving_; // at rest nothing of the frames before is left
        options.profile = profile && side == 0 && !rests;
    }
    picture->canvases = std::move(spare_);
    picture_ = std::move(picture);
    drawing_.start([this] { draw_picture(*picture_); });
}

/// On the drawing thread.
void Session::draw_picture(Picture& picture) {
    const auto start = std::chrono::steady_clock::now();
    try {
        give_lines(picture.model);
        picture.camera = make_camera(picture.view, in_pixels_of(picture.economy, picture.window),
                                     picture.model->lines.bounds);
        if (picture.renews_sketch) renew_sketch(picture);
        if (!picture.split) picture.canvases[1].reset();
        if (picture.refined) {
            draw_refined(picture);
        } else if (!picture.stays) {
            if (picture.split) draw_side(picture, 1);
            draw_side(picture, 0);
        }
        picture.description = describe_device();
        glFinish(); // after it the window's context sees the picture
    } catch (const Cancelled&) {
        picture.interrupted = true;
    } catch (...) {
        picture.failure = std::current_exception();
    }
    picture.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Session::draw_side(Picture& picture, std::size_t side) {
    const FrameOptions& options = picture.options.at(side);
    const gl::Canvas& canvas =
        cleared(picture.canvases.at(side), picture.camera.size, options.style.paper.color);
    Renderer& renderer = picture.economy == Economy::details ? *sketch_ : *renderer_;
    const FrameStats stats = renderer.draw(picture.camera, options, canvas.framebuffer());
    if (side == 0) picture.stats = stats;
}

/// Draws the first side by `exact`. Throws Cancelled if the picture is outdated before.
void Session::draw_refined(Picture& picture) {
    FrameOptions options = picture.options[0];
    options.method = Method::exact;
    options.steady = false;
    const glm::vec3 paper = options.style.paper.color;
    const gl::Canvas& canvas = cleared(picture.canvases[0], picture.camera.size, paper);
    picture.stats = renderer_->draw_tiles(
        picture.camera, options,
        {.framebuffer = canvas.framebuffer(),
         .tile_size = std::max(picture.window.x, picture.window.y),
         .begin = [&](const PictureTile&) { cleared(picture.canvases[0], canvas.size(), paper); },
         .end = [](const PictureTile&) {},
         .progress = [this](float) { return !outdated_; }});
}

/// On the drawing thread.
void Session::renew_sketch(const Picture& picture) {
    try {
        constexpr float shortest = 25; // pixels of the window
        const Camera window =
            make_camera(picture.view, picture.window, picture.model->lines.bounds);
        const LineSet lines = long_lines(picture.model->lines, window, shortest);
        if (sketch_ == nullptr) sketch_ = std::make_unique<Renderer>(device_);
        sketch_->set_lines(lines);
        // The first picture makes kernels, shaders and tables. No movement should wait for them.
        FrameOptions options = picture.options[0];
        save_time(options, Economy::details, picture.window);
        const gl::Canvas unseen{in_pixels_of(Economy::details, picture.window)};
        sketch_->draw(make_camera(picture.view, unseen.size(), lines.bounds), options,
                      unseen.framebuffer());
    } catch (...) {
        sketch_.reset();
        throw;
    }
}

bool Session::take_picture(std::chrono::milliseconds longest) {
    if (picture_ == nullptr || !drawing_.wait_for(longest)) return false;
    std::unique_ptr<Picture> done = std::move(picture_);
    ++frames_drawn_;
    if (done->failure) attempt([&] { std::rethrow_exception(done->failure); });
    refine_failed_ = done->failure && done->refined;
    if (!done->description.empty()) description_ = done->description;
    bool of_other_file = false;
    if (!done->failure && !done->interrupted && !done->stays) {
        of_other_file = !is_of_same_file(done->model.get(), shown_.model.get());
        if (done->options[0].profile) ++timings_due_;
        std::swap(shown_, *done);
        if (shown_.tells_pace) pace_.note(shown_.economy, shown_.seconds);
    }
    spare_ = std::move(done->canvases);
    done.reset(); // the picture before, which may be the last to have its model
    if (of_other_file) give_freed_memory_back();
    return true;
}

bool Session::refining() const {
    return refine_due_ || (picture_ != nullptr && picture_->refined);
}

bool Session::can_refine() const {
    if (model_ == nullptr || drawing() || stale() || navigation.gliding() || !drawn_view_)
        return false;
    return (is_refined(settings) && !refined() && !refine_failed_) || sketch_due();
}

/// Whether movements need a sketch that does not exist or was made for another distance.
bool Session::sketch_due() const {
    constexpr std::size_t fewest = 100'000; // smaller models are fast, or slow for another reason
    if (model_ == nullptr || model_->lines.segments.size() < fewest || !pace_.falls_short())
        return false;
    if (!sketched_) return true;
    const View &now = navigation.view(), &then = *sketched_;
    const float distance = glm::distance(now.eye, now.target);
    const float change = distance / glm::distance(then.eye, then.target);
    constexpr float much = 1.5F;
    return now.projection != then.projection || now.fov_y != then.fov_y || change > much ||
           change < 1 / much || glm::distance(now.target, then.target) > distance;
}

void Session::note_duration(double seconds) {
    pace_.note(shown_.economy, seconds);
}

} // namespace lineatlas::viewer
