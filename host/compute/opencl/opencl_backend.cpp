#include "opencl_backend.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string_view>

#include "core/limits.hpp"
#include "guarded.hpp"
#include "lineatlas/error.hpp"
#include "opencl_command_log.hpp"
#include "programs.hpp"

namespace lineatlas::compute {
namespace {

std::uint32_t divide_up(std::uint32_t n, std::uint32_t by) {
    return n / by + (n % by != 0 ? 1 : 0);
}

cl_float2 to_cl(glm::vec2 v) {
    return {{v.x, v.y}};
}
cl_int2 to_cl(glm::ivec2 v) {
    return {{v.x, v.y}};
}
cl_float4 to_cl(glm::vec4 v) {
    return {{v.x, v.y, v.z, v.w}};
}
cl_float16 to_cl(const glm::mat4& m) {
    cl_float16 result;
    std::memcpy(&result, &m, sizeof(result));
    return result;
}

/// Work-items of kernels that take runs in turns: enough for a GPU.
constexpr std::uint32_t most_items_in_turns = 1U << 14U;

const cl::Buffer& memory_of(Buffer& buffer) {
    return static_cast<OpenClBuffer&>(buffer).memory;
}

/// What can stand as a kernel argument.
const cl::Buffer& argument(Buffer& buffer) {
    return memory_of(buffer);
}
template <class T>
const T& argument(const T& value) {
    return value;
}

class Implementation final : public OpenClBackend {
  public:
    Implementation(const OpenClDevice& device, std::span<const cl_context_properties> properties,
                   const Tuning& tuning)
        : device_(device), tuning_(within_groups(tuning, device.device)),
          atlas_(make_atlas_kernels(tuning_, "")),
          tiled_atlas_(make_atlas_kernels(tuning_, " -DTILED")), scan_{ScanKernels{tuning_, false},
                                                                       ScanKernels{tuning_, true}} {
        guarded("creating a context", [&] {
            std::vector<cl_context_properties> all{
                CL_CONTEXT_PLATFORM, reinterpret_cast<cl_context_properties>(device.platform())};
            all.insert(all.end(), properties.begin(), properties.end());
            all.push_back(0);
            context_ = cl::Context{device.device, all.data()};
            queue_ = cl::CommandQueue{context_, device.device};
            programs_.emplace(device_, context_, user_program_cache(tuning_.program_cache));
        });
    }

    std::string description() const override { return device_.description(); }
    const OpenClDevice& device() const override { return device_; }
    const cl::Context& context() const override { return context_; }
    const cl::CommandQueue& queue() const override { return queue_; }

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
                                                 0, own.size(), nullptr, logged("map"));
        });
    }

    void end_host_access(Buffer& buffer) override {
        auto& own = static_cast<OpenClBuffer&>(buffer);
        if (own.mapped == nullptr) return;
        guarded("unmapping a buffer", [&] {
            queue_.enqueueUnmapMemObject(own.memory, own.mapped, nullptr, logged("unmap"));
            own.mapped = nullptr;
        });
    }

    void upload(Buffer& buffer, std::span<const std::byte> data) override {
        if (data.empty()) return;
        guarded("writing a buffer", [&] {
            queue_.enqueueWriteBuffer(memory_of(buffer), CL_TRUE, 0, data.size(), data.data(),
                                      nullptr, logged("write"));
        });
    }

    void upload_at(Buffer& buffer, std::size_t offset, std::span<const std::byte> data) override {
        if (data.empty()) return;
        guarded("writing a buffer", [&] {
            queue_.enqueueWriteBuffer(memory_of(buffer), CL_TRUE, offset, data.size(), data.data(),
                                      nullptr, logged("write"));
        });
    }

    void download(Buffer& buffer, std::span<std::byte> data) override {
        if (data.empty()) return finish();
        guarded("reading a buffer", [&] {
            queue_.enqueueReadBuffer(memory_of(buffer), CL_TRUE, 0, data.size(), data.data(),
                                     nullptr, logged("read"));
        });
    }

    void transform(const TransformArgs& args) override {
        launch(transform_, args.vertex_count, tuning_.local_size, args.rest, args.objects,
               args.matrices, args.vertex_count, args.vertices, args.drawn);
        launch(transform_boxes_, args.cluster_count, tuning_.local_size, args.rest_clusters,
               args.cluster_objects, args.matrices, args.cluster_count, args.clusters);
    }

    void bounds(const BoundsArgs& args) override {
        launch(transform_bounds_, args.count, tuning_.local_size, args.vertices, args.triangles,
               args.count, args.clusters);
    }

    void forget(const ForgetArgs& args) override {
        launch(transform_forget_, args.segment_count, tuning_.local_size, args.segments,
               args.segment_count, args.objects, args.jumped, args.ranges);
    }

    void pyramid(const PyramidArgs& args) override {
        const glm::ivec2 tiles = tiles_for(args.depth_size);
        launch(pyramid_, static_cast<std::uint32_t>(tiles.x * tiles.y), tuning_.local_size,
               args.depth, to_cl(args.depth_size), to_cl(tiles), args.tiles);
    }

    void cull(const CullArgs& args) override {
        launch(cull_, args.count, tuning_.local_size, args.clusters, args.count,
               to_cl(args.clip_from_world), to_cl(args.depth_size), args.tiles,
               to_cl(tiles_for(args.depth_size)), args.visible);
    }

    void facing(const FacingArgs& args) override {
        const std::uint32_t n = args.table.triangle_count;
        launch(facing_, n, tuning_.local_size, args.table.vertices, args.table.triangles, n,
               to_cl(args.eye), args.front);
    }

    void project_clip(const ProjectClipArgs& args) override {
        const std::uint32_t n = args.table.segment_count;
        // Without a pyramid any buffer will do: it isn't read.
        const OcclusionTest unused{args.table.vertices, {1, 1}, 1, 0, false};
        const OcclusionTest& test = args.occlusion != nullptr ? *args.occlusion : unused;
        const cl_uint use_tiles = args.occlusion == nullptr ? 0 : test.keep_clipped ? 2 : 1;
        launch(project_clip_, n, tuning_.local_size, args.table.segments, n, args.table.vertices,
               args.table.triangles, args.front, to_cl(args.clip_from_world),
               to_cl(args.world_from_clip), to_cl(args.viewport), args.step, args.kind_mask,
               test.tiles, to_cl(test.tile_count), use_tiles, test.depth_scale, test.tolerance,
               args.out.clipped, args.out.offsets, args.out.arcs);
    }

    void scan(Buffer& values, std::uint32_t n, ScanKind kind) override {
        if (n == 0) return clear(values, 1);
        ScanKernels& kernels = scan_[kind == ScanKind::saturate ? 1 : 0];
        if (!tuning_.scan_tiles) {
            const std::uint32_t chunks =
                std::max(tuning_.scan_chunks, divide_up(n, tuning_.longest_chunk));
            const std::uint32_t chunk = divide_up(n, chunks);
            Buffer& sums = scratch(scan_sums_, chunks);
            launch(kernels.chunks_reduce, chunks, 1, values, n, chunk, sums);
            launch(kernels.chunks_apply, chunks, 1, values, n, chunk, sums);
            return;
        }
        const std::uint32_t items = divide_up(n, tuning_.scan_per_item);
        const std::uint32_t tiles = divide_up(items, tuning_.scan_tile);
        Buffer& sums = scratch(scan_sums_, tiles);
        launch(kernels.tiles_reduce, items, tuning_.scan_tile, values, n, sums);
        launch(kernels.tiles_sums, tuning_.scan_tile, tuning_.scan_tile, sums, tiles);
        launch(kernels.tiles_apply, items, tuning_.scan_tile, values, n, sums);
    }

    void atlas(const AtlasArgs& args) override {
        const std::uint32_t blocks = divide_up(args.capacity, tuning_.atlas_block);
        const DepthTile tile = args.tile != nullptr ? *args.tile : DepthTile{};
        const cl_int4 core{{tile.core_low.x, tile.core_low.y, tile.core_high.x, tile.core_high.y}};
        auto& kernels = args.tile != nullptr ? tiled_atlas_ : atlas_;
        launch(kernels.at(args.probes - 1), blocks, tuning_.block_local_size, args.clipped.clipped,
               args.clipped.offsets, args.segment_count, args.depth, to_cl(args.depth_size),
               to_cl(args.viewport), args.depth_scale, args.tolerance, args.layout.width,
               args.layout.pitch, args.capacity, tuning_.atlas_block, to_cl(tile.origin), core,
               args.alpha);
    }

    void temporal(const TemporalArgs& args) override {
        const std::uint32_t n = args.segment_count;
        const cl_uint use_history = args.use_history ? 1 : 0;
        launch(temporal_, divide_up(n, tuning_.segment_block), tuning_.block_local_size,
               args.clipped.clipped, args.clipped.offsets, args.history.offsets, n,
               args.layout.width, args.layout.pitch, args.capacity, tuning_.segment_block,
               use_history, args.history.alpha, args.history.ranges, args.alpha);
        guarded("copying a buffer", [&] {
            queue_.enqueueCopyBuffer(
                memory_of(args.clipped.offsets), memory_of(args.history.offsets), 0, 0,
                (std::size_t{n} + 1) * sizeof(cl_uint), nullptr, logged("copy"));
            queue_.enqueueCopyBuffer(memory_of(args.alpha), memory_of(args.history.alpha), 0, 0,
                                     std::min(args.alpha.size(), args.history.alpha.size()),
                                     nullptr, logged("copy"));
        });
    }

    void compact_runs(const CompactRunsArgs& args) override {
        const std::uint32_t n = args.table.segment_count;
        const std::uint32_t blocks = divide_up(n, tuning_.segment_block);
        const cl_uint hidden = args.hidden ? 1 : 0;
        Buffer& counts = scratch(block_counts_, blocks + 1);
        launch(compact_runs_count_, blocks, tuning_.block_local_size, args.table.segments,
               args.clipped.offsets, args.clipped.arcs, hidden, n, args.alpha, args.layout.width,
               args.layout.pitch, args.capacity, tuning_.segment_block, counts);
        scan(counts, blocks, ScanKind::saturate);
        launch(compact_runs_write_, std::max(blocks, 1U), tuning_.block_local_size,
               args.table.segments, args.clipped.clipped, args.clipped.offsets, args.clipped.arcs,
               hidden, n, args.alpha, args.layout.width, args.layout.pitch, args.capacity,
               to_cl(args.viewport), args.half_width, tuning_.segment_block, counts, blocks,
               args.run_capacity, args.runs, args.record);
    }

    void filter(const FilterArgs& args) override {
        const std::uint32_t n = args.run_capacity;
        Buffer& counts = scratch(run_counts_, std::size_t{n} + 1);
        const cl_uint use_cuts = args.cuts != nullptr ? 1 : 0;
        Buffer& cuts = args.cuts != nullptr ? *args.cuts : args.runs; // any: it isn't read
        const auto step = [&](LazyKernel& kernel, auto&&... out) {
            launch(kernel, n, tuning_.block_local_size, args.table.segments, args.clipped.clipped,
                   args.clipped.offsets, args.clipped.arcs, args.alpha, args.layout.width,
                   args.layout.pitch, args.capacity, to_cl(args.viewport), args.half_width,
                   args.fill, args.drop, args.overshoot, args.overshoot_variation, args.undershoot,
                   args.runs, args.record, cuts, use_cuts, n, out...);
        };
        step(filter_count_, counts);
        scan(counts, n, ScanKind::saturate);
        step(filter_write_, counts, args.filtered_capacity, args.filtered, args.filtered_record);
        launch(filter_show_, args.filtered_capacity, tuning_.local_size, args.filtered,
               args.filtered_record, args.filtered_capacity, args.alpha);
        launch(filter_show_ends_, n, tuning_.local_size, args.table.segments, args.runs,
               args.record, n, args.alpha);
    }

    void halo(const HaloArgs& args) override {
        const glm::ivec2 tiles = (glm::ivec2{args.viewport} + (LA_HALO_TILE - 1)) / LA_HALO_TILE;
        const auto tile_count = static_cast<std::uint32_t>(tiles.x * tiles.y);
        const std::uint32_t items = std::min(args.run_capacity, most_items_in_turns);
        Buffer& ends = scratch(halo_ends_, tile_count + std::size_t{1});
        clear(ends, tile_count);
        launch(halo_count_, items, tuning_.local_size, args.runs, args.record, to_cl(tiles), ends);
        scan(ends, tile_count, ScanKind::saturate);
        cl_uint total = 0;
        guarded("reading a buffer", [&] {
            queue_.enqueueReadBuffer(memory_of(ends), CL_TRUE, tile_count * sizeof(cl_uint),
                                     sizeof(cl_uint), &total, nullptr, logged("read"));
        });
        constexpr std::size_t tables = 7; // of struct Lists
        if (total == 0xFFFFFFFFU) {       // where sums stop
            throw DeviceError(beyond_limit(purpose::halos, "over 4 billion pieces of lines",
                                           "kernels count to 4 billion"));
        }
        Buffer& lists = for_purpose(purpose::halos, [&]() -> Buffer& {
            return scratch(halo_lists_, (total + std::size_t{tuning_.halo_lanes}) * tables);
        });
        launch(halo_fill_, items, tuning_.local_size, args.runs, args.record, to_cl(tiles), ends,
               total, lists);
        launch(halo_cut_, items, tuning_.local_size, args.table.segments, args.clipped.clipped,
               args.runs, args.record, to_cl(tiles), args.halo + args.half_width, args.tolerance,
               ends, total, lists, args.cuts);
    }

    void density(const DensityArgs& args) override {
        const glm::ivec2 cells = density_cells(args.viewport);
        const auto plane = static_cast<std::uint32_t>(cells.x * cells.y);
        const std::uint32_t items = std::min(args.run_capacity, most_items_in_turns);
        cl_float8 of_kind{};
        std::ranges::copy(args.priority, of_kind.s);
        const auto rows = static_cast<cl_int>(LA_DENSITY_BINS) * cells.y;
        Buffer& grid = scratch(density_grid_, std::size_t{LA_DENSITY_BINS} * plane);
        Buffer& smooth = scratch(density_rows_, std::size_t{LA_DENSITY_BINS} * plane);
        clear(grid, std::size_t{LA_DENSITY_BINS} * plane);
        launch(density_lines_, items, tuning_.local_size, args.table.segments, args.clipped.arcs,
               args.alpha, args.record, of_kind, to_cl(cells), args.runs, grid);
        launch(density_smooth_, LA_DENSITY_BINS * plane, tuning_.local_size, grid, to_cl(cells),
               rows, smooth);
        Buffer& drawn = scratch(density_drawn_, plane);
        Buffer& excess = scratch(density_excesses_, plane);
        const auto share_out = [&](cl_uint again) {
            launch(density_weights_, plane, tuning_.local_size, grid, smooth, to_cl(cells),
                   args.limit, to_cl(args.focus), args.far_limit, again, excess, args.weights,
                   drawn);
        };
        share_out(0);
        launch(density_excess_, plane, tuning_.local_size, drawn, to_cl(cells), args.limit,
               to_cl(args.focus), args.far_limit, excess);
        share_out(1);
    }

    void intervals(const IntervalsArgs& args) override {
        const std::uint32_t n = args.table.segment_count;
        const std::uint32_t blocks = divide_up(n, tuning_.segment_block);
        const cl_uint wanted = args.hidden_too ? 3 : 1;
        Buffer& counts = scratch(block_counts_, blocks + 1);
        const auto step = [&](LazyKernel& kernel, auto&&... out) {
            launch(kernel, std::max(blocks, 1U), tuning_.block_local_size, args.table.segments,
                   args.clipped.clipped, args.clipped.offsets, args.clipped.arcs, n, args.alpha,
                   args.layout.width, args.layout.pitch, args.capacity, to_cl(args.viewport),
                   wanted, tuning_.segment_block, counts, out...);
        };
        step(intervals_count_);
        scan(counts, blocks, ScanKind::saturate);
        step(intervals_write_, blocks, args.interval_capacity, args.intervals, args.total);
        launch(intervals_refine_, args.interval_capacity, tuning_.local_size, args.table.segments,
               args.clipped.clipped, args.clipped.offsets, args.clipped.arcs, args.table.vertices,
               to_cl(args.viewport), args.depth, to_cl(args.depth_size), args.depth_scale,
               args.tolerance, args.interval_capacity, args.intervals, args.total);
    }

    void compact_samples(const CompactSamplesArgs& args) override {
        const std::uint32_t blocks = divide_up(args.count, tuning_.sample_block);
        Buffer& counts = scratch(block_counts_, blocks + 1);
        launch(compact_samples_count_, blocks, tuning_.block_local_size, args.alpha, args.count,
               tuning_.sample_block, counts);
        scan(counts, blocks, ScanKind::saturate);
        launch(compact_samples_write_, blocks, tuning_.block_local_size, args.alpha, args.count,
               tuning_.sample_block, counts, args.packed);
        guarded("copying a buffer", [&] {
            queue_.enqueueCopyBuffer(memory_of(counts), memory_of(args.packed_count),
                                     blocks * sizeof(cl_uint), 0, sizeof(cl_uint), nullptr,
                                     logged("copy"));
        });
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
        DeviceMemory::Part part = memory_.take(size);
        const cl_mem_flags flags =
            CL_MEM_READ_WRITE | (host != nullptr ? CL_MEM_USE_HOST_PTR : cl_mem_flags{});
        return guarded("making a buffer", [&] {
            try {
                return std::make_unique<OpenClBuffer>(cl::Buffer{context_, flags, size, host}, size,
                                                      std::move(part));
            } catch (const cl::Error& error) {
                memory_.check(error.err(), size);
                throw;
            }
        });
    }

    /// From the first profiled frame on.
    void keep_times() {
        guarded("creating a queue that keeps times", [&] {
            if ((queue_.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_PROFILING_ENABLE) != 0) return;
            queue_.finish();
            queue_ = cl::CommandQueue{context_, device_.device, CL_QUEUE_PROFILING_ENABLE};
        });
    }
    /// The event that a command about to be enqueued has in the log, if one is kept.
    OpenClCommandLog::Pending logged(const char* name) { return {log_.get(), name}; }

    template <class Action>
    auto guarded(std::string_view doing, Action&& action, std::string_view what = {}) const
        -> decltype(action()) {
        return compute::guarded(device_, doing, std::forward<Action>(action), what);
    }

    /// Launches `items` work-items, rounded up to whole work-groups of `local_size` or what fits.
    template <class... Args>
    void launch(LazyKernel& lazy, std::uint32_t items, std::uint32_t local_size, Args&&... args) {
        if (items == 0) return;
        programs_->make_ready(lazy);
        const auto enqueue = [&] {
            cl_uint index = 0;
            (lazy.kernel.setArg(index++, argument(args)), ...);
            const auto group =
                static_cast<std::uint32_t>(std::min<std::size_t>(local_size, lazy.largest_group));
            const std::size_t global = std::size_t{divide_up(items, group)} * group;
            queue_.enqueueNDRangeKernel(lazy.kernel, cl::NullRange, cl::NDRange{global},
                                        cl::NDRange{group}, nullptr, logged(lazy.name));
        };
        guarded("launching ", enqueue, lazy.name);
    }

    /// The kernels of one kind of sum.
    struct ScanKernels {
        ScanKernels(const Tuning& tuning, bool saturate)
            : defines("-DSCAN_SATURATE=" + std::to_string(saturate ? 1 : 0) +
                      " -DSCAN_TILE=" + std::to_string(tuning.scan_tile) +
                      " -DSCAN_PER_ITEM=" + std::to_string(tuning.scan_per_item)) {}

        std::string defines;
        LazyKernel chunks_reduce{"scan.cl", "scan_chunks_reduce", defines};
        LazyKernel chunks_apply{"scan.cl", "scan_chunks_apply", defines};
        LazyKernel tiles_reduce{"scan.cl", "scan_tiles_reduce", defines};
        LazyKernel tiles_sums{"scan.cl", "scan_tiles_sums", defines};
        LazyKernel tiles_apply{"scan.cl", "scan_tiles_apply", defines};
    };

    static std::array<LazyKernel, 4> make_atlas_kernels(const Tuning& tuning,
                                                        const std::string& defines) {
        return {make_atlas_kernel(tuning, 1, defines), make_atlas_kernel(tuning, 2, defines),
                make_atlas_kernel(tuning, 3, defines), make_atlas_kernel(tuning, 4, defines)};
    }

    static LazyKernel make_atlas_kernel(const Tuning& tuning, std::uint32_t probes_per_axis,
                                        const std::string& defines) {
        const std::uint32_t probes = probes_per_axis * probes_per_axis;
        const int lanes = !tuning.atlas_vectors || probes == 1 ? 1 : probes == 4 ? 4 : 16;
        return {"atlas.cl", "atlas",
                "-DPROBES_PER_AXIS=" + std::to_string(probes_per_axis) +
                    " -DPROBE_LANES=" + std::to_string(lanes) + defines};
    }

    /// A buffer of the backend's own for at least `count` uint32, kept from call to call.
    Buffer& scratch(std::unique_ptr<Buffer>& buffer, std::size_t count) {
        const std::size_t bytes = count * sizeof(cl_uint);
        if (buffer && buffer->size() >= bytes) return *buffer;
        buffer.reset(); // it may not fit beside another
        buffer = allocate(roomy(*this, bytes));
        return *buffer;
    }

    /// Sets the first `count` uint32 to 0.
    void clear(Buffer& buffer, std::size_t count) {
        guarded("clearing a buffer", [&] {
            queue_.enqueueFillBuffer(memory_of(buffer), cl_uint{0}, 0, count * sizeof(cl_uint),
                                     nullptr, logged("fill"));
        });
    }

    OpenClDevice device_;
    DeviceMemory memory_{device_.device};
    Tuning tuning_;
    cl::Context context_;
    cl::CommandQueue queue_;
    std::optional<Programs> programs_;      ///< of context_
    std::shared_ptr<OpenClCommandLog> log_; ///< while one is kept
    LazyKernel transform_{"transform.cl", "transform"};
    LazyKernel transform_boxes_{"transform.cl", "transform_boxes"};
    LazyKernel transform_bounds_{"transform.cl", "transform_bounds"};
    LazyKernel transform_forget_{"transform.cl", "transform_forget"};
    LazyKernel pyramid_{"pyramid.cl", "pyramid"};
    LazyKernel cull_{"cull.cl", "cull"};
    LazyKernel facing_{"facing.cl", "facing"};
    LazyKernel project_clip_{"project_clip.cl", "project_clip"};
    std::array<LazyKernel, 4> atlas_, tiled_atlas_; ///< by probes per axis, from 1
    LazyKernel temporal_{"temporal.cl", "temporal"};
    LazyKernel compact_runs_count_{"compact.cl", "compact_runs_count"};
    LazyKernel compact_runs_write_{"compact.cl", "compact_runs_write"};
    LazyKernel filter_count_{"filter.cl", "filter_count"};
    LazyKernel filter_write_{"filter.cl", "filter_write"};
    LazyKernel filter_show_{"filter.cl", "filter_show"};
    LazyKernel filter_show_ends_{"filter.cl", "filter_show_ends"};
    std::string probe_lanes_ = tuning_.atlas_vectors ? "-DPROBE_LANES=16" : "-DPROBE_LANES=1";
    LazyKernel intervals_count_{"intervals.cl", "intervals_count", probe_lanes_};
    LazyKernel intervals_write_{"intervals.cl", "intervals_write", probe_lanes_};
    LazyKernel intervals_refine_{"intervals.cl", "intervals_refine", probe_lanes_};
    LazyKernel compact_samples_count_{"compact.cl", "compact_samples_count"};
    LazyKernel compact_samples_write_{"compact.cl", "compact_samples_write"};
    std::string halo_lanes_ = "-DHALO_LANES=" + std::to_string(tuning_.halo_lanes);
    LazyKernel halo_count_{"halo.cl", "halo_count", halo_lanes_};
    LazyKernel halo_fill_{"halo.cl", "halo_fill", halo_lanes_};
    LazyKernel halo_cut_{"halo.cl", "halo_cut", halo_lanes_};
    LazyKernel density_lines_{"density.cl", "density_lines"};
    LazyKernel density_smooth_{"density.cl", "density_smooth"};
    LazyKernel density_weights_{"density.cl", "density_weights"};
    LazyKernel density_excess_{"density.cl", "density_excess"};
    ScanKernels scan_[2];
    std::unique_ptr<Buffer> scan_sums_;
    std::unique_ptr<Buffer> block_counts_, run_counts_;
    std::unique_ptr<Buffer> halo_ends_, halo_lists_;
    std::unique_ptr<Buffer> density_grid_, density_rows_, density_drawn_, density_excesses_;
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
