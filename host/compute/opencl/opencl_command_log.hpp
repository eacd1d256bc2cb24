#pragma once

#include "lineatlas/compute_device.hpp"
#include "opencl.hpp"

namespace lineatlas::compute {

/// Events of a queue that keeps times (CL_QUEUE_PROFILING_ENABLE). A device's clock may start
/// anywhere. But each command's QUEUED time was read between two readings of the host's clock. So
/// all commands together give the offset of the two clocks to about a microsecond, anew in each
/// log.
class OpenClCommandLog final : public CommandLog {
  public:
    struct Command {
        std::string_view name;
        std::uint64_t bytes = 0; ///< bytes that it moves, if known
        std::uint64_t items = 0; ///< work-items of a kernel
        std::uint32_t group = 0;
    };

    /// A command that is about to be enqueued: an argument of the enqueue call, which must outlive
    /// it.
    class Pending {
      public:
        Pending(OpenClCommandLog* log, const Command& command);
        ~Pending();
        Pending(const Pending&) = delete;
        Pending& operator=(const Pending&) = delete;
        operator cl::Event*() { return log_ != nullptr ? &entry_.event : nullptr; } // NOLINT

      private:
        friend class OpenClCommandLog;
        struct Entry {
            Command command;
            std::int64_t before, after; ///< the host's clock before and after the call
            cl::Event event;
        };
        OpenClCommandLog* log_;
        Entry entry_{};
    };

    bool complete() const override;
    std::vector<CommandTime> read() override;
    std::optional<std::int64_t> error() const override { return error_; }

  private:
    std::vector<Pending::Entry> entries_;
    std::optional<std::int64_t> error_;
};

} // namespace lineatlas::compute
