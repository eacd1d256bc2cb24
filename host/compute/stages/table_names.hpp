#pragma once

#include <string_view>

#include "core/limits.hpp"

namespace lineatlas::compute {

/// The name of a table in lists of memory, and its purpose. docs/architecture.md says how large
/// each is.
struct TableName {
    std::string_view name;
    const Purpose& purpose;
};

/// All tables, in the order of a frame.
namespace table {

using namespace purpose;

// Once per model.
inline constexpr TableName vertices{"vertices", model}, triangles{"triangles", model},
    line_segments{"segments", segments}, end_offsets{"end offsets", segments},
    ends{"ends", segments}, contour_corners{"contour corners", segments},
    contour_edges{"contour edges", segments},
    contour_face_corners{"contour face corners", segments},
    contour_faces{"contour faces", segments}, contour_patches{"contour patches", segments},
    clusters{"clusters", model}, meshlets{"meshlets", model},
    meshlet_vertices{"meshlet vertices", model}, meshlet_corners{"meshlet corners", model},
    triangle_numbers{"triangle numbers", model}, triangle_patches{"triangle patches", model},
    colors{"colors", fill}, smooth_corners{"smooth corners", fill},
    batch_boxes{"batch boxes", segments}, segment_pens{"segment pens", strokes}, mark{"mark", pen};

// Of a model that moves.
inline constexpr TableName cluster_triangles{"cluster triangles", motion},
    objects{"objects", motion}, cluster_objects{"cluster objects", motion},
    matrices{"matrices", motion}, jumped{"jumped objects", motion}, turns{"turns", motion},
    moved_vertices{"moved vertices", motion}, moved_clusters{"moved clusters", motion},
    turned_corners{"turned corners", motion}, drawn_vertices{"drawn vertices", motion},
    corner_place_offsets{"corner place offsets", motion}, corner_places{"corner places", motion};

// Per frame.
inline constexpr TableName depth_texels{"depth", depth}, seen_numbers{"seen numbers", depth},
    blank_tiles{"blank tiles", depth}, pyramid{"pyramid", depth},
    visible_clusters{"visible clusters", model}, planes{"planes", model},
    clipped{"clipped segments", segments}, offsets{"offsets", segments}, arcs{"arcs", segments},
    batch_states{"batch states", segments}, alpha{"alpha", atlas}, no_alpha{"no alpha", exact},
    no_offsets{"no offsets", segments}, outline_offsets{"outline offsets", segments},
    outline_parts{"outline parts", segments}, intervals{"intervals", purpose::intervals},
    interval_total{"interval total", purpose::intervals}, runs{"runs", strokes},
    records{"records", strokes}, raw_runs{"raw runs", strokes}, halo_cuts{"halo cuts", halos},
    halo_lists{"halo lists", halos}, density_weights{"density weights", density},
    density_grid{"density grid", density}, stroke_ends{"stroke ends", strokes},
    stroke_total{"stroke total", strokes}, stroke_entries{"stroke entries", strokes},
    coverage{"coverage", strokes}, shown_tiles{"shown tiles", strokes},
    shaded_colors{"shaded colors", fill}, pixels{"pixels", picture};

// What `temporal` keeps of the frame before.
inline constexpr TableName alpha_before{"alpha before", atlas},
    offsets_before{"offsets before", segments}, ranges_before{"ranges before", segments},
    positions_before{"positions before", segments};

// Of stages that keep several.
inline constexpr TableName chain_front{"chain front", segments},
    chain_numbers{"chain numbers", segments}, chain_positions{"chain positions", segments},
    chain_ordered{"chain ordered", segments}, chain_chosen{"chain chosen", segments},
    chain_total{"chain total", segments}, chain_ways{"chain ways", segments},
    chain_longer{"chain longer", segments}, chain_going{"chain going", segments},
    chain_places{"chain places", segments}, chain_starts{"chain starts", segments},
    chain_origins{"chain origins", segments}, contour_vertices{"contour vertices", segments},
    contour_crossings{"contour crossings", segments};
inline constexpr TableName carry_memory{"carry memory", segments},
    carry_lengths{"carry lengths", segments}, carry_found{"carry found", segments},
    carry_kept{"carry kept", segments}, carry_breaks{"carry breaks", segments},
    carry_means{"carry means", segments}, carry_pieces{"carry pieces", segments},
    carry_recalled{"carry recalled", segments}, carry_list{"carry list", segments},
    carry_shifts{"carry shifts", segments}, carried{"carried", segments};
inline constexpr TableName exact_screen{"exact screen", exact}, exact_faces{"exact faces", exact},
    exact_planes{"exact planes", exact}, exact_kept{"exact kept", exact},
    exact_span_offsets{"exact span offsets", exact}, exact_occluders{"exact occluders", exact},
    exact_ends{"exact ends", exact}, exact_groups{"exact groups", exact},
    exact_entries{"exact entries", exact}, exact_blocks{"exact blocks", exact},
    exact_boxes{"exact boxes", exact}, exact_spans{"exact spans", exact},
    exact_numbers{"exact numbers", exact}, exact_seen{"exact seen", exact},
    exact_pushed{"exact pushed", exact}, exact_part_offsets{"exact part offsets", exact},
    exact_parts{"exact parts", exact}, exact_beside_kept{"exact beside kept", exact},
    exact_beside_offsets{"exact beside offsets", exact},
    exact_beside_spans{"exact beside spans", exact}, exact_within_kept{"exact within kept", exact},
    exact_within_offsets{"exact within offsets", exact},
    exact_within_spans{"exact within spans", exact};

/// Work space of kernels, whatever the stage.
inline constexpr TableName work_space{"work space", scratch};

} // namespace table
} // namespace lineatlas::compute
