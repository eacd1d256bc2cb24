#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "depth_args.hpp"
#include "exact_args.hpp"
#include "fill_args.hpp"
#include "run_args.hpp"
#include "table_room.hpp"
#include "visibility_args.hpp"

namespace lineatlas::compute {

struct CarryArgs;
struct ChainArgs;
struct ChainTables;

/// The stages that kernels run. Each function launches the kernels of a stage, in the same order
/// and on the same tables on every device. It is as asynchronous as the device.
class Stages {
  public:
    /// `device` must outlive it.
    explicit Stages(Device& device) : device_(device), tuning_(device.tuning()) {}

    Device& device() const { return device_; }

    /// Launches `items` work-items of one kernel, or nothing if there are none.
    template <class K>
    void launch(std::uint32_t items, const typename K::Parameters& parameters,
                const typename K::Tables& tables) {
        launch_grouped<K>(items, tuning_.local_size, parameters, tables);
    }
    /// Each table is taken by its name from the first of `groups` that has it. Another table, which
    /// is not read, stands for one that is null there. Throws std::logic_error if the kernel writes
    /// that one.
    template <class K, class... Groups>
    void launch(std::uint32_t items, const typename K::Parameters& parameters,
                const Groups&... groups) {
        launch_grouped<K>(items, tuning_.local_size, parameters, groups...);
    }
    /// The tables of `own` are taken before those of the groups; null: the launch does without it.
    template <class K, class Group, class... Groups>
    void launch(std::uint32_t items, const typename K::Parameters& parameters,
                const typename K::template Own<Group, Groups...>& own, const Group& group,
                const Groups&... groups) {
        launch_variant<K>(0, items, tuning_.local_size, parameters, own, group, groups...);
    }
    /// Launches a kernel whose only parameter is the number of its elements.
    template <class K>
    void launch_each(std::uint32_t count, const typename K::Tables& tables) {
        launch_grouped<K>(count, tuning_.local_size, CountParameters{count}, tables);
    }
    template <class K, class... Groups>
    void launch_each(std::uint32_t count, const Groups&... groups) {
        launch_grouped<K>(count, tuning_.local_size, CountParameters{count}, groups...);
    }
    /// As launch(), in work-groups of `group`.
    template <class K, class... Groups>
    void launch_grouped(std::uint32_t items, std::uint32_t group,
                        const typename K::Parameters& parameters, const Groups&... groups) {
        launch_variant<K>(0, items, group, parameters, groups...);
    }
    template <class K, class Group, class... Groups>
    void launch_grouped(std::uint32_t items, std::uint32_t group,
                        const typename K::Parameters& parameters,
                        const typename K::template Own<Group, Groups...>& own, const Group& first,
                        const Groups&... groups) {
        launch_variant<K>(0, items, group, parameters, own, first, groups...);
    }
    /// The same of one of the kernel's variants, see kernel_of().
    template <class K, class... Groups>
    void launch_variant(std::uint32_t variant, std::uint32_t items, std::uint32_t group,
                        const typename K::Parameters& parameters, const Groups&... groups) {
        if (items == 0) return;
        const Kernel& kernel = kernel_of<K>(variant);
        auto list = K::list_of(groups...);
        Buffer* stand_in = nullptr;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const bool is_written = kernel.tables[i].access != Access::in;
            if (is_written && list[i] == nullptr)
                throw std::logic_error{"a launch lacks a table that its kernel writes"};
            if (is_written) ++list[i]->writes_;
            if (stand_in == nullptr) stand_in = list[i];
        }
        for (Buffer*& table : list)
            if (table == nullptr) table = stand_in;
        device_.launch({kernel, std::as_bytes(std::span{&parameters, 1}), list, items, group});
    }

    /// Throws DeviceError for more clusters than the device can sort.
    void depth(const DepthArgs& args);
    /// `tiles`, out: a float per tile of a depth buffer as in DepthBuffer, row by row.
    void pyramid(Buffer& depth, glm::ivec2 depth_size, Buffer& tiles);
    /// `eye`: Camera::eye(). `front`, out: a byte per triangle.
    void facing(const SegmentTable& table, const glm::vec4& eye, Buffer& front);
    /// Which faces contours cross.
    void contour(const SegmentTable& table, const glm::vec4& eye, const ChainTables& tables);
    /// Which candidates are silhouettes. `front`: of `facing`.
    void silhouette(const SegmentTable& table, Buffer& front, const ChainTables& tables);
    /// `capacity`: silhouettes that `tables` have room for.
    void silhouette_list(const SilhouetteCandidates& candidates, std::uint32_t capacity,
                         const ChainTables& tables);
    /// Where contours cross faces. Call contour() for the same eye before.
    void contour_places(const ChainArgs& args, Buffer& front);
    void chain(const ChainArgs& args);
    /// Finds those of args.batches that lie outside the frustum or, if `drops_hidden`, behind the
    /// pyramid. Then the pyramid must be that of numbered triangles, and nobody may need lengths of
    /// lines.
    void project_clip_batches(const ProjectClipArgs& args, bool drops_hidden);
    void project_clip(const ProjectClipArgs& args);
    /// `values`: n inputs and room for one more; see kernels/scan.cl.
    void scan(Buffer& values, std::uint32_t n, ScanKind kind);
    void carry(const CarryArgs& args);
    void atlas(const AtlasArgs& args);
    void temporal(const TemporalArgs& args);
    void intervals(const IntervalsArgs& args);

    void span_runs(const SpanRunsArgs& args);
    void span_intervals(const SpanIntervalsArgs& args);
    /// Finds segments with visible parts that may be outline. `numbers`, out: how many such
    /// segments there are before each, and in all.
    void outline_seen(const SegmentTable& table, const ClippedTable& clipped,
                      const SpanTable& spans, Buffer& numbers);
    void outline_parts(const OutlinePartsArgs& args);
    void outline_samples(const OutlineSamplesArgs& args);
    void pens(const PensArgs& args);
    void compact(const CompactArgs& args);
    void fill(const FillArgs& args);
    void halo(const HaloArgs& args); ///< waits: the host sizes a table of its own
    void filter(const FilterArgs& args);
    void density(const DensityArgs& args);
    void list_strokes(const StrokeListArgs& args);
    void draw_strokes(const StrokeArgs& args);

    /// Where Tuning::face_lists, the work space of the exact method's lists and of the pieces of
    /// lines in each tile.
    struct ExactScratch {
        Device& device;
        ScratchTable ranges{device}, keys{device}, placed{device};
        ScratchTable piece_offsets{device}, part_offsets{device}, piece_kept{device},
            raw_parts{device};
    };
    ExactScratch& exact_scratch() { return exact_; }

  private:
    /// The blank tiles of `args`, or a table in which nothing is known to be blank.
    Buffer& blank_tiles(const DepthArgs& args);
    /// With Tuning::depth_each in place of depth_order and depth_tiles.
    void depth_each(const DepthArgs& args, DepthParameters parameters);
    /// The order of the clusters, and where each stands in it.
    void order_clusters(DepthParameters& parameters);
    /// Counts per block of segments by kernel `Count`, and writes what was counted by `Write`,
    /// which gets the sums of the counts.
    template <class Count, class Write, class... Groups>
    void write_blocks(const typename Count::Parameters& parameters, const Groups&... groups) {
        const std::uint32_t blocks = parameters.blocks;
        Buffer& counts = block_counts_.with_room(blocks + 1);
        launch_grouped<Count>(blocks, tuning_.block_local_size, parameters, {.counts = &counts},
                              groups...);
        scan(counts, blocks, ScanKind::saturate);
        // The first work-item also writes how many there are.
        launch_grouped<Write>(std::max(blocks, 1U), tuning_.block_local_size, parameters,
                              {.block_offsets = &counts}, groups...);
    }
    Device& device_;
    const Tuning& tuning_; ///< of device_
    /// The work space of `depth`.
    struct DepthScratch {
        Device& device;
        ScratchTable places{device}, order{device}, unasked{device}, no_numbers{device},
            blank_tiles{device};
        ScratchTable boxes{device}, nearest{device}, total{device}, next{device};
        // Where Tuning::depth_each:
        ScratchTable key_counts{device}, positions{device}, texels{device}, large_count{device},
            large_list{device};
    };
    DepthScratch depth_{device_};
    ExactScratch exact_{device_};
    ScratchTable scan_sums_{device_}, block_counts_{device_}, run_counts_{device_},
        halo_ends_{device_}, corner_facing_{device_};
    ScratchTable density_rows_{device_}, density_drawn_{device_}, density_excesses_{device_};
    ScratchTable stroke_boxes_{device_}; ///< where Tuning::stroke_pixels
    Table halo_lists_{device_, table::halo_lists};
};

} // namespace lineatlas::compute
