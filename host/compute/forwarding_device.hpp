#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// A device whose memory, transfers and waits are those of another one. What derives from it says
/// its description and how it launches.
class ForwardingDevice : public Device {
  public:
    explicit ForwardingDevice(std::unique_ptr<Device> device) : device_(std::move(device)) {}

    const Tuning& tuning() const override { return device_->tuning(); }
    std::unique_ptr<Buffer> allocate(std::size_t bytes) override {
        return device_->allocate(bytes);
    }
    std::uint64_t largest_buffer() const override { return device_->largest_buffer(); }
    std::uint64_t free_memory() const override { return device_->free_memory(); }
    std::unique_ptr<Buffer> wrap(std::span<std::byte> memory) override {
        return device_->wrap(memory);
    }
    void begin_host_access(Buffer& buffer) override { device_->begin_host_access(buffer); }
    void end_host_access(Buffer& buffer) override { device_->end_host_access(buffer); }
    void upload(Buffer& buffer, std::span<const std::byte> data, std::size_t offset) override {
        device_->upload(buffer, data, offset);
    }
    void download(Buffer& buffer, std::span<std::byte> data, std::size_t offset) override {
        device_->download(buffer, data, offset);
    }
    void copy(Buffer& from, Buffer& to, std::size_t bytes) override {
        device_->copy(from, to, bytes);
    }
    void clear(Buffer& buffer, std::size_t bytes) override { device_->clear(buffer, bytes); }
    void flush() override { device_->flush(); }
    void finish() override { device_->finish(); }

  protected:
    Device& device() const { return *device_; }

  private:
    std::unique_ptr<Device> device_;
};

} // namespace lineatlas::compute
