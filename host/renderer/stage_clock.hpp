#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/host_clock.hpp"
#include "profile_recorder.hpp"

namespace lineatlas {

/// Runs the stages of a frame, and says when it does: to a profile, or to itself with a wait after
/// each, so that none hides behind another.
class StageClock {
  public:
    /// `recorder`: of a profiled frame, else null.
    StageClock(compute::Device& device, bool measure, ProfileRecorder* recorder = nullptr)
        : device_(device), measure_(measure), recorder_(recorder) {
        if (measure_) wait(); // else the first stage gets what was there before
    }

    /// Runs `action` as (a part of) the stage `name` of the host or the compute device.
    template <class Action>
    void operator()(const char* name, Action&& action) {
        run(ProfileTrack::host, name, std::forward<Action>(action));
    }
    /// A stage of GL's.
    template <class Action>
    void gl(const char* name, Action&& action) {
        run(ProfileTrack::gl, name, std::forward<Action>(action));
    }
    template <class Action>
    void handover(Action&& action) {
        run(ProfileTrack::handover, "handover", std::forward<Action>(action));
    }

    std::vector<StageTime> take() { return std::move(stages_); }

  private:
    template <class Action>
    void run(ProfileTrack track, const char* name, Action&& action) {
        if (recorder_ != nullptr) recorder_->begin_stage(track, name);
        if (measure_)
            measure(name, action);
        else
            action();
        if (recorder_ != nullptr) recorder_->end_stage();
    }

    template <class Action>
    void measure(const char* name, Action& action) {
        const std::int64_t start = host_nanoseconds();
        action();
        wait();
        add(name, static_cast<double>(host_nanoseconds() - start) * 1e-6);
    }

    void wait() {
        glFinish();
        device_.finish();
    }

    void add(const char* name, double milliseconds) {
        const auto known = std::ranges::find(stages_, name, &StageTime::name);
        if (known == stages_.end())
            stages_.push_back({name, milliseconds});
        else
            known->milliseconds += milliseconds;
    }

    compute::Device& device_;
    bool measure_;
    ProfileRecorder* recorder_;
    std::vector<StageTime> stages_;
};

} // namespace lineatlas
