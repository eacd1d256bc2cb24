#include "opencl_backend.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "compute/kernel_bytes.hpp"
#include "core/limits.hpp"
#include "guarded.hpp"
#include "lineatlas/error.hpp"
#include "opencl_command_log.hpp"
#include "programs.hpp"
#include "shared_context.hpp"

namespace lineatlas::compute {
namespace {

const cl::Buffer& memory_of(Buffer& buffer) {
    return static_cast<OpenClBuffer&>(buffer).memory;
}

class Implementation final : public OpenClBackend {
  public:
    Implementation(const OpenClDevice& device, std::span<const cl_context_properties> properties,
                   const Tuning& tuning)
        : device_(device), tuning_(within_groups(tuning, group_limits(device.device))),
          // A context that is tied to GL is not shared, because it ends with the GL context.
          context_(properties.empty() ? shared_context(device)
                                      : std::make_shared<SharedContext>(device, properties)) {
        guarded("creating a queue", [&] {
            queue_ = cl::CommandQueue{context(), device.device};
            programs_.emplace(device_, context_, compiler_options(tuning_),
                              user_program_cache(tuning_.program_cache));
        });
    }

    std::string description() const override { return device_.description(); }
    const Tuning& tuning() const override { return tuning_; }
    const OpenClDevice& device() const override { return device_; }
    const cl::Context& context() const override { return context_->context(); }
    const cl::CommandQueue& queue() const override { return queue_; }
    const KernelResources& resources(const Kernel& kernel) override {
        return or_retire([&]() -> const KernelResources& { return programs_->resources(kernel); });
    }

    std::unique_ptr<Buffer> allocate(std::size_t bytes) override {
        return make_buffer(std::max<std::size_t>(bytes, 16), nullptr);
    }
    std::unique_ptr<Buffer> wrap(std::span<std::byte> memory) override {
        return make_buffer(memory.size(), memory.data());
    }
    std::uint64_t largest_buffer() const override { return memory_.largest_buffer(); }
    std::uint64_t free_memory() const override { return memory_.free(); }

    void begin_host_access(Buffer& buffer) override {
        auto& own = static_cast<OpenClBuffer&>(buffer);
        guarded("mapping a buffer", [&] {
            own.mapped = queue_.enqueueMapBuffer(own.memory, CL_FALSE, CL_MAP_READ | CL_MAP_WRITE,
                                                 0, own.size(), nullptr, logged({"map"}));
        });
    }
    void end_host_access(Buffer& buffer) override {
        auto& own = static_cast<OpenClBuffer&>(buffer);
        if (own.mapped == nullptr) return;
        guarded("unmapping a buffer", [&] {
            queue_.enqueueUnmapMemObject(own.memory, own.mapped, nullptr, logged({"unmap"}));
            own.mapped = nullptr;
        });
    }

    void upload(Buffer& buffer, std::span<const std::byte> data, std::size_t offset) override {
        write(buffer, data, offset, CL_TRUE);
    }
    void download(Buffer& buffer, std::span<std::byte> data, std::size_t offset) override {
        if (data.empty()) return finish();
        read(buffer, data, offset, CL_TRUE);
    }
    void begin_upload(Buffer& buffer, std::span<const std::byte> data) override {
        write(buffer, data, 0, CL_FALSE);
    }
    void begin_download(Buffer& buffer, std::span<std::byte> data) override {
        if (!data.empty()) read(buffer, data, 0, CL_FALSE);
    }
    void copy(Buffer& from, Buffer& to, std::size_t bytes) override {
        guarded("copying a buffer", [&] {
            queue_.enqueueCopyBuffer(memory_of(from), memory_of(to), 0, 0, bytes, nullptr,
                                     logged({"copy", 2 * bytes}));
        });
    }
    void clear(Buffer& buffer, std::size_t bytes) override {
        guarded("clearing a buffer", [&] {
            queue_.enqueueFillBuffer(memory_of(buffer), cl_uint{0}, 0, bytes, nullptr,
                                     logged({"fill", bytes}));
        });
    }

    void launch(const Launch& launch) override {
        BuiltKernel& built =
            or_retire([&]() -> BuiltKernel& { return programs_->built(launch.kernel); });
        const auto enqueue = [&] {
            const auto group = static_cast<std::uint32_t>(
                std::min<std::size_t>(launch.group, built.largest_group));
            const std::size_t global = (std::size_t{launch.items} + group - 1) / group * group;
            queue_.enqueueNDRangeKernel(
                built.kernel, cl::NullRange, cl::NDRange{global}, cl::NDRange{group}, nullptr,
                logged({launch.kernel.name, bytes_moved(launch), launch.items, group}));
        };
        set_arguments(built, launch);
        guarded("launching ", enqueue, launch.kernel.name);
    }

    void flush() override {
        guarded("submitting kernels", [&] { queue_.flush(); });
    }
    void finish() override {
        guarded("waiting for kernels", [&] { queue_.finish(); });
    }

    std::shared_ptr<CommandLog> begin_log() override {
        if (!log_) keep_times();
        log_ = std::make_shared<OpenClCommandLog>();
        return log_;
    }
    void end_log() override { log_.reset(); }

  private:
    /// `host`: memory to wrap, or null.
    std::unique_ptr<Buffer> make_buffer(std::size_t size, void* host) {
        DeviceMemory::Share share = memory_.take(size);
        const cl_mem_flags flags =
            CL_MEM_READ_WRITE | (host != nullptr ? CL_MEM_USE_HOST_PTR : cl_mem_flags{});
        return guarded("making a buffer", [&] {
            try {
                return std::make_unique<OpenClBuffer>(cl::Buffer{context(), flags, size, host},
                                                      size, std::move(share));
            } catch (const cl::Error& error) {
                memory_.check(error.err(), size);
                throw;
            }
        });
    }

    void write(Buffer& buffer, std::span<const std::byte> data, std::size_t offset, cl_bool waits) {
        if (data.empty()) return;
        guarded("writing a buffer", [&] {
            queue_.enqueueWriteBuffer(memory_of(buffer), waits, offset, data.size(), data.data(),
                                      nullptr, logged({"write", data.size()}));
        });
    }
    void read(Buffer& buffer, std::span<std::byte> data, std::size_t offset, cl_bool waits) {
        guarded("reading a buffer", [&] {
            queue_.enqueueReadBuffer(memory_of(buffer), waits, offset, data.size(), data.data(),
                                     nullptr, logged({"read", data.size()}));
        });
    }

    void set_arguments(BuiltKernel& built, const Launch& launch) const {
        const auto set = [&](cl_uint index, std::string_view name, auto&& set_one) {
            try {
                set_one();
            } catch (const cl::Error& error) {
                throw DeviceError(
                    device_.description() + ": argument " + std::to_string(index) + ", " +
                    std::string{name} + ", of the kernel " + std::string{launch.kernel.name} +
                    " was refused: " + error.what() + " returned " + name_of(error.err()));
            }
        };
        set(0, "the parameters",
            [&] { built.kernel.setArg(0, launch.parameters.size(), launch.parameters.data()); });
        for (cl_uint i = 0; i < launch.tables.size(); ++i) {
            set(i + 1, launch.kernel.tables[i].name,
                [&] { built.kernel.setArg(i + 1, memory_of(*launch.tables[i])); });
        }
    }

    /// Makes a queue that keeps times. Called for the first profiled frame.
    void keep_times() {
        guarded("creating a queue that keeps times", [&] {
            if ((queue_.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_PROFILING_ENABLE) != 0) return;
            queue_.finish();
            queue_ = cl::CommandQueue{context(), device_.device, CL_QUEUE_PROFILING_ENABLE};
        });
    }
    /// The event that a command about to be enqueued has in the log, if one is kept.
    OpenClCommandLog::Pending logged(const OpenClCommandLog::Command& command) {
        return {log_.get(), command};
    }

    template <class Action>
    auto guarded(std::string_view doing, Action&& action, std::string_view what = {}) const
        -> decltype(action()) {
        return or_retire([&]() -> decltype(action()) {
            return compute::guarded(device_, doing, std::forward<Action>(action), what);
        });
    }
    /// Runs an action and retires the context if it fails, because a driver may then refuse all
    /// later calls in it.
    template <class Action>
    auto or_retire(Action&& action) const -> decltype(action()) {
        try {
            return action();
        } catch (const Shortage&) { // is no failure of the context: other buffers use the memory
            throw;
        } catch (const DeviceError&) {
            retire(*context_);
            throw;
        }
    }

    OpenClDevice device_;
    DeviceMemory memory_{device_.device};
    Tuning tuning_;
    std::shared_ptr<SharedContext> context_;
    cl::CommandQueue queue_;
    std::optional<Programs> programs_;      ///< of context_
    std::shared_ptr<OpenClCommandLog> log_; ///< while one is kept
};

} // namespace

std::unique_ptr<OpenClBackend>
make_opencl_backend(const OpenClDevice& device,
                    std::span<const cl_context_properties> context_properties) {
    return make_opencl_backend(device, context_properties, tuning_for(device));
}

std::unique_ptr<OpenClBackend>
make_opencl_backend(const OpenClDevice& device,
                    std::span<const cl_context_properties> context_properties,
                    const Tuning& tuning) {
    return std::make_unique<Implementation>(device, context_properties, tuning);
}

} // namespace lineatlas::compute
