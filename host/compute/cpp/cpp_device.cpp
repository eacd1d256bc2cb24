#include "cpp_device.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <new>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

#include "base/parallel.hpp"
#include "compute/kernel_bytes.hpp"
#include "core/host_clock.hpp"
#include "core/limits.hpp"
#include "host_kernels.hpp"

namespace lineatlas::compute {
namespace {

constexpr std::align_val_t alignment{64};

/// Tells the thread sanitizer that everything before this call happens before everything after an
/// `acquire` of the same place. TBB orders both by itself, but the sanitizer does not see how.
void release([[maybe_unused]] char& place) {
#ifdef __SANITIZE_THREAD__
    __tsan_release(&place);
#endif
}
void acquire([[maybe_unused]] char& place) {
#ifdef __SANITIZE_THREAD__
    __tsan_acquire(&place);
#endif
}

class CppBuffer final : public Buffer {
  public:
    explicit CppBuffer(std::size_t size)
        : Buffer(size), own_(static_cast<std::byte*>(::operator new(size, alignment))),
          memory_(own_) {}
    explicit CppBuffer(std::span<std::byte> memory)
        : Buffer(memory.size()), memory_(memory.data()) {}
    ~CppBuffer() override { ::operator delete(own_, alignment); }

    std::byte* memory() const { return memory_; }

  private:
    std::byte* own_ = nullptr;
    std::byte* memory_;
};

std::byte* memory_of(const Buffer& buffer) {
    return static_cast<const CppBuffer&>(buffer).memory();
}

class CppLog final : public CommandLog {
  public:
    bool complete() const override { return true; }
    std::vector<CommandTime> read() override { return commands; }
    std::optional<std::int64_t> error() const override { return 0; }

    std::vector<CommandTime> commands;
};

class CppDevice final : public Device {
  public:
    explicit CppDevice(const Tuning& tuning) : tuning_(tuning) {}

    std::string description() const override {
        return "cpp (" + std::string{host_instruction_set()} + ")";
    }
    const Tuning& tuning() const override { return tuning_; }

    std::unique_ptr<Buffer> allocate(std::size_t bytes) override {
        try {
            return std::make_unique<CppBuffer>(std::max<std::size_t>(bytes, 16));
        } catch (const std::bad_alloc&) {
            throw Shortage(written_bytes(bytes), "the host has not that much");
        }
    }
    std::unique_ptr<Buffer> wrap(std::span<std::byte> memory) override {
        return std::make_unique<CppBuffer>(memory);
    }
    void begin_host_access(Buffer&) override {}
    void end_host_access(Buffer&) override {}

    void upload(Buffer& buffer, std::span<const std::byte> data, std::size_t offset) override {
        const Logged logged{log_.get(), {"write", data.size()}};
        if (!data.empty()) std::memcpy(memory_of(buffer) + offset, data.data(), data.size());
    }
    void download(Buffer& buffer, std::span<std::byte> data, std::size_t offset) override {
        const Logged logged{log_.get(), {"read", data.size()}};
        if (!data.empty()) std::memcpy(data.data(), memory_of(buffer) + offset, data.size());
    }
    void copy(Buffer& from, Buffer& to, std::size_t bytes) override {
        const Logged logged{log_.get(), {"copy", 2 * bytes}};
        std::memcpy(memory_of(to), memory_of(from), bytes);
    }
    void clear(Buffer& buffer, std::size_t bytes) override {
        const Logged logged{log_.get(), {"fill", bytes}};
        std::memset(memory_of(buffer), 0, bytes);
    }

    /// Runs work-groups in parallel. The work-items of a group are a loop.
    void launch(const Launch& launch) override {
        const Logged logged{log_.get(),
                            {launch.kernel.name, bytes_moved(launch), launch.items, launch.group}};
        std::array<void*, most_tables> tables{};
        std::ranges::transform(launch.tables, tables.begin(),
                               [](const Buffer* buffer) { return memory_of(*buffer); });
        // Two places, because with one pieces would seem to follow each other.
        char begun = 0, ended = 0;
        const auto run = [&](std::size_t first, std::size_t end) {
            acquire(begun);
            run_on_host(launch.kernel, launch.parameters, tables, first, end, launch.items);
            release(ended);
        };
        release(begun);
        for_each_range(launch.items, launch.group, std::ref(run)); // std::ref, because frames
                                                                   // allocate nothing
        acquire(ended);
    }

    void flush() override {}
    void finish() override {}

    std::shared_ptr<CommandLog> begin_log() override { return log_ = std::make_shared<CppLog>(); }
    void end_log() override { log_.reset(); }

  private:
    struct Command {
        std::string_view name;
        std::uint64_t bytes;
        std::uint64_t items = 0;
        std::uint32_t group = 0;
    };
    /// Notes a command's time at its end.
    class Logged {
      public:
        Logged(CppLog* log, const Command& command)
            : log_(log), command_(command), start_(log != nullptr ? host_nanoseconds() : 0) {}
        ~Logged() {
            if (log_ == nullptr) return;
            log_->commands.push_back({command_.name, start_, start_, host_nanoseconds(),
                                      command_.items, command_.group, command_.bytes});
        }
        Logged(const Logged&) = delete;
        Logged& operator=(const Logged&) = delete;

      private:
        CppLog* log_;
        Command command_;
        std::int64_t start_;
    };

    const Tuning tuning_;
    std::shared_ptr<CppLog> log_; ///< while one is kept
};

} // namespace

std::byte* memory_of_cpp(const Buffer& buffer) {
    return memory_of(buffer);
}

std::unique_ptr<Device> make_cpp_device(const Tuning& tuning) {
    Tuning own = tuning;
    own.depth_lanes = host_depth_lanes();
    return std::make_unique<CppDevice>(own);
}

} // namespace lineatlas::compute
