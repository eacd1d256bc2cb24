#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "carry_args.hpp"
#include "chain_args.hpp"
#include "depth_args.hpp"
#include "exact_args.hpp"
#include "fill_args.hpp"
#include "run_args.hpp"
#include "table_room.hpp"
#include "visibility_args.hpp"

namespace lineatlas::compute {

// Groups of one table, for launches, named as the kernel names its table.
struct Counts {
    Buffer& counts;
};
struct Offsets {
    Buffer& offsets;
};
struct BatchBoxes {
    Buffer& batches;
};
struct BlockOffsets {
    Buffer& block_offsets;
};

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
    /// Each table is taken by its name from the first of `groups` that has it.
    template <class K, class... Groups>
    requires(sizeof...(Groups) > 0 && (!std::same_as<Groups, typename K::Tables> &&
                                       ...)) void launch(std::uint32_t items,
                                                         const typename K::Parameters& parameters,
                                                         const Groups&... groups) {
        launch_grouped<K>(items, tuning_.local_size, parameters, groups...);
    }
    /// Launches a kernel whose only parameter is the number of its elements.
    template <class K>
    void launch_each(std::uint32_t count, const typename K::Tables& tables) {
        launch<K>(count, CountParameters{count}, tables);
    }
    template <class K, class... Groups>
    void launch_each(std::uint32_t count, const Groups&... groups) {
        launch<K>(count, CountParameters{count}, groups...);
    }

    void transform(const TransformArgs& args);
    /// Throws DeviceError for more clusters than the device can sort.
    void depth(const DepthArgs& args);
    void planes(const PlanesArgs& args);
    void pyramid(const PyramidArgs& args);
    void cull(const CullArgs& args);
    void facing(const FacingArgs& args);
    void contour(const ContourArgs& args);
    void silhouette(const SilhouetteArgs& args);
    void silhouette_list(const SilhouetteListArgs& args);
    void contour_places(const ContourPlacesArgs& args);
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
    void surfaces(const ExactArgs& args);
    /// Finds batches of segments or triangles that lie outside the picture or, if `drops_hidden`,
    /// behind faces that cover whole tiles. Call after occluders are found.
    void surfaces_batches(const ExactArgs& args, const BatchTable& batches, bool drops_hidden);
    void tile_lists(const ExactArgs& args);
    void visible(const ExactArgs& args); ///< waits if Tuning::face_lists
    /// The last step of visible() alone, for a table of spans that was too small for it.
    void visible_write(const ExactArgs& args);
    void span_runs(const SpanRunsArgs& args);
    void span_intervals(const SpanIntervalsArgs& args);
    void outline_seen(const OutlineSeenArgs& args);
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

  private:
    // With Tuning::face_lists: does the work of tile_lists_arrange.
    void arrange_by_entries(const ExactArgs& args, const ExactParameters& parameters,
                            Buffer& ranges);
    /// Does the work of visible_count piece by piece, for each segment in each tile. Waits.
    void count_pieces(const ExactArgs& args, const ExactParameters& parameters);
    template <class K>
    void launch_grouped(std::uint32_t items, std::uint32_t group,
                        const typename K::Parameters& parameters, const typename K::Tables& tables,
                        const Kernel& kernel = kernel_of<K>()) {
        if (items == 0) return;
        const auto list = K::list(tables);
        for (std::size_t i = 0; i < list.size(); ++i)
            if (kernel.tables[i].access != Access::in) ++list[i]->writes_;
        device_.launch({kernel, std::as_bytes(std::span{&parameters, 1}), list, items, group});
    }
    template <class K, class... Groups>
    requires(sizeof...(Groups) > 0 &&
             (!std::same_as<Groups, typename K::Tables> &&
              ...)) void launch_grouped(std::uint32_t items, std::uint32_t group,
                                        const typename K::Parameters& parameters,
                                        const Groups&... groups) {
        launch_grouped<K>(items, group, parameters, K::tables_of(groups...));
    }

    /// The blank tiles of `args`, or a table in which nothing is known to be blank.
    Buffer& blank_tiles(const DepthArgs& args);
    /// Where Tuning::depth_each, what depth_order and depth_tiles do.
    void depth_each(const DepthArgs& args, DepthParameters parameters, Buffer& places);
    /// The order of the clusters, and where each stands in it.
    void order_clusters(DepthParameters& parameters, Buffer& places, Buffer& order,
                        Buffer& positions);
    /// Of what `wanted` asks for, per block of segments, scanned.
    Buffer& count_spans(const SegmentTable& table, const ClippedTable& clipped,
                        const SpanTable& spans, const SpansParameters& parameters);
    /// Tables that stages keep from call to call only for their memory.
    enum class Scratch {
        scan_sums,
        block_counts,
        run_counts,
        halo_ends,
        depth_places,
        depth_boxes,
        depth_nearest,
        depth_order,
        depth_total,
        depth_next,
        depth_unasked,
        depth_no_numbers,
        depth_blank,
        // Where Tuning::depth_each:
        depth_counts,
        depth_positions,
        depth_texels,
        depth_large_count,
        depth_large,
        density_rows,
        density_drawn,
        density_excesses,
        corner_facing,
        stroke_boxes, // where Tuning::stroke_pixels
        // Of the method exact where Tuning::face_lists:
        list_ranges,
        list_keys,
        list_placed,
        piece_offsets,
        piece_parts,
        piece_kept,
        raw_parts,
        count
    };
    /// A table with room for at least `count` uint32.
    Buffer& scratch(Scratch name, std::size_t count) {
        scratch_.make_room(name, count * sizeof(la_uint));
        return scratch_[name];
    }

    Device& device_;
    const Tuning& tuning_; ///< of device_
    GrowingTables<Scratch> scratch_{device_, table::work_space};
    Table halo_lists_{device_, table::halo_lists};
};

} // namespace lineatlas::compute
