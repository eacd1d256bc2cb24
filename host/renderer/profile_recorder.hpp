#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "compute/stages/stages.hpp"
#include "glpasses/timer_queries.hpp"
#include "lineatlas/profile.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// Profiles frames. The times of GL and of the device are collected while later frames are drawn,
/// so that a profiled frame waits no more than a plain one.
class ProfileRecorder {
  public:
    /// `gl_is_software`: then GL works on this thread from the call on, and stamps say only when a
    /// pass is done.
    ProfileRecorder(compute::Device& device, bool gl_is_software);

    /// A frame while it is drawn. A frame that is not finished leaves nothing behind.
    class Frame {
      public:
        explicit Frame(ProfileRecorder& recorder);
        ~Frame();
        Frame(const Frame&) = delete;
        Frame& operator=(const Frame&) = delete;
        void finish(const FrameStats& stats);

      private:
        ProfileRecorder& recorder_;
    };

    void begin_stage(ProfileTrack track, const char* stage);
    void end_stage();

    /// The frames that are complete and were not taken yet. With `wait` all frames that were not
    /// taken.
    std::vector<FrameProfile> take(bool wait);

  private:
    struct Pass {
        const char* stage;
        std::int64_t submitted;
        GLuint start, end; ///< stamps; `start` is 0 if GL is software
    };
    struct Recording {
        FrameProfile profile;
        std::vector<Pass> passes;
        std::shared_ptr<compute::CommandLog> commands;
        gl::ClockOffset gl_offset{};
    };

    void begin_pass(const char* stage, std::int64_t now);
    void end_pass();
    void collect(bool wait);
    static bool is_complete(const Recording& recording);
    FrameProfile finished(Recording& recording);
    void add_passes(Recording& recording);
    void release(Recording& recording);
    static void add_commands(Recording& recording);

    compute::Device& device_;
    bool gl_is_software_;
    double copy_gigabytes_per_second_;
    gl::TimerQueries queries_;
    std::unique_ptr<Recording> current_;
    bool in_pass_ = false;
    std::deque<Recording> pending_;
    std::deque<FrameProfile> finished_;
    std::int64_t gl_end_ = 0; ///< of the last pass
    std::uint64_t number_ = 0, dropped_ = 0;
};

} // namespace lineatlas
