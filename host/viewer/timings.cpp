#include "timings.hpp"

#include <algorithm>
#include <utility>

#include "core/median.hpp"

namespace lineatlas::viewer {
namespace {

constexpr double milliseconds_per_nanosecond = 1e-6;
constexpr std::size_t frames_of_median = 15;

template <class Value>
double recent_median(const std::deque<Timings::Frame>& frames, const Value& value) {
    std::vector<double> values;
    const std::size_t count = std::min(frames.size(), frames_of_median);
    for (std::size_t i = frames.size() - count; i < frames.size(); ++i) {
        values.push_back(value(frames[i]));
    }
    return values.empty() ? 0 : median(std::move(values));
}

} // namespace

void Timings::add(std::span<const FrameProfile> frames) {
    for (const FrameProfile& profile : frames) {
        Frame frame;
        frame.total =
            static_cast<double>(profile.end - profile.start) * milliseconds_per_nanosecond;
        for (const StageShare& share : stage_shares(profile)) {
            const auto found = std::ranges::find(stages_, share.stage);
            const auto index = static_cast<std::size_t>(found - stages_.begin());
            if (found == stages_.end()) stages_.push_back(share.stage);
            if (frame.stages.size() <= index) frame.stages.resize(index + 1, 0);
            frame.stages[index] = share.nanoseconds * milliseconds_per_nanosecond;
        }
        frames_.push_back(std::move(frame));
        if (frames_.size() > kept) frames_.pop_front();
        profiles_.push_back(profile);
        if (profiles_.size() > kept) profiles_.erase(profiles_.begin());
    }
}

void Timings::clear() {
    stages_.clear();
    frames_.clear();
    profiles_.clear();
}

std::vector<Timings::Kernel> Timings::kernels() const {
    std::vector<Kernel> kernels;
    if (profiles_.empty()) return kernels;
    for (const ProfileEvent& event : profiles_.back().events) {
        if (event.track != ProfileTrack::compute || event.bytes == 0) continue;
        const auto known = std::ranges::find(kernels, event.name, &Kernel::name);
        Kernel& kernel = known != kernels.end() ? *known : kernels.emplace_back(Kernel{event.name});
        kernel.milliseconds +=
            static_cast<double>(event.end - event.start) * milliseconds_per_nanosecond;
        kernel.megabytes += static_cast<double>(event.bytes) * 1e-6;
    }
    return kernels;
}

double Timings::median_total() const {
    return recent_median(frames_, [](const Frame& frame) { return frame.total; });
}

double Timings::median_of(std::size_t stage) const {
    return recent_median(frames_, [stage](const Frame& frame) { return frame.of(stage); });
}

} // namespace lineatlas::viewer
