#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "compute/backend.hpp"

namespace lineatlas::compute {

/// Host memory, owned or of the caller.
class HostBuffer final : public Buffer {
  public:
    explicit HostBuffer(std::size_t bytes) : Buffer(bytes), owned_(bytes), memory_(owned_) {}
    explicit HostBuffer(std::span<std::byte> memory) : Buffer(memory.size()), memory_(memory) {}

    std::span<std::byte> memory() const { return memory_; }

  private:
    std::vector<std::byte> owned_;
    std::span<std::byte> memory_;
};

inline std::span<std::byte> memory_of(Buffer& buffer) {
    return static_cast<HostBuffer&>(buffer).memory();
}

/// The first `count` elements of a buffer.
template <class T>
std::span<T> view(Buffer& buffer, std::size_t count) {
    return {reinterpret_cast<T*>(memory_of(buffer).data()), count};
}

template <class T>
std::span<T> view_all(Buffer& buffer) {
    return view<T>(buffer, buffer.size() / sizeof(T));
}

/// Every stage in plain C++ on the calling thread; its buffers are host memory. Also a base for
/// backends that do some stages in another way: see docs/backends.md.
class ReferenceBackend : public Backend {
  public:
    std::string description() const override;
    std::unique_ptr<Buffer> allocate(std::size_t bytes) override;
    std::unique_ptr<Buffer> wrap(std::span<std::byte> memory) override;
    void begin_host_access(Buffer&) override;
    void end_host_access(Buffer&) override;
    void upload(Buffer& buffer, std::span<const std::byte> data) override;
    void upload_at(Buffer& buffer, std::size_t offset, std::span<const std::byte> data) override;
    void download(Buffer& buffer, std::span<std::byte> data) override;
    void transform(const TransformArgs& args) override;
    void bounds(const BoundsArgs& args) override;
    void forget(const ForgetArgs& args) override;
    void pyramid(const PyramidArgs& args) override;
    void cull(const CullArgs& args) override;
    void facing(const FacingArgs& args) override;
    void project_clip(const ProjectClipArgs& args) override;
    void scan(Buffer& values, std::uint32_t n, ScanKind kind) override;
    void atlas(const AtlasArgs& args) override;
    void temporal(const TemporalArgs& args) override;
    void compact_runs(const CompactRunsArgs& args) override;
    void filter(const FilterArgs& args) override;
    void halo(const HaloArgs& args) override;
    void density(const DensityArgs& args) override;
    void intervals(const IntervalsArgs& args) override;
    void compact_samples(const CompactSamplesArgs& args) override;
    void flush() override;
    void finish() override;
};

} // namespace lineatlas::compute
