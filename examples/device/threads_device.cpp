// A device outside the library. It runs the kernels as C++ on threads of its own.
#include "threads_device.hpp"

#include <algorithm>
#include <cstring>
#include <exception>
#include <mutex>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include <lineatlas/compute_device.hpp>
#include <lineatlas/error.hpp>

namespace {

using namespace lineatlas;

/// Buffers are aligned for the kernels' vectors of up to 64 bytes.
constexpr std::align_val_t alignment{64};

/// A buffer in memory that it owns, or in memory of somebody else.
class ThreadsBuffer final : public compute::Buffer {
  public:
    explicit ThreadsBuffer(std::size_t size)
        : Buffer(size), own_(static_cast<std::byte*>(::operator new(size, alignment))),
          memory_(own_) {}
    explicit ThreadsBuffer(std::span<std::byte> memory)
        : Buffer(memory.size()), memory_(memory.data()) {}
    ~ThreadsBuffer() override { ::operator delete(own_, alignment); }

    std::byte* memory() const { return memory_; }

  private:
    std::byte* own_ = nullptr;
    std::byte* memory_;
};

/// The memory of a buffer. A device only gets buffers that it has made.
std::byte* memory_of(const compute::Buffer& buffer) {
    return static_cast<const ThreadsBuffer&>(buffer).memory();
}

/// Runs action(0) to action(count - 1), each on a thread, and waits for all. Rethrows the exception
/// of one of them.
template <class Action>
void on_threads(std::size_t count, const Action& action) {
    std::exception_ptr error;
    std::mutex mutex;
    std::vector<std::jthread> threads; // the destructor waits for all
    for (std::size_t i = 0; i < count; ++i) {
        threads.emplace_back([&, i] {
            try {
                action(i);
            } catch (...) {
                const std::lock_guard lock{mutex};
                error = std::current_exception();
            }
        });
    }
    threads.clear();
    if (error) std::rethrow_exception(error);
}

class ThreadsDevice final : public compute::Device {
  public:
    std::string description() const override {
        return "threads (" + std::to_string(count_) + " of them)";
    }
    const compute::Tuning& tuning() const override { return tuning_; }

    std::unique_ptr<compute::Buffer> allocate(std::size_t bytes) override {
        try {
            return std::make_unique<ThreadsBuffer>(std::max<std::size_t>(bytes, 16));
        } catch (const std::bad_alloc&) {
            throw DeviceError("threads: there is no memory for " + std::to_string(bytes) +
                              " bytes; close other programs or draw a smaller model");
        }
    }
    std::unique_ptr<compute::Buffer> wrap(std::span<std::byte> memory) override {
        return std::make_unique<ThreadsBuffer>(memory);
    }
    // Nothing to do: the host and this device share memory, and no call returns before its work is
    // done.
    void begin_host_access(compute::Buffer&) override {}
    void end_host_access(compute::Buffer&) override {}
    void flush() override {}
    void finish() override {}

    void upload(compute::Buffer& buffer, std::span<const std::byte> data,
                std::size_t offset) override {
        if (!data.empty()) std::memcpy(memory_of(buffer) + offset, data.data(), data.size());
    }
    void download(compute::Buffer& buffer, std::span<std::byte> data, std::size_t offset) override {
        if (!data.empty()) std::memcpy(data.data(), memory_of(buffer) + offset, data.size());
    }
    void copy(compute::Buffer& from, compute::Buffer& to, std::size_t bytes) override {
        std::memcpy(memory_of(to), memory_of(from), bytes);
    }
    void clear(compute::Buffer& buffer, std::size_t bytes) override {
        std::memset(memory_of(buffer), 0, bytes);
    }

    /// Runs the work-items in as many parts as there are threads.
    void launch(const compute::Launch& launch) override {
        std::vector<void*> tables;
        for (const compute::Buffer* table : launch.tables) tables.push_back(memory_of(*table));
        const std::size_t items = launch.items;
        const std::size_t parts = std::min(items, count_);
        on_threads(parts, [&](std::size_t part) {
            compute::run_on_host(launch.kernel, launch.parameters, tables, items * part / parts,
                                 items * (part + 1) / parts, items);
        });
    }

  private:
    std::size_t count_ = std::max(1U, std::thread::hardware_concurrency());
    compute::Tuning tuning_; // the default: kernels without barriers, a whole block per work-item
};

std::unique_ptr<compute::Device> make_threads_device(std::string_view) {
    return std::make_unique<ThreadsDevice>();
}

} // namespace

void register_threads_device() {
    compute::register_device({"threads", "kernels as C++ on threads", make_threads_device});
}
