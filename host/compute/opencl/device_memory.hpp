#pragma once

#include <cstdint>
#include <utility>

#include "opencl.hpp"

namespace lineatlas::compute {

/// A device's memory for buffers, and how much of it one context has taken. It is checked before a
/// driver is asked, because some drivers notice only in the middle of a frame, or take the
/// machine's last memory.
class DeviceMemory {
  public:
    explicit DeviceMemory(const cl::Device& device);
    DeviceMemory(const DeviceMemory&) = delete;
    DeviceMemory& operator=(const DeviceMemory&) = delete;

    /// The memory that one buffer takes, until this object is destroyed.
    class Share {
      public:
        Share() = default;
        Share(Share&& other) noexcept
            : memory_(std::exchange(other.memory_, nullptr)), bytes_(other.bytes_) {}
        Share& operator=(Share&&) = delete;
        ~Share() {
            if (memory_ != nullptr) memory_->taken_ -= bytes_;
        }

      private:
        friend class DeviceMemory;
        Share(DeviceMemory& memory, std::uint64_t bytes) : memory_(&memory), bytes_(bytes) {
            memory.taken_ += bytes;
        }
        DeviceMemory* memory_ = nullptr;
        std::uint64_t bytes_ = 0;
    };

    /// Takes memory for a buffer. Throws Shortage if the device cannot hold it.
    Share take(std::uint64_t bytes);
    /// Throws Shortage if `status`, from making a buffer, says that memory has run out.
    void check(cl_int status, std::uint64_t bytes) const;
    std::uint64_t largest_buffer() const { return largest_buffer_; }
    std::uint64_t free() const { return total_ > taken_ ? total_ - taken_ : 0; }

  private:
    std::uint64_t largest_buffer_, total_;
    std::uint64_t taken_ = 0;
};

} // namespace lineatlas::compute
