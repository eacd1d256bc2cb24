#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "lineatlas/camera.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas::viewer {

/// Pictures of a moving camera, drawn one at a time.
class Recording {
  public:
    /// Pictures go to `folder`, an existing empty folder, as 0000.png and so on.
    Recording(std::vector<View> views, std::filesystem::path folder)
        : views_(std::move(views)), folder_(std::move(folder)) {}

    std::size_t count() const { return views_.size(); }
    std::size_t drawn() const { return drawn_; }
    bool done() const { return drawn_ == views_.size(); }
    const std::filesystem::path& folder() const { return folder_; }

    const View& view() const { return views_.at(drawn_); } ///< view of the next picture
    std::filesystem::path path() const;                    ///< file of the next picture
    void next() { ++drawn_; }

  private:
    std::vector<View> views_;
    std::filesystem::path folder_;
    std::size_t drawn_ = 0;
};

/// A turn about the vertical through the middle of the model.
std::vector<View> turntable_views(const View& view, const Bounds& bounds, int frames);
/// About `frames` views on a smooth way through at least two given views.
std::vector<View> views_between(std::span<const View> views, int frames);

/// A new folder in `parent`: `stem`, or the first that is free of `stem`-2 and so on. Throws
/// FileError.
std::filesystem::path make_free_folder(const std::filesystem::path& parent,
                                       const std::string& stem);

/// Makes a video of a recording's folder, beside it, if `ffmpeg` is installed. Returns its path, or
/// an empty one without ffmpeg and if `goes_on` says no, which is asked all the time. Throws Error.
std::filesystem::path make_video(const std::filesystem::path& folder,
                                 const std::function<bool()>& goes_on);

} // namespace lineatlas::viewer
