#include "lineatlas/profile.hpp"

#include <algorithm>

namespace lineatlas {
namespace {

/// The rank of an event. A moment belongs to the running events of the highest rank.
int rank(ProfileTrack track) {
    switch (track) {
    case ProfileTrack::gl:
    case ProfileTrack::compute:
        return 2;
    case ProfileTrack::handover:
        return 1;
    case ProfileTrack::host:
        break;
    }
    return 0;
}

/// The times within the frame at which events begin or end.
std::vector<std::int64_t> borders(const FrameProfile& frame) {
    std::vector<std::int64_t> times{frame.start, frame.end};
    for (const ProfileEvent& event : frame.events) {
        times.push_back(std::clamp(event.start, frame.start, frame.end));
        times.push_back(std::clamp(event.end, frame.start, frame.end));
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// The events that share the time from `start` to `end`. No event begins or ends between the two.
std::vector<const ProfileEvent*> owners(const std::vector<const ProfileEvent*>& running,
                                        std::int64_t start, std::int64_t end) {
    std::vector<const ProfileEvent*> best;
    for (const ProfileEvent* event : running) {
        if (event->start > start || event->end < end) continue;
        if (!best.empty() && rank(event->track) < rank(best.front()->track)) continue;
        if (!best.empty() && rank(event->track) > rank(best.front()->track)) best.clear();
        best.push_back(event);
    }
    return best;
}

} // namespace

const char* name_of(ProfileTrack track) {
    switch (track) {
    case ProfileTrack::host:
        return "host";
    case ProfileTrack::handover:
        return "handover";
    case ProfileTrack::gl:
        return "gl";
    case ProfileTrack::compute:
        return "compute";
    }
    return "unknown";
}

std::vector<StageShare> stage_shares(const FrameProfile& frame) {
    std::vector<StageShare> shares;
    const auto add = [&](const std::string& stage, double nanoseconds) {
        auto known = std::ranges::find(shares, stage, &StageShare::stage);
        if (known == shares.end()) known = shares.insert(shares.end(), {stage, 0});
        known->nanoseconds += nanoseconds;
    };
    const std::vector<std::int64_t> times = borders(frame);
    std::vector<const ProfileEvent*> running;
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        std::erase_if(running, [&](const ProfileEvent* event) { return event->end <= times[i]; });
        for (; next < frame.events.size() && frame.events[next].start <= times[i]; ++next) {
            if (!frame.events[next].stage.empty()) running.push_back(&frame.events[next]);
        }
        const auto of = owners(running, times[i], times[i + 1]);
        const auto length = static_cast<double>(times[i + 1] - times[i]);
        for (const ProfileEvent* event : of) {
            add(event->stage, length / static_cast<double>(of.size()));
        }
    }
    return shares;
}

} // namespace lineatlas
