#include "recording.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <unistd.h>

#include "command_line/child_process.hpp"
#include "lineatlas/camera_path.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::viewer {
namespace {

namespace fs = std::filesystem;

/// The program that a shell would run; empty if there is none.
fs::path find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders{path != nullptr ? path : ""};
    for (std::string folder; std::getline(folders, folder, ':');) {
        fs::path program = fs::path{folder} / name;
        if (!folder.empty() && ::access(program.c_str(), X_OK) == 0) return program;
    }
    return {};
}

} // namespace

fs::path Recording::path() const {
    return folder_ / fmt::format("{:04}.png", drawn_);
}

std::vector<View> turntable_views(const View& view, const Bounds& bounds, int frames) {
    const Axis axis{.point = 0.5F * (bounds.min + bounds.max),
                    .direction = glm::normalize(view.up)};
    std::vector<View> views;
    for (int i = 0; i < frames; ++i) views.push_back(turned(view, axis, double(i) / frames));
    return views;
}

std::vector<View> views_between(std::span<const View> views, int frames) {
    const int apart = std::max(frames / std::max(static_cast<int>(views.size()) - 1, 1), 1);
    std::vector<CameraPath::Key> keys;
    for (const View& view : views) keys.push_back({static_cast<double>(keys.size()) * apart, view});
    const CameraPath path{std::move(keys)};
    std::vector<View> result;
    for (int i = path.first_frame(); i <= path.last_frame(); ++i) result.push_back(path.view(i));
    return result;
}

fs::path make_free_folder(const fs::path& parent, const std::string& stem) {
    fs::path folder = parent / stem;
    std::error_code failure;
    for (int number = 2; fs::exists(folder, failure); ++number)
        folder = parent / fmt::format("{}-{}", stem, number);
    if (!fs::create_directories(folder, failure))
        throw FileError("cannot make the folder \"" + folder.string() + "\": " + failure.message());
    return folder;
}

fs::path make_video(const fs::path& folder, const std::function<bool()>& goes_on) {
    const fs::path program = find_program("ffmpeg");
    if (program.empty()) return {};
    fs::path video = folder;
    video += ".mp4";
    // Players take videos with even sizes and with colours at half the resolution.
    const ChildResult result =
        run_child(program,
                  {"-nostdin", "-loglevel", "error", "-y", "-framerate", "25", "-i",
                   (folder / "%04d.png").string(), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                   "-pix_fmt", "yuv420p", video.string()},
                  std::chrono::minutes{10}, Captured::output_and_errors, goes_on);
    if (result.stopped) {
        std::error_code failure; // then a part of the video stays
        fs::remove(video, failure);
        return {};
    }
    if (result.exit_code != 0) {
        const std::string said = result.output.substr(0, result.output.find('\n'));
        throw Error("ffmpeg failed to make a video of the pictures in \"" + folder.string() +
                    "\": " + (result.timed_out ? "it takes longer than ten minutes" : said));
    }
    return video;
}

} // namespace lineatlas::viewer
