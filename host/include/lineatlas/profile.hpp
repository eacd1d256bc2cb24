#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lineatlas/export.hpp"

namespace lineatlas {

/// Who works.
enum class ProfileTrack {
    host,     ///< this thread: preparing a stage, submitting it, waiting for what it needs
    handover, ///< this thread: passing buffers between GL and compute, with the wait that takes
    gl,       ///< GL's queue
    compute,  ///< the compute backend's queue
};
/// All tracks, in the order in which traces and tables show them.
inline constexpr ProfileTrack profile_tracks[] = {ProfileTrack::host, ProfileTrack::handover,
                                                  ProfileTrack::gl, ProfileTrack::compute};

/// "host", "handover", "gl" or "compute".
LINEATLAS_API const char* name_of(ProfileTrack track);

/// A stretch of work. Times are nanoseconds of std::chrono::steady_clock, whoever worked.
struct ProfileEvent {
    ProfileTrack track; ///< who worked
    std::string stage;  ///< as in docs/architecture.md; empty outside of every stage
    std::string name;   ///< of the kernel, or of the transfer; else as `stage`
    std::int64_t start; ///< nanoseconds
    std::int64_t end;   ///< nanoseconds, not before `start`
};

/// One frame, whole: it ends when the last of its work does.
struct FrameProfile {
    std::uint64_t number = 0;         ///< counted from the renderer's first profiled frame
    std::int64_t start = 0;           ///< nanoseconds of the same clock as its events
    std::int64_t end = 0;             ///< of its last event
    std::uint32_t samples = 0;        ///< FrameStats::samples
    std::uint32_t runs = 0;           ///< FrameStats::runs
    std::vector<ProfileEvent> events; ///< by start; on one track no two overlap
    /// How far the times of GL's queue may be off those of the host, in nanoseconds; nothing where
    /// there are none.
    std::optional<std::int64_t> gl_error{};
    /// The same of the compute backend's queue; nothing of the reference backend, whose work is
    /// the host's.
    std::optional<std::int64_t> compute_error{};
    std::uint64_t dropped = 0; ///< frames before this one that are lost: the ring was full
};

/// What a stage takes of a frame: every moment of the frame is given to the stages whose kernels or
/// passes run then, in equal parts, if there are none to the hand-over, else to the host's stage.
/// So they add up to the frame, less what belongs to no stage.
struct StageShare {
    std::string stage;  ///< as in docs/architecture.md
    double nanoseconds; ///< of the frame
};

/// The shares of all stages, in the order in which they first worked.
LINEATLAS_API std::vector<StageShare> stage_shares(const FrameProfile& frame);

/// The frames as Trace Event Format, which Perfetto and chrome://tracing open. `description`:
/// Renderer::description().
LINEATLAS_API std::string profile_trace(std::span<const FrameProfile> frames,
                                        const std::string& description);

/// A row per event: frame, track, stage, name, start and duration in microseconds.
LINEATLAS_API std::string profile_csv(std::span<const FrameProfile> frames);

/// For people: per stage and per kernel how often, how long, and what share of the frame.
LINEATLAS_API std::string profile_table(std::span<const FrameProfile> frames);

} // namespace lineatlas
