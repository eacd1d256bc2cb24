#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lineatlas/export.hpp"

/// @file
/// Times of frames: of stages, GL passes, kernels and transfers.
/// @code{.cpp}
/// options.profile = true;
/// renderer.draw(camera, options, framebuffer);
/// const std::vector<FrameProfile> taken = renderer.take_profiles();
/// std::cout << profile_table(taken);
/// std::ofstream{"trace.json"} << profile_trace(taken, renderer.description());
/// @endcode

namespace lineatlas {

/// Which part of the machine works.
enum class ProfileTrack {
    host,     ///< the calling thread: prepares a stage, submits it, waits for its inputs
    handover, ///< the calling thread: passes buffers between GL and compute, and waits for that
    gl,       ///< GL's queue
    compute,  ///< the compute device's kernels and transfers
};
/// All tracks, in the order in which traces and tables show them.
inline constexpr ProfileTrack profile_tracks[] = {ProfileTrack::host, ProfileTrack::handover,
                                                  ProfileTrack::gl, ProfileTrack::compute};

/// "host", "handover", "gl" or "compute".
LINEATLAS_API const char* name_of(ProfileTrack track);

/// Work from one time to another. Times are nanoseconds of std::chrono::steady_clock on all tracks.
struct ProfileEvent {
    ProfileTrack track;      ///< which part worked
    std::string stage;       ///< as in docs/architecture.md; empty outside of every stage
    std::string name;        ///< name of the kernel or transfer; else the same as `stage`
    std::int64_t start;      ///< nanoseconds
    std::int64_t end;        ///< nanoseconds, not before `start`
    std::uint64_t items = 0; ///< work-items of a kernel
    std::uint32_t group = 0; ///< work-items of a kernel's work-group, at most
    /// For a kernel: the size of its tables, counted twice for those that it both reads and writes.
    /// This is more than the kernel moves if a table has spare room. For a transfer: the bytes
    /// moved.
    std::uint64_t bytes = 0;

    /// 10^9 bytes a second; 0 if the event has no bytes or took no time.
    double gigabytes_per_second() const {
        return end > start ? static_cast<double>(bytes) / static_cast<double>(end - start) : 0;
    }
};

/// A whole frame: it ends when the last of its events ends.
struct FrameProfile {
    std::uint64_t number = 0;         ///< counted from the renderer's first profiled frame
    std::int64_t start = 0;           ///< nanoseconds of the same clock as its events
    std::int64_t end = 0;             ///< end of its last event
    std::uint32_t samples = 0;        ///< FrameStats::samples
    std::uint32_t runs = 0;           ///< FrameStats::runs
    std::vector<ProfileEvent> events; ///< in order of start; events of one track do not overlap
    /// By how much times of GL's queue may differ from the host's clock, in nanoseconds; nothing if
    /// there are no such times.
    std::optional<std::int64_t> gl_error{};
    /// The same for commands of the compute device; nothing if the device keeps no times.
    std::optional<std::int64_t> compute_error{};
    /// The speed at which the compute device copies one large buffer into another: 10^9 bytes a
    /// second, read and written bytes together. Measured at the first profiled frame; 0 if there
    /// was too little memory.
    double copy_gigabytes_per_second = 0;
    std::uint64_t dropped = 0; ///< number of lost frames before this one: the ring was full
};

/// A stage's share of a frame. Every moment of the frame belongs, in equal parts, to the stages
/// whose kernels or passes run then; if none runs, to the hand-over, or else to the stage that the
/// host works on. So the shares add up to the frame, less the time that belongs to no stage.
struct StageShare {
    std::string stage;  ///< as in docs/architecture.md
    double nanoseconds; ///< time of the frame that belongs to the stage
};

/// The shares of all stages, in the order in which they first worked.
LINEATLAS_API std::vector<StageShare> stage_shares(const FrameProfile& frame);

/// The frames as Trace Event Format, which Perfetto and chrome://tracing open. `description`:
/// Renderer::description().
LINEATLAS_API std::string profile_trace(std::span<const FrameProfile> frames,
                                        const std::string& description);

/// CSV with a row per event: frame, track, stage, name, start and duration in microseconds. Rows of
/// kernels and transfers also have the other members of ProfileEvent, and 10^9 bytes a second, also
/// as a share of a copy's.
LINEATLAS_API std::string profile_csv(std::span<const FrameProfile> frames);

/// A table for people: for each stage and kernel how often it ran, how long, and its share of the
/// frame; for each kernel also the size of a launch and its bytes a second, compared with a copy's.
LINEATLAS_API std::string profile_table(std::span<const FrameProfile> frames);

} // namespace lineatlas
