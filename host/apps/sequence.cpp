#include "sequence.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "command_line/stop_signal.hpp"
#include "io/standard_streams.hpp"
#include "progress.hpp"

namespace lineatlas::apps {
namespace {

std::string stopped_at(std::size_t drawn, std::size_t total) {
    return fmt::format(
        "stopped, {} of {} frames are drawn; the same command with --resume draws the others",
        drawn, total);
}

void stop_if_asked(const StopSignal& stop, FrameOutput& output, std::size_t drawn,
                   std::size_t total) {
    if (stop.received() == 0) return;
    output.finish();
    throw Stopped(stop.received(), stopped_at(drawn, total));
}

std::vector<const SequenceFrame*> missing_frames(std::span<const SequenceFrame> frames,
                                                 FrameOutput& output, const StopSignal& stop) {
    std::vector<const SequenceFrame*> missing;
    for (const SequenceFrame& frame : frames) {
        const auto checked = static_cast<std::size_t>(&frame - frames.data());
        stop_if_asked(stop, output, checked - missing.size(), frames.size());
        if (!output.is_whole(frame.path, frame.camera.size)) missing.push_back(&frame);
    }
    return missing;
}

} // namespace

void draw_sequence(std::span<const SequenceFrame> frames, FrameOutput& output, bool resume) {
    StopSignal stop;
    std::vector<const SequenceFrame*> wanted;
    if (resume) {
        wanted = missing_frames(frames, output, stop);
    } else {
        for (const SequenceFrame& frame : frames) wanted.push_back(&frame);
    }
    const std::size_t there = frames.size() - wanted.size();
    Progress progress{wanted.size()};
    std::size_t drawn = 0;
    for (const SequenceFrame* frame : wanted) {
        // The frame that is being written when the program is stopped may be missing too.
        stop.set_last_words("lineatlas: " + stopped_at(there + drawn, frames.size()));
        output.draw(frame->camera, frame->path);
        progress.show(++drawn);
        if (drawn < wanted.size()) stop_if_asked(stop, output, there + drawn, frames.size());
    }
    output.finish();
    progress.clear();
    const std::string skipped = there > 0 ? fmt::format("; {} were there already", there) : "";
    print_error(fmt::format("lineatlas: {} frames drawn in {:.1f} s{}\n", drawn, progress.seconds(),
                            skipped));
}

} // namespace lineatlas::apps
