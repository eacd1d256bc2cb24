#include "kernel_forms.hpp"

#include <algorithm>
#include <string>

#include "compute/kernels.hpp"

namespace lineatlas::compute {
namespace {

/// Kernels with a work-item per block of elements.
constexpr std::string_view in_blocks[] = {
    "atlas",         "temporal",         "intervals_count", "intervals_write",    "spans_count",
    "spans_runs",    "spans_intervals",  "compact_count",   "compact_write",      "filter_count",
    "filter_write",  "tile_lists_count", "tile_lists_fill", "tile_lists_arrange", "fill_pixels",
    "strokes_count", "strokes_list"};
/// Kernels in work-groups of one.
constexpr std::string_view alone[] = {"scan_chunks_reduce", "scan_chunks_apply", "depth_order",
                                      "depth_tiles", "strokes_tiles"};

bool is_among(std::span<const std::string_view> names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

KernelForm form_of(const Kernel& kernel, const Tuning& tuning) {
    if (is_among(in_blocks, kernel.name)) return {&kernel, tuning.block_local_size, false};
    if (is_among(alone, kernel.name)) return {&kernel, 1, false};
    if (kernel.has_barriers) return {&kernel, tuning.scan_tile, false};
    return {&kernel, tuning.local_size, true};
}

/// Whether the frame of a whole picture launches this variant.
bool is_launched(const Kernel& kernel, std::uint32_t probes, const Tuning& tuning) {
    if (kernel.name == "scan_list") return kernel.defines == first_variant("scan_list").defines;
    if (kernel.stage == "scan") return kernel.has_barriers == tuning.scan_tiles;
    constexpr std::string_view without_face_lists[] = {"tile_lists_arrange", "visible_count",
                                                       "visible_write"};
    constexpr std::string_view with_face_lists[] = {
        "tile_lists_keys",  "tile_lists_place",  "tile_lists_sort", "tile_lists_write",
        "tile_lists_boxes", "tile_lists_behind", "visible_pieces",  "visible_cut",
        "visible_parts",    "visible_join",      "visible_spans"};
    if (is_among(without_face_lists, kernel.name)) return !tuning.face_lists;
    if (is_among(with_face_lists, kernel.name)) return tuning.face_lists;
    constexpr std::string_view each[] = {"depth_begin", "depth_keys",  "depth_positions",
                                         "depth_small", "depth_large", "depth_pairs",
                                         "depth_end",   "depth_seen"};
    if (is_among(each, kernel.name)) return tuning.depth_each;
    if (kernel.name == "depth_order") return !tuning.depth_each;
    if (kernel.name == "depth_tiles") return !tuning.depth_each && kernel.defines == "-DNUMBERED";
    if (kernel.name == "strokes_tiles") return !tuning.stroke_pixels;
    if (kernel.name == "strokes_boxes" || kernel.name == "strokes_pixels")
        return tuning.stroke_pixels;
    if (kernel.name == "atlas")
        return kernel.defines == "-DPROBES_PER_AXIS=" + std::to_string(probes);
    return true;
}

} // namespace

std::vector<KernelForm> kernel_forms(std::span<const std::string_view> stages, std::uint32_t probes,
                                     const Tuning& tuning) {
    std::vector<KernelForm> forms;
    for (const Kernel& kernel : all_kernels()) {
        if (is_among(stages, kernel.stage) && is_launched(kernel, probes, tuning))
            forms.push_back(form_of(kernel, tuning));
    }
    return forms;
}

IdleLaunches::IdleLaunches(Device& device) : device_(device) {
    constexpr std::size_t bytes = std::size_t{1} << 12U; // of any element, with its neighbours
    for (std::unique_ptr<Buffer>& table : tables_) {
        table = device_.allocate(bytes);
        device_.clear(*table, bytes);
    }
}

void IdleLaunches::launch(const KernelForm& form, bool many) {
    const std::vector<std::byte> parameters(form.kernel->parameter_size);
    std::array<Buffer*, most_tables> tables{};
    std::ranges::transform(tables_, tables.begin(), [](const auto& table) { return table.get(); });
    device_.launch({*form.kernel, parameters, std::span{tables}.first(form.kernel->tables.size()),
                    many ? many_items : form.group, form.group});
    device_.finish();
}

} // namespace lineatlas::compute
