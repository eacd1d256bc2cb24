// How a Session makes movements smooth and pictures at rest exact.
#include <glm/geometric.hpp>

#include "long_lines.hpp"
#include "session.hpp"

namespace lineatlas::viewer {
namespace {

/// A window's part in pixels of the pictures that are drawn for it.
glm::ivec2 in_pixels_of(Economy economy, glm::ivec2 size) {
    const int pixel = pixel_size(economy);
    return (size + pixel - 1) / pixel;
}

} // namespace

bool Session::can_refine() const {
    const bool due = (is_refined(settings) && !refined_) || sketch_due();
    return model_ != nullptr && due && !stale() && !navigation.gliding() && drawn_view_;
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

void Session::renew_sketch() {
    sketched_ = navigation.view(); // a sketch that fails is not tried again
    constexpr float shortest = 25; // pixels of the window
    const LineSet lines = long_lines(model_->lines, camera(), shortest);
    if (sketch_ == nullptr) sketch_ = std::make_unique<Renderer>(device_);
    sketch_->set_lines(lines);
    // The first picture makes kernels, shaders and tables. No movement should wait for them.
    FrameOptions options = frame_options(settings, 0);
    save_time(options, Economy::details, size_);
    gl::Canvas unseen{in_pixels_of(Economy::details, size_)};
    sketch_->draw(make_camera(navigation.view(), unseen.size(), lines.bounds), options,
                  unseen.framebuffer());
}

void Session::note_duration(double seconds) {
    if (tells_pace_) pace_.note(economy_, seconds);
}

glm::ivec2 Session::size_of_pictures() const {
    return in_pixels_of(economy_, size_);
}

} // namespace lineatlas::viewer
