// Pictures of a moving camera that a Session draws.
#include <utility>

#include <fmt/format.h>

#include "saving.hpp"
#include "session.hpp"

namespace lineatlas::viewer {

void Session::start_recording(Move move, const std::filesystem::path& folder, int frames) {
    if (model_ == nullptr || recording_) return;
    std::vector<View> kept;
    for (const SessionFile::NamedView& view : settings.bookmarks)
        kept.push_back(view_of(view, origin()));
    if (move == Move::kept_views && kept.size() < 2)
        return messages.notice("Keep two views at least (B): the camera goes from one to the next");
    attempt([&] {
        recording_.emplace(move == Move::turntable
                               ? turntable_views(navigation.goal(), model_->lines.bounds, frames)
                               : views_between(kept, frames),
                           make_free_folder(folder, model_->source.stem() + "-pictures"));
        ++recordings_;
    });
}

void Session::record_picture() {
    if (!recording_ || drawing()) return;
    FrameOptions options = frame_options(settings, 0);
    options.steady = false;
    const auto work = [this, model = model_, view = recording_->view(), size = size_, options,
                       path = recording_->path()] {
        give_lines(model);
        save({.model = *model, .view = view, .size = size, .options = options}, path, *renderer_,
             writer_);
    };
    const auto then = [this, number = recordings_](bool worked) {
        changed(); // the renderer's last frame is not that of the window any more
        if (!recording_ || number != recordings_) return; // it was stopped
        if (worked) recording_->next();
        if (worked && !recording_->done()) return;
        const Recording done = *std::exchange(recording_, std::nullopt);
        if (!worked) return;
        messages.notice(
            fmt::format("Saved {} pictures in {}", done.count(), done.folder().string()));
        make_video_of(done.folder());
    };
    add_task({.work = work, .then = then});
}

void Session::cancel_recording() {
    if (!recording_) return;
    messages.notice(
        fmt::format("{} pictures are in {}", recording_->drawn(), recording_->folder().string()));
    recording_.reset();
}

void Session::make_video_of(const std::filesystem::path& folder) {
    const auto video = std::make_shared<std::filesystem::path>();
    const auto then = [this, video](bool worked) {
        if (worked && !video->empty()) messages.notice("Saved " + video->string());
    };
    stops_video_ = false;
    const auto work = [this, video, folder] {
        *video = make_video(folder, [this] { return !stops_video_ && !ends_; });
    };
    add_task({.what = video_work, .work = work, .then = then});
}

} // namespace lineatlas::viewer
