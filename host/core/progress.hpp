#pragma once

#include <string>

#include "lineatlas/progress.hpp"

namespace lineatlas {

/// Reports the progress of a part of a call as progress of the whole call. The Progress must
/// outlive it.
class ProgressPart {
  public:
    /// what: the work that may be cancelled, in a word or two. from, to: the part's shares of the
    /// whole.
    ProgressPart(const Progress& progress, const char* what, float from = 0, float to = 1)
        : progress_(&progress), what_(what), from_(from), to_(to) {}

    /// Progress that is reported to nobody.
    static ProgressPart none() {
        static const Progress nobody;
        return {nobody, ""};
    }

    explicit operator bool() const { return static_cast<bool>(*progress_); }
    /// Throws Cancelled if the call is to stop.
    void operator()(float done) const {
        if (*progress_ && !(*progress_)(from_ + done * (to_ - from_)))
            throw Cancelled(std::string{what_} + " was cancelled");
    }
    ProgressPart part(float from, float to) const {
        return {*progress_, what_, from_ + from * (to_ - from_), from_ + to * (to_ - from_)};
    }

  private:
    const Progress* progress_;
    const char* what_;
    float from_, to_;
};

/// The Progress of a part of a call, for a call of a public function within it. from, to: the
/// part's shares of the whole. `progress` must outlive the result.
inline Progress part_of(const Progress& progress, float from, float to) {
    if (!progress) return {};
    return [&progress, from, to](float done) { return progress(from + done * (to - from)); };
}

} // namespace lineatlas
