/* depth: the depth of the triangles in every texel (§3.2), the compute form.
 *
 * Three steps. Clusters of triangles get their place on the screen, are sorted front to back, and
 * drawn into tiles of the depth buffer. A work-item draws one tile at a time, in local memory, and
 * takes the next one when it is done. Rows of that memory are a little longer than the tile,
 * because with a power of two all of a column would fall into a few lines of the cache. The
 * work-item leaves out clusters and triangles that lie behind the farthest depth of all blocks of
 * texels they touch (Greene et al. 1993). Coverage is decided as GL does it: by texel centres, in
 * fixed point, and an edge of two triangles belongs to one of them.
 *
 * With Tuning::depth_each (depth_each.h) each triangle draws itself. Then clusters are sorted in
 * chunks, all triangles that may be seen draw into a table of texels, small triangles first, and
 * depth_end stores what the table holds.
 *
 * DEPTH_TILE: texels a side, whole blocks of LA_TILE. DEPTH_LANES: triangles that are set up at
 * once, and texels that are filled at once, 1 on GPUs. NUMBERED: each texel also gets the number of
 * the triangle that it shows. */

#define LANES DEPTH_LANES
#include "depth_triangle.h"
#include "shared/screen_box.h"

/* Whether the cluster can be seen, and where. */
KERNEL(depth_bin, DepthParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    seen[i] = 0;
    places[i].key = LA_OUT_OF_VIEW;
    const ScreenBox box = box_on_screen(to_matrix(args.clip_from_world), &clusters[i]);
    if (box.is_outside) return;
    const int2 size = to_int2(args.depth_size);
    const float2 last = convert_float2(size - 1);
    float2 from = 0.0f, to = last;
    float nearest = 0.0f;
    if (!box.before_near) { /* else its corners don't bound it on the screen */
        const float2 scale = convert_float2(to_int2(args.whole_size)) * 0.5f;
        const float2 origin = convert_float2(to_int2(args.origin));
        /* One texel to spare for the grid that corners are rounded to. */
        from = fmax((xy(box.low) + 1.0f) * scale - (origin + 1.0f), from);
        to = fmin((xy(box.high) + 1.0f) * scale - (origin - 1.0f), to);
        if (from.x > to.x || from.y > to.y) return;
        nearest = fmax(box.low.z * 0.5f + 0.5f - PLANE_ROUNDING, 0.0f);
    }
    places[i].low_x = int_of(from.x);
    places[i].low_y = int_of(from.y);
    places[i].high_x = int_of(to.x);
    places[i].high_y = int_of(to.y);
    places[i].nearest = nearest;
    /* The exponent of the inverse distance from the far end, and the upper bits of its mantissa:
     * steps grow with the distance from the eye, as window depth wants it. */
    const uint inverse = as_uint(1.0f / (1.0f + 4.0f * LA_DEPTH_ROUNDING - fmin(nearest, 1.0f)));
    places[i].key = min((inverse - as_uint(1.0f)) >> 17, LA_DEPTH_KEYS - 1u);
}

/* Sorts the clusters that can be seen by their keys, by counting, in one work-item: there are few.
 * boxes: `stride` of low x each, then of low y, high x and high y. */
KERNEL(depth_order, DepthParameters) {
    if (get_global_id(0) != 0) return;
    uint ends[LA_DEPTH_KEYS + 1u];
    for (uint k = 0; k <= LA_DEPTH_KEYS; ++k) ends[k] = 0;
    for (uint i = 0; i < args.count; ++i) ends[places[i].key] += 1u;
    uint sum = 0;
    for (uint k = 0; k < LA_DEPTH_KEYS; ++k) {
        const uint count = ends[k];
        ends[k] = sum;
        sum += count;
    }
    total[0] = sum;
    for (uint i = 0; i < args.count; ++i) {
        const ClusterPlace own = places[i];
        if (own.key == LA_OUT_OF_VIEW) continue;
        const uint place = ends[own.key]++;
        order[place] = i;
        nearest[place] = own.nearest;
        boxes[place] = own.low_x;
        boxes[args.stride + place] = own.low_y;
        boxes[2u * args.stride + place] = own.high_x;
        boxes[3u * args.stride + place] = own.high_y;
    }
    for (uint k = 0; k < LA_MESHLET_PADDING; ++k) { /* lanes beyond the last touch nothing */
        boxes[sum + k] = 0x7FFFFFFF;
        boxes[args.stride + sum + k] = 0x7FFFFFFF;
        boxes[2u * args.stride + sum + k] = -1;
        boxes[3u * args.stride + sum + k] = -1;
    }
}

/* Which of LANES clusters touch the tile, bit by bit. */
INLINED uint touching(const Tile* tile, __global const int* boxes, const uint stride,
                      const int2 origin) {
    const lanes_int left = tile->low.x - origin.x, right = left + (tile->size.x - 1);
    const lanes_int below = tile->low.y - origin.y, above = below + (tile->size.y - 1);
    return LANE_BITS((LOAD_INTS(boxes) <= right) & (LOAD_INTS(boxes + stride) <= above) &
                     (LOAD_INTS(boxes + 2u * stride) >= left) &
                     (LOAD_INTS(boxes + 3u * stride) >= below));
}

/* Draws all triangles that touch the tile. Returns false if there are none. */
INLINED bool draw_tile(const DepthParameters* args, const View* view, Tile* tile,
                       __global const int* boxes, __global const float* nearest,
                       __global const uint* order, const uint total,
                       __global const Cluster* clusters, __global const Meshlet* meshlets,
                       __global const uint* vertex_list, __global const uchar* corners,
                       __global const float* vertices, __global uint* seen) {
    const int2 origin = to_int2(args->origin);
    const int2 corner = tile->low - origin; /* in `depth` */
    bool any = false;
    const uint end = min(args->end, total);
    for (uint first = args->begin; first < end; first += LANES) {
        uint bits = touching(tile, boxes + first, args->stride, origin);
        while (bits != 0) {
            const uint k = first + lowest_bit(bits);
            bits &= bits - 1u;
            if (k >= end) break;
            any = true;
            const int4 box =
                int4(max(boxes[k] - corner.x, 0), max(boxes[args->stride + k] - corner.y, 0),
                     min(boxes[2u * args->stride + k] - corner.x, tile->size.x - 1),
                     min(boxes[3u * args->stride + k] - corner.y, tile->size.y - 1));
            if (!cluster_shows(tile, box, nearest[k])) continue;
            const uint cluster = order[k];
            atomic_max(seen + cluster, 1u); /* other tiles may say so at the same time */
            draw_meshlet(view, tile, clusters[cluster].first, meshlets[cluster], vertex_list,
                         corners, vertices);
        }
    }
    return any;
}

/* next: counts the tiles that have been taken; 0 before. pyramid: as `pyramid` leaves it. blank:
 * for each of its tiles 1 if the kept depth is known to show nothing there, before the launch and
 * after it. seen[i]: 1 if cluster i was drawn anywhere. */
KERNEL(depth_tiles, DepthParameters) {
    LOCAL_TABLE(float, texels, TILE_STRIDE* DEPTH_TILE);
#ifdef NUMBERED
    LOCAL_TABLE(int, texel_numbers, TILE_STRIDE* DEPTH_TILE);
#endif
    const int2 tiles = to_int2(args.tiles), origin = to_int2(args.origin);
    const int2 depth_size = to_int2(args.depth_size), covered = to_int2(args.covered);
    const uint tile_count = (uint)(tiles.x * tiles.y);
    /* If there is a work-item for each tile, none takes a second tile, because drivers may end long
     * loops. */
    const bool one_each = get_global_size(0) >= tile_count;
    const View view = make_view(&args);
    Tile tile;
    tile.texels = texels;
#ifdef NUMBERED
    tile.numbers = texel_numbers;
#else
    tile.numbers = 0;
#endif
    tile.begins = args.begin == 0;
    tile.keeps_depth = args.keeps_depth != 0;
    tile.width = depth_size.x;
    tile.blocks_a_row = (depth_size.x + LA_TILE - 1) / LA_TILE;
    for (uint t = atomic_inc(next); t < tile_count; t = one_each ? tile_count : atomic_inc(next)) {
        const int2 place = int2((int)t % tiles.x, (int)t / tiles.x);
        const int2 corner = covered + int2(place.x * DEPTH_TILE, place.y * DEPTH_TILE);
        tile.low = corner + origin;
        tile.size = int2(min(depth_size.x - corner.x, DEPTH_TILE),
                         min(depth_size.y - corner.y, DEPTH_TILE));
        const size_t first = (size_t)corner.y * (size_t)depth_size.x + (size_t)corner.x;
        const int first_block = corner.y / LA_TILE * tile.blocks_a_row + corner.x / LA_TILE;
        tile.depth = depth + first;
        tile.depth_numbers = (__global int*)numbers + first;
        tile.pyramid = pyramid + first_block;
        tile.blank = blank + first_block;
        begin_tile(&tile);
        const bool any = draw_tile(&args, &view, &tile, boxes, nearest, order, total[0], clusters,
                                   meshlets, vertex_list, corners, vertices, seen);
        if (any || tile.begins) store_tile(&tile);
    }
}

#ifndef NUMBERED
#include "depth_each.h"

/* One work-item per texel. */
KERNEL(depth_begin, DepthParameters) {
    const uint i = (uint)get_global_id(0);
    const int2 size = to_int2(args.depth_size);
    if (i >= (uint)size.x * (uint)size.y) return;
    texels[i].rank = LA_NO_RANK;
    texels[i].order = order_of(1.0f);
}

/* The clusters of a chunk. */
static uint2 clusters_of(const DepthParameters* args, const uint chunk) {
    return uint2(min(chunk * args->chunk, args->count),
                 min((chunk + 1u) * args->chunk, args->count));
}

/* counts: for each key and chunk the number of clusters; all 0 before. One work-item per chunk. */
KERNEL(depth_keys, DepthParameters) {
    const uint chunk = (uint)get_global_id(0);
    if (chunk >= args.chunks) return;
    const uint2 own = clusters_of(&args, chunk);
    for (uint i = own.x; i < own.y; ++i) {
        if (places[i].key != LA_OUT_OF_VIEW) counts[places[i].key * args.chunks + chunk] += 1u;
    }
}

/* Writes the order that depth_order writes. counts: scanned. positions: the place of each cluster
 * in `order`. */
KERNEL(depth_positions, DepthParameters) {
    const uint chunk = (uint)get_global_id(0);
    if (chunk >= args.chunks) return;
    const uint2 own = clusters_of(&args, chunk);
    for (uint i = own.x; i < own.y; ++i) {
        if (places[i].key == LA_OUT_OF_VIEW) continue;
        const uint at = counts[places[i].key * args.chunks + chunk]++;
        positions[i] = at;
        order[at] = i;
    }
}

/* Fills small triangles and lists the others. The pass for ranks, which follows that for depths,
 * uses the same list. One work-item per triangle of a full cluster. */
KERNEL(depth_small, DepthParameters) {
    const uint i = (uint)get_global_id(0);
    const uint cluster = i / LA_MESHLET_TRIANGLES, t = i % LA_MESHLET_TRIANGLES;
    if (cluster >= args.count || places[cluster].key == LA_OUT_OF_VIEW) return;
    const Meshlet meshlet = meshlets[cluster];
    if (t >= meshlet.triangle_count) return;
    const View view = make_view(&args);
    Target to;
    make_target(&args, texels, &to);
    const OneTriangle one = one_triangle(&view, meshlet, t, vertex_list, corners, vertices);
    bool in_pairs = is_cut(&one), wide = false;
    if (!in_pairs) {
        const int4 box = within(&to, texels_of(one.a, one.b, one.c, &in_pairs));
        if (is_empty(box)) return;
        if (!in_pairs && (box.z - box.x + 1) * (box.w - box.y + 1) <= FEW_TEXELS) {
            if (args.numbered != 0)
                to.rank = rank_of(positions[cluster], t, SET_UP_IN_INTS, (uint)args.lanes);
            fill_small(&to, one.a, one.b, one.c, box);
            return;
        }
        wide = is_wide(box, args.side);
    }
    if (to.finds != LA_FINDS_RANKS)
        large_list[atomic_inc(large_count)] =
            i | (in_pairs ? SET_UP_IN_PAIRS : 0u) | (wide ? WIDE : 0u);
}

/* Fills the triangles that depth_small has listed and that ints hold. LA_DEPTH_SHARE work-items per
 * triangle, which take further ones. */
KERNEL(depth_large, DepthParameters) {
    const uint share = (uint)get_global_id(0) % LA_DEPTH_SHARE;
    const uint step = max((uint)get_global_size(0) / LA_DEPTH_SHARE, 1u);
    const View view = make_view(&args);
    Target to;
    make_target(&args, texels, &to);
    for (uint e = (uint)get_global_id(0) / LA_DEPTH_SHARE; e < large_count[0]; e += step) {
        const bool wide = (large_list[e] & WIDE) != 0;
        if ((large_list[e] & SET_UP_IN_PAIRS) != 0 || !has_share(share, wide)) continue;
        const uint entry = large_list[e] & ~WIDE;
        const uint cluster = entry / LA_MESHLET_TRIANGLES, t = entry % LA_MESHLET_TRIANGLES;
        const OneTriangle one =
            one_triangle(&view, meshlets[cluster], t, vertex_list, corners, vertices);
        if (args.numbered != 0)
            to.rank = rank_of(positions[cluster], t, SET_UP_IN_INTS, (uint)args.lanes);
        bool large;
        const int4 box = within(&to, texels_of(one.a, one.b, one.c, &large));
        fill_shared(&to, one.a, one.b, one.c, box, wide, share);
    }
}

/* As depth_large, for triangles that ints don't hold, and for those that planes of the view cut. */
KERNEL(depth_pairs, DepthParameters) {
    const uint share = (uint)get_global_id(0) % LA_DEPTH_SHARE;
    const uint step = max((uint)get_global_size(0) / LA_DEPTH_SHARE, 1u);
    const View view = make_view(&args);
    Target to;
    make_target(&args, texels, &to);
    for (uint e = (uint)get_global_id(0) / LA_DEPTH_SHARE; e < large_count[0]; e += step) {
        if ((large_list[e] & SET_UP_IN_PAIRS) == 0) continue;
        const uint entry = large_list[e] & ~(SET_UP_IN_PAIRS | WIDE);
        const uint cluster = entry / LA_MESHLET_TRIANGLES, t = entry % LA_MESHLET_TRIANGLES;
        const OneTriangle one =
            one_triangle(&view, meshlets[cluster], t, vertex_list, corners, vertices);
        const bool cut = is_cut(&one);
        if (args.numbered != 0)
            to.rank = rank_of(positions[cluster], t, cut ? CUT : LARGE, (uint)args.lanes);
        if (cut)
            fill_cut(&to, &view, vload3(one.i, vertices), vload3(one.j, vertices),
                     vload3(one.k, vertices), share);
        else
            fill_in_pairs(&to, one.a, one.b, one.c, share);
    }
}

/* Stores depths and numbers, and what blocks show, as store_tile() does. One work-item per block of
 * LA_TILE texels a side, of those in the tiles. */
KERNEL(depth_end, DepthParameters) {
    const int2 size = to_int2(args.depth_size), low = to_int2(args.covered);
    const int2 high = end_of_tiles(&args);
    const int columns = (high.x - low.x + LA_TILE - 1) / LA_TILE;
    const int rows = (high.y - low.y + LA_TILE - 1) / LA_TILE;
    const int i = (int)get_global_id(0);
    if (columns <= 0 || i >= columns * rows) return;
    const int2 from = low + int2(i % columns * LA_TILE, i / columns * LA_TILE);
    const int2 to = int2(min(from.x + LA_TILE, high.x), min(from.y + LA_TILE, high.y));
    float farthest = 0.0f, nearest = 1.0f;
    for (int y = from.y; y < to.y; ++y) {
        for (int x = from.x; x < to.x; ++x) {
            const float z = depth_of(texels[(size_t)y * (size_t)size.x + (size_t)x].order);
            farthest = fmax(farthest, z);
            nearest = fmin(nearest, z);
        }
    }
    const int block = from.y / LA_TILE * ((size.x + LA_TILE - 1) / LA_TILE) + from.x / LA_TILE;
    const bool is_blank = nearest >= 1.0f, was_blank = blank[block] != 0;
    pyramid[block] = farthest;
    blank[block] = is_blank ? 1 : 0;
    if (is_blank && was_blank) return;
    uint last = LA_NO_RANK;
    for (int y = from.y; y < to.y; ++y) {
        for (int x = from.x; x < to.x; ++x) {
            const size_t at = (size_t)y * (size_t)size.x + (size_t)x;
            if (args.keeps_depth != 0) depth[at] = depth_of(texels[at].order);
            if (args.numbered == 0) continue;
            const uint rank = texels[at].rank;
            if (rank == LA_NO_RANK) {
                numbers[at] = LA_NO_FACE;
                continue;
            }
            const uint cluster = order[rank >> LA_RANK_BITS];
            numbers[at] = clusters[cluster].first + triangle_of(rank, (uint)args.lanes);
            if (cluster != last) atomic_max(seen + cluster, 1u);
            last = cluster;
        }
    }
}

/* Adds the clusters that nothing before them hides to those that texels show. One work-item per
 * cluster. */
KERNEL(depth_seen, DepthParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count || places[i].key == LA_OUT_OF_VIEW || seen[i] != 0) return;
    const int2 size = to_int2(args.depth_size), low = to_int2(args.covered);
    const int2 end = end_of_tiles(&args);
    const int columns = (size.x + LA_TILE - 1) / LA_TILE;
    const int left = max(places[i].low_x, low.x) / LA_TILE;
    const int right = min(places[i].high_x, end.x - 1) / LA_TILE;
    const int below = max(places[i].low_y, low.y) / LA_TILE;
    const int above = min(places[i].high_y, end.y - 1) / LA_TILE;
    for (int y = below; y <= above; ++y) {
        for (int x = left; x <= right; ++x) {
            if (pyramid[y * columns + x] < places[i].nearest) continue;
            seen[i] = 1;
            return;
        }
    }
}
#endif
