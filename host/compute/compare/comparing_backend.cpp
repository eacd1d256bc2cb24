#include "comparing_backend.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "lineatlas/error.hpp"
#include "stage_buffers.hpp"

namespace lineatlas::compute {
namespace {

/// In the order of a frame, by the names of docs/architecture.md.
constexpr std::array<std::string_view, 16> stage_names{
    "bounds", "transform", "pyramid", "cull",           "facing",    "project_clip",
    "scan",   "atlas",     "forget",  "temporal",       "intervals", "compact",
    "halo",   "filter",    "density", "compact_samples"};

std::size_t position_of(std::string_view stage) {
    const auto found = std::ranges::find(stage_names, stage);
    if (found != stage_names.end()) return static_cast<std::size_t>(found - stage_names.begin());
    std::string names;
    for (const std::string_view name : stage_names) {
        names += (names.empty() ? "" : ", ") + std::string{name};
    }
    throw UsageError("there is no compute stage \"" + std::string{stage} + "\"; there is " + names);
}

/// One table on both backends; the first's is the one that counts.
class PairBuffer final : public Buffer {
  public:
    PairBuffer(std::unique_ptr<Buffer> a, std::unique_ptr<Buffer> b)
        : Buffer(a->size()), first(std::move(a)), second(std::move(b)) {}

    std::unique_ptr<Buffer> first, second;
};

PairBuffer& pair(Buffer& buffer) {
    return static_cast<PairBuffer&>(buffer);
}

struct Output {
    const char* name;
    PairBuffer& buffer;
    const Layout& layout;
};

/// Notes which tables a stage uses.
struct Collect {
    std::vector<PairBuffer*> all{};
    std::vector<Output> written{};

    Buffer& in(Buffer& buffer) {
        if (std::ranges::find(all, &pair(buffer)) == all.end()) all.push_back(&pair(buffer));
        return buffer;
    }
    Buffer& out(const char* name, Buffer& buffer, const Layout& layout) {
        written.push_back({name, pair(buffer), layout});
        return in(buffer);
    }
};

/// Puts one backend's own tables into a stage's arguments.
struct Side {
    std::unique_ptr<Buffer> PairBuffer::*side;

    Buffer& in(Buffer& buffer) { return *(pair(buffer).*side); }
    Buffer& out(const char*, Buffer& buffer, const Layout&) { return in(buffer); }
};

class Implementation final : public ComparingBackend {
  public:
    Implementation(std::unique_ptr<Backend> first, std::unique_ptr<Backend> second,
                   std::string_view until)
        : first_(std::move(first)), second_(std::move(second)),
          last_compared_(until.empty() ? stage_names.size() : position_of(until)) {}

    std::string description() const override {
        return first_->description() + ", compared with " + second_->description();
    }
    Summary summary() const override { return summary_; }

    std::unique_ptr<Buffer> allocate(std::size_t bytes) override {
        return std::make_unique<PairBuffer>(first_->allocate(bytes), second_->allocate(bytes));
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
    void upload(Buffer& buffer, std::span<const std::byte> data) override {
        first_->upload(*pair(buffer).first, data);
    }
    void upload_at(Buffer& buffer, std::size_t offset, std::span<const std::byte> data) override {
        first_->upload_at(*pair(buffer).first, offset, data);
    }
    void download(Buffer& buffer, std::span<std::byte> data) override {
        first_->download(*pair(buffer).first, data);
    }

    void transform(const TransformArgs& args) override {
        stage("transform", args, &Backend::transform);
    }
    void bounds(const BoundsArgs& args) override { stage("bounds", args, &Backend::bounds); }
    void forget(const ForgetArgs& args) override { stage("forget", args, &Backend::forget); }
    void pyramid(const PyramidArgs& args) override { stage("pyramid", args, &Backend::pyramid); }
    void cull(const CullArgs& args) override { stage("cull", args, &Backend::cull); }
    void facing(const FacingArgs& args) override { stage("facing", args, &Backend::facing); }
    void project_clip(const ProjectClipArgs& args) override {
        stage("project_clip", args, &Backend::project_clip);
    }
    void scan(Buffer& values, std::uint32_t n, ScanKind kind) override {
        run_both("scan", ScanArgs{values, n, kind}, [](Backend& backend, const ScanArgs& args) {
            backend.scan(args.values, args.n, args.kind);
        });
    }
    void atlas(const AtlasArgs& args) override { stage("atlas", args, &Backend::atlas); }
    void temporal(const TemporalArgs& args) override {
        stage("temporal", args, &Backend::temporal);
    }
    void compact_runs(const CompactRunsArgs& args) override {
        stage("compact", args, &Backend::compact_runs);
    }
    void filter(const FilterArgs& args) override { stage("filter", args, &Backend::filter); }
    void halo(const HaloArgs& args) override { stage("halo", args, &Backend::halo); }
    void density(const DensityArgs& args) override { stage("density", args, &Backend::density); }
    void intervals(const IntervalsArgs& args) override {
        stage("intervals", args, &Backend::intervals);
    }
    void compact_samples(const CompactSamplesArgs& args) override {
        stage("compact_samples", args, &Backend::compact_samples);
    }

    void flush() override { first_->flush(); }
    void finish() override { first_->finish(); }

    std::shared_ptr<CommandLog> begin_log() override { return first_->begin_log(); }
    void end_log() override { first_->end_log(); }

  private:
    template <class Args>
    void stage(std::string_view name, const Args& args, void (Backend::*method)(const Args&)) {
        run_both(name, args,
                 [method](Backend& backend, const Args& own) { (backend.*method)(own); });
    }

    template <class Args, class Run>
    void run_both(std::string_view name, const Args& args, Run&& run) {
        const auto run_on = [&](Backend& backend, Side side) {
            mapped(args, side, [&](const Args& own) { run(backend, own); });
        };
        const bool compared = position_of(name) <= last_compared_;
        Collect tables;
        if (compared) {
            mapped(args, tables, [](const Args&) {});
            // Those that are written too: what a stage leaves alone is then equal.
            for (const PairBuffer* table : tables.all) copy_to_second(*table);
        }
        run_on(*first_, {&PairBuffer::first});
        if (!compared) return;
        run_on(*second_, {&PairBuffer::second});
        for (const Output& output : tables.written) compare(name, output);
        ++summary_.stages;
    }

    static std::span<std::byte> content(Backend& backend, Buffer& buffer, std::size_t size,
                                        std::vector<std::byte>& memory) {
        memory.resize(size);
        backend.download(buffer, memory);
        return memory;
    }

    void copy_to_second(const PairBuffer& table) {
        second_->upload(*table.second,
                        content(*first_, *table.first, table.size(), first_content_));
    }

    void compare(std::string_view stage, const Output& output) {
        const std::size_t size = output.buffer.size();
        const auto a = content(*first_, *output.buffer.first, size, first_content_);
        const auto b = content(*second_, *output.buffer.second, size, second_content_);
        summary_.elements += size / output.layout.size();
        const auto difference = first_difference(output.layout, a, b);
        if (!difference) return;
        const std::string field =
            difference->field.empty() ? "" : ", " + output.layout.name + "::" + difference->field;
        throw MismatchError("stage " + std::string{stage} + " differs: " + output.name +
                            ", element " + std::to_string(difference->element) + field + ": " +
                            difference->first + " (" + first_->description() + "), " +
                            difference->second + " (" + second_->description() + ")");
    }

    std::unique_ptr<Backend> first_, second_;
    std::size_t last_compared_; ///< position of a stage
    Summary summary_;
    std::vector<std::byte> first_content_, second_content_;
};

} // namespace

std::unique_ptr<ComparingBackend> make_comparing_backend(std::unique_ptr<Backend> first,
                                                         std::unique_ptr<Backend> second,
                                                         std::string_view until) {
    return std::make_unique<Implementation>(std::move(first), std::move(second), until);
}

} // namespace lineatlas::compute
