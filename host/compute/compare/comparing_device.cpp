#include "comparing_device.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "compute/kernel_bytes.hpp"
#include "compute/kernels.hpp"
#include "layouts.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::compute {
namespace {

std::size_t position_of(const std::vector<std::string_view>& names, std::string_view stage) {
    const auto found = std::ranges::find(names, stage);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::string list;
    for (const std::string_view name : names) {
        list += (list.empty() ? "" : ", ") + std::string{name};
    }
    throw UsageError("there is no compute stage \"" + std::string{stage} + "\"; there is " + list);
}

/// One table on both devices. The first device's content counts.
class PairBuffer final : public Buffer {
  public:
    PairBuffer(std::unique_ptr<Buffer> a, std::unique_ptr<Buffer> b)
        : Buffer(a->size()), first(std::move(a)), second(std::move(b)) {}

    std::unique_ptr<Buffer> first, second;
};

PairBuffer& pair(Buffer& buffer) {
    return static_cast<PairBuffer&>(buffer);
}

class Implementation final : public ComparingDevice {
  public:
    Implementation(std::unique_ptr<Device> first, std::unique_ptr<Device> second,
                   std::string_view until)
        : first_(std::move(first)), second_(std::move(second)), stages_(stage_names()),
          last_compared_(until.empty() ? stages_.size() : position_of(stages_, until)),
          tuning_(first_->tuning()) {
        tuning_.scan_tiles = first_->tuning().scan_tiles && second_->tuning().scan_tiles;
    }

    std::string description() const override {
        return first_->description() + ", compared with " + second_->description();
    }
    const Tuning& tuning() const override { return tuning_; }
    Summary summary() const override { return summary_; }

    std::unique_ptr<Buffer> allocate(std::size_t bytes) override {
        auto made = std::make_unique<PairBuffer>(first_->allocate(bytes), second_->allocate(bytes));
        // Elements that a kernel leaves alone are compared too, so both tables are cleared first.
        const std::size_t whole = made->size() / sizeof(std::uint32_t) * sizeof(std::uint32_t);
        first_->clear(*made->first, whole);
        second_->clear(*made->second, whole);
        return made;
    }
    std::uint64_t largest_buffer() const override {
        return std::min(first_->largest_buffer(), second_->largest_buffer());
    }
    std::uint64_t free_memory() const override {
        return std::min(first_->free_memory(), second_->free_memory());
    }
    std::unique_ptr<Buffer> wrap(std::span<std::byte> memory) override {
        return std::make_unique<PairBuffer>(first_->wrap(memory), second_->allocate(memory.size()));
    }
    void begin_host_access(Buffer& buffer) override {
        first_->begin_host_access(*pair(buffer).first);
    }
    void end_host_access(Buffer& buffer) override { first_->end_host_access(*pair(buffer).first); }
    void upload(Buffer& buffer, std::span<const std::byte> data, std::size_t offset) override {
        first_->upload(*pair(buffer).first, data, offset);
    }
    void download(Buffer& buffer, std::span<std::byte> data, std::size_t offset) override {
        first_->download(*pair(buffer).first, data, offset);
    }
    void copy(Buffer& from, Buffer& to, std::size_t bytes) override {
        first_->copy(*pair(from).first, *pair(to).first, bytes);
    }
    void clear(Buffer& buffer, std::size_t bytes) override {
        first_->clear(*pair(buffer).first, bytes);
    }

    void launch(const Launch& launch) override {
        const bool compared = position_of(stages_, launch.kernel.stage) <= last_compared_;
        // Written tables are copied too, so that elements which a kernel leaves alone are equal.
        for (Buffer* table : launch.tables) {
            if (compared) copy_to_second(pair(*table));
        }
        launch_on(*first_, &PairBuffer::first, launch);
        if (!compared) return;
        launch_on(*second_, &PairBuffer::second, launch);
        for (std::size_t i = 0; i < launch.tables.size(); ++i) {
            const Access access = launch.kernel.tables[i].access;
            if (access == Access::out || access == Access::inout) compare(launch, i);
        }
        ++summary_.kernels;
    }

    void flush() override { first_->flush(); }
    void finish() override { first_->finish(); }

    std::shared_ptr<CommandLog> begin_log() override { return first_->begin_log(); }
    void end_log() override { first_->end_log(); }

  private:
    static void launch_on(Device& device, std::unique_ptr<Buffer> PairBuffer::*side,
                          const Launch& launch) {
        std::array<Buffer*, most_tables> tables{};
        std::ranges::transform(launch.tables, tables.begin(),
                               [&](Buffer* table) { return (pair(*table).*side).get(); });
        device.launch({launch.kernel, launch.parameters,
                       std::span{tables}.first(launch.tables.size()), launch.items, launch.group});
    }

    static std::span<std::byte> content(Device& device, Buffer& buffer, std::size_t size,
                                        std::vector<std::byte>& memory) {
        memory.resize(size);
        device.download(buffer, memory, 0);
        return memory;
    }

    void copy_to_second(const PairBuffer& table) {
        second_->upload(*table.second, content(*first_, *table.first, table.size(), first_content_),
                        0);
    }

    void compare(const Launch& launch, std::size_t i) {
        const KernelTable& table = launch.kernel.tables[i];
        const PairBuffer& buffer = pair(*launch.tables[i]);
        const Layout& layout = layout_of(table.type);
        const auto a = content(*first_, *buffer.first, buffer.size(), first_content_);
        const auto b = content(*second_, *buffer.second, buffer.size(), second_content_);
        summary_.elements += buffer.size() / layout.size();
        const auto difference = first_difference(layout, a, b);
        if (!difference) return;
        const std::string field =
            difference->field.empty() ? "" : ", " + layout.name + "::" + difference->field;
        throw MismatchError("stage " + std::string{launch.kernel.stage} + " differs: kernel " +
                            std::string{launch.kernel.name} + ", " + std::string{table.name} +
                            ", element " + std::to_string(difference->element) + field + ": " +
                            difference->first + " (" + first_->description() + "), " +
                            difference->second + " (" + second_->description() + ")");
    }

    std::unique_ptr<Device> first_, second_;
    std::vector<std::string_view> stages_;
    std::size_t last_compared_; ///< position of a stage
    Tuning tuning_;
    Summary summary_;
    std::vector<std::byte> first_content_, second_content_;
};

} // namespace

std::unique_ptr<ComparingDevice> make_comparing_device(std::unique_ptr<Device> first,
                                                       std::unique_ptr<Device> second,
                                                       std::string_view until) {
    return std::make_unique<Implementation>(std::move(first), std::move(second), until);
}

} // namespace lineatlas::compute
