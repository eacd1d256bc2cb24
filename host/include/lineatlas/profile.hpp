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
    compute,  ///< the compute device's kernels and transfers
};
/// All tracks, in the order in which traces and tables show them.
inline constexpr ProfileTrack profile_tracks[] = {ProfileTrack::host, ProfileTrack::handover,
                                                  ProfileTrack::gl, ProfileTrack::compute};

/// "host", "handover", "gl" or "compute".
LINEATLAS_API const char* name_of(ProfileTrack track);

/// Work from one time to another. Times are nanoseconds of std::chrono::steady_clock, whoever
/// worked.
struct ProfileEvent {
    ProfileTrack track;      ///< who worked
    std::string stage;       ///< as in docs/architecture.md; empty outside of every stage
    std::string name;        ///< of the kernel, or of the transfer; else as `stage`
    std::int64_t start;      ///< nanoseconds
    std::int64_t end;        ///< nanoseconds, not before `start`
    std::uint64_t items = 0; ///< of a kernel: its work-items
    std::uint32_t group = 0; ///< of a kernel: those of a work-group, at most
    /// Of a kernel: what its tables hold, those that it reads and writes twice; more than it moves
    /// where a table has room to spare. Of a transfer: what it moves.
    std::uint64_t bytes = 0;

    /// 10^9 bytes a second; 0 if it has none or took no time.
    double gigabytes_per_second() const {
        return end > start ? static_cast<double>(bytes) / static_cast<double>(end - start) : 0;
    }
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
    /// The same of the compute device's commands; nothing of a device that keeps no times.
    std::optional<std::int64_t> compute_error{};
    /// What the compute device reaches when it copies one large buffer into another: 10^9 bytes a
    /// second, those read and those written. Measured at the first profiled frame; 0 if memory was
    /// too short for it.
    double copy_gigabytes_per_second = 0;
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

/// A row per event: frame, track, stage, name, start and duration in microseconds; of kernels and
/// transfers also what ProfileEvent says of them, and 10^9 bytes a second beside those of a copy.
LINEATLAS_API std::string profile_csv(std::span<const FrameProfile> frames);

/// For people: per stage and per kernel how often, how long, and what share of the frame; per
/// kernel the size of a launch and its bytes a second beside those of a copy.
LINEATLAS_API std::string profile_table(std::span<const FrameProfile> frames);

} // namespace lineatlas
