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
    });
}

std::optional<std::filesystem::path> Session::record_picture() {
    if (!recording_) return {};
    FrameOptions options = frame_options(settings, 0);
    options.steady = false;
    const bool drawn = attempt([&] {
        drawing_.run([&] {
            save({.model = *model_, .view = recording_->view(), .size = size_, .options = options},
                 recording_->path(), *renderer_, writer_);
        });
    });
    changed(); // the renderer's last frame is not that of the window any more
    if (!drawn) {
        recording_.reset();
        return {};
    }
    recording_->next();
    if (!recording_->done()) return {};
    const std::filesystem::path folder = recording_->folder();
    messages.notice(fmt::format("Saved {} pictures in {}", recording_->count(), folder.string()));
    recording_.reset();
    return folder;
}

void Session::cancel_recording() {
    if (!recording_) return;
    messages.notice(
        fmt::format("{} pictures are in {}", recording_->drawn(), recording_->folder().string()));
    recording_.reset();
}

void Session::make_video_of(const std::filesystem::path& folder) {
    attempt([&] {
        const std::filesystem::path video = make_video(folder);
        if (!video.empty()) messages.notice("Saved " + video.string());
    });
}

} // namespace lineatlas::viewer
