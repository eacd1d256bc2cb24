#pragma once

#include <chrono>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "compute/backend.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// Times stages by waiting for them, or just runs them.
class StageClock {
  public:
    StageClock(compute::Backend& backend, bool measure) : backend_(backend), measure_(measure) {}

    /// Runs `action` as (a part of) the stage `name`.
    template <class Action>
    void operator()(const char* name, Action&& action) {
        if (!measure_) return action();
        const auto start = std::chrono::steady_clock::now();
        action();
        glFinish();
        backend_.finish();
        const std::chrono::duration<double, std::milli> elapsed =
            std::chrono::steady_clock::now() - start;
        for (StageTime& stage : stages_) {
            if (stage.name != name) continue;
            stage.milliseconds += elapsed.count();
            return;
        }
        stages_.push_back({name, elapsed.count()});
    }

    std::vector<StageTime> take() { return std::move(stages_); }

  private:
    compute::Backend& backend_;
    bool measure_;
    std::vector<StageTime> stages_;
};

} // namespace lineatlas
