#pragma once

#include <deque>
#include <span>
#include <string>
#include <vector>

#include "lineatlas/profile.hpp"

namespace lineatlas::viewer {

/// The times of the stages of the last frames.
class Timings {
  public:
    static constexpr std::size_t kept = 120;

    void add(std::span<const FrameProfile> frames);
    void clear();

    /// The stages in the order in which they first came, which is that of the data flow.
    const std::vector<std::string>& stages() const { return stages_; }
    struct Frame {
        double total = 0;           ///< milliseconds
        std::vector<double> stages; ///< milliseconds of each stage that was known then
        double of(std::size_t stage) const { return stage < stages.size() ? stages[stage] : 0; }
    };
    const std::deque<Frame>& frames() const { return frames_; }
    /// The whole profiles of these frames.
    const std::vector<FrameProfile>& profiles() const { return profiles_; }
    /// The work of a kernel in the last frame.
    struct Kernel {
        std::string name;
        double milliseconds = 0, megabytes = 0; ///< 10^6 bytes: of its tables, see ProfileEvent
        double gigabytes_per_second() const {
            return milliseconds > 0 ? megabytes / milliseconds : 0;
        }
    };
    std::vector<Kernel> kernels() const;
    /// Medians over the last frames, milliseconds.
    double median_total() const;
    double median_of(std::size_t stage) const;

  private:
    std::vector<std::string> stages_;
    std::deque<Frame> frames_;
    std::vector<FrameProfile> profiles_;
};

} // namespace lineatlas::viewer
