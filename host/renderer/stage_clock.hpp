#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/host_clock.hpp"
#include "glpasses/interop/sharing.hpp"
#include "profile_recorder.hpp"

namespace lineatlas {

/// Runs the stages of a frame and takes their times, either for a profile or with a wait after each
/// stage, so that stages do not overlap. A hand-over of tables between GL and compute is a stage of
/// its own, which interrupts the stage that asked for the tables.
class StageClock final : private interop::Sharing::Timer {
  public:
    /// `recorder`: that of a profiled frame, else null. There may be one clock at a time for each
    /// `sharing`.
    StageClock(interop::Sharing& sharing, bool measure, ProfileRecorder* recorder = nullptr)
        : sharing_(sharing), measure_(measure), recorder_(recorder) {
        sharing_.gl_works(); // it may have worked for the program since the last frame
        sharing_.time_by(this);
        if (measure_) wait(); // else the first stage would be charged for earlier work
    }
    ~StageClock() { sharing_.time_by(nullptr); }
    StageClock(const StageClock&) = delete;
    StageClock& operator=(const StageClock&) = delete;

    /// Runs `action` as (a part of) the stage `name` of the host or the compute device.
    template <class Action>
    void operator()(const char* name, Action&& action) {
        run({ProfileTrack::host, name}, std::forward<Action>(action));
    }
    /// Runs `action` as a stage of GL.
    template <class Action>
    void gl(const char* name, Action&& action) {
        sharing_.gl_works();
        run({ProfileTrack::gl, name}, std::forward<Action>(action));
    }

    std::vector<StageTime> take() { return std::move(stages_); }

  private:
    struct Part {
        ProfileTrack track = ProfileTrack::host;
        const char* name = nullptr; ///< null: none
    };

    template <class Action>
    void run(const Part& part, Action&& action) {
        begin(part);
        action();
        end();
    }

    void begin(const Part& part) {
        current_ = part;
        if (recorder_ != nullptr) recorder_->begin_stage(part.track, part.name);
        if (measure_) start_ = host_nanoseconds();
    }

    void end() {
        if (measure_) {
            wait();
            add(current_.name, static_cast<double>(host_nanoseconds() - start_) * 1e-6);
        }
        if (recorder_ != nullptr) recorder_->end_stage();
        current_ = {};
    }

    void begin_handover() override {
        interrupted_ = current_;
        if (interrupted_.name != nullptr) end();
        begin({ProfileTrack::handover, "handover"});
    }

    void end_handover() override {
        end();
        if (interrupted_.name != nullptr) begin(interrupted_);
    }

    void wait() {
        glFinish();
        sharing_.device().finish();
    }

    void add(const char* name, double milliseconds) {
        const auto known = std::ranges::find(stages_, name, &StageTime::name);
        if (known == stages_.end())
            stages_.push_back({name, milliseconds});
        else
            known->milliseconds += milliseconds;
    }

    interop::Sharing& sharing_;
    bool measure_;
    ProfileRecorder* recorder_;
    Part current_, interrupted_;
    std::int64_t start_ = 0; ///< of the current part
    std::vector<StageTime> stages_;
};

} // namespace lineatlas
