#include "sequence_options.hpp"

#include <functional>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "cameras/camera_file.hpp"
#include "command_line/values.hpp"
#include "lineatlas/error.hpp"
#include "output_pattern.hpp"

namespace lineatlas::apps {
namespace {

constexpr int most_frames = 1'000'000;

Camera frame_camera(int number, const View& view, glm::ivec2 size, const Bounds& bounds) {
    try {
        return make_camera(view, size, bounds);
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("frame {}: {}", number, error.what()));
    }
}

} // namespace

void SequenceOptions::declare(CLI::App& app) {
    app_ = &app;
    const std::string group = "Sequences (the output needs a %d or %04d for the number)";
    app.add_option("--turntable", turntable_,
                   "Frames of one turn of the camera around the model's vertical axis")
        ->group(group);
    app.add_option("--camera-path", camera_path_,
                   "JSON file of keyframes for the camera; docs/output.md describes it")
        ->group(group);
    app.add_option("--frames", frames_,
                   "Which frames to draw: 7, 0-99, 0-99x5 (each fifth), 3-x5 (each fifth from 3 to "
                   "the end), or a list of these with commas; default all")
        ->group(group);
    app.add_flag("--resume", resume_, "Skip frames whose files exist and are whole")->group(group);
}

bool SequenceOptions::given(const std::string& output) const {
    const bool turntable = app_->count("--turntable") > 0;
    const bool path = app_->count("--camera-path") > 0;
    if (turntable && path)
        throw UsageError("--turntable and --camera-path exclude each other; leave out one of them");
    if (!turntable && !path) {
        for (const char* option : {"--frames", "--resume"}) {
            if (app_->count(option) == 0) continue;
            throw UsageError(
                fmt::format("{} is for sequences; add --turntable or --camera-path", option));
        }
        return false;
    }
    if (turntable && (turntable_ < 1 || turntable_ > most_frames)) {
        throw UsageError(fmt::format("--turntable must be 1 to {} frames", most_frames));
    }
    const OutputPattern checked{output};
    return true;
}

std::vector<SequenceFrame> SequenceOptions::frames(const std::string& output, const View& view,
                                                   const Axis& axis, glm::ivec2 size,
                                                   const Bounds& bounds, glm::dvec3 origin) const {
    int first = 0;
    int last = turntable_ - 1;
    std::function<View(int)> view_at = [&](int number) {
        return turned(view, axis, static_cast<double>(number) / turntable_);
    };
    std::optional<CameraPath> path;
    if (!camera_path_.empty()) {
        path = read_camera_path(camera_path_, view, origin);
        first = path->first_frame();
        last = path->last_frame();
        view_at = [&](int number) { return path->view(number); };
    }
    const std::string wanted = frames_.empty() ? fmt::format("{}-{}", first, last) : frames_;
    const OutputPattern pattern{output};
    std::vector<SequenceFrame> result;
    for (const int number : parse_frames("--frames", wanted, first, last)) {
        result.push_back(
            {number, pattern.path(number), frame_camera(number, view_at(number), size, bounds)});
    }
    return result;
}

} // namespace lineatlas::apps
