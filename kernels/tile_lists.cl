/* tile_lists: for every tile of the screen the faces that may hide something in it, nearest first,
 * in groups of LA_GROUP with a box around each. Faces of one key are in the order of the model, so
 * that lists are equal on every device.
 *
 * tile_lists_count, tile_lists_fill: one work-item per chunk of triangles. Between them the counts
 * of each tile and chunk are scanned. With Tuning::face_lists there is one work-item per slice of a
 * triangle instead, which is some rows of the triangle's tiles. Then there is one count for each
 * tile, and the entries of a tile are in any order.
 *
 * Then tile_lists_arrange has one work-item per tile. With Tuning::face_lists other kernels do the
 * same: one work-item per entry (tile_lists_keys, a scan, tile_lists_place, tile_lists_sort,
 * tile_lists_write), per group (tile_lists_boxes) and per tile (tile_lists_behind). */

#include "shared/exact.h"

/* Keys by which a list is sorted: buckets of depth, and cells of the tile within each. */
#define DEPTH_BUCKETS 16
#define CELLS_ACROSS 4
#define KEYS LA_LIST_KEYS

/* Grows with a float, as an uint. */
static uint ordered(const float x) {
    const uint bits = as_uint(x);
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

static float from_ordered(const uint x) {
    return as_float((x & 0x80000000u) != 0 ? x & 0x7FFFFFFFu : ~x);
}

/* Enters face t into its tiles, or into those of a slice. Counts entries, or writes them at the
 * places in `ends`, which the function moves on, and notes how near and how far they are. */
INLINED void enter(const ExactParameters* args, const uint t, const uint chunk,
                   const ScreenFace box, __global const float* vertices,
                   __global const uint* triangles, __global const float* screen,
                   __global const float* planes, __global const uint* occluders,
                   __global uint* ends, __global Entry* entries, __global uint* ranges) {
    const int4 range = tiles_of(args, box);
    const int columns = to_int2(args->tiles).x;
    const bool few = (range.z - range.x) + (range.w - range.y) < 2;
    TileFace face;
    const bool in_chunks = args->chunks > 1;
    const int step = (int)slices_of(args);
    for (int y = range.y + (int)slice_of(args, chunk); y <= range.w; y += step) {
        for (int x = range.x; x <= range.z; ++x) {
            const uint tile = (uint)(y * columns + x);
            float nearness = box.nearest;
            if (as_float(occluders[tile]) > nearness) continue;
            if (!few) {
                const float2 origin = float2((float)x, (float)y) * args->tile_size;
                if (!face_in_tile(args, t, box.kind, planes[4 * t + 3], vertices, triangles, screen,
                                  origin, &face))
                    return;
                nearness = nearness_in_tile(args, &face, nearness);
                if (nearness < as_float(occluders[tile]) || nearness < 0.0f) continue;
            }
            if (in_chunks) {
                __global uint* end = ends + (tile * args->chunks + chunk);
                if (entries != 0) {
                    entries[*end].face = t;
                    entries[*end].nearness = nearness;
                }
                *end += 1u;
                continue;
            }
            const uint place = atomic_inc(ends + tile);
            if (entries == 0) continue;
            entries[place].face = t;
            entries[place].nearness = nearness;
            entries[place].key = tile;
            atomic_max(ranges + 2 * tile, ordered(nearness));
            atomic_max(ranges + 2 * tile + 1, ~ordered(nearness));
        }
    }
}

/* counts: per tile, per chunk; all 0 before. */
KERNEL(tile_lists_count, ExactParameters) {
    const uint chunk = (uint)get_global_id(0);
    const uint first = sliced(&args, chunk) * args.chunk;
    const uint last = min(first + args.chunk, args.triangle_count);
    for (uint t = first; t < last; ++t) {
        if (t < args.batched && states[t / LA_BATCH] != LA_BATCH_SEEN) {
            t |= LA_BATCH - 1u; /* on to the next batch */
            continue;
        }
        const ScreenFace box = faces[t];
        if (box.kind == FACE_UNSEEN) continue;
        enter(&args, t, chunk, box, vertices, triangles, screen, planes, occluders, counts, 0, 0);
    }
}

/* ends: the scanned counts, and behind them the number of all entries. Afterwards each says where
 * its part of the list ends. If there are more than fit, nothing is written; the host sees how
 * many, enlarges the table and does the frame again. ranges: per tile, all 0 before. */
KERNEL(tile_lists_fill, ExactParameters) {
    const uint chunk = (uint)get_global_id(0);
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    const uint first = sliced(&args, chunk) * args.chunk;
    const uint last = min(first + args.chunk, args.triangle_count);
    if (first >= last || ends[tiles * args.chunks] > args.entry_capacity) return;
    for (uint t = first; t < last; ++t) {
        if (t < args.batched && states[t / LA_BATCH] != LA_BATCH_SEEN) {
            t |= LA_BATCH - 1u; /* on to the next batch */
            continue;
        }
        const ScreenFace box = faces[t];
        if (box.kind == FACE_UNSEEN) continue;
        enter(&args, t, chunk, box, vertices, triangles, screen, planes, occluders, ends, entries,
              ranges);
    }
}

/* groups[tile]: how many groups its list takes. */
KERNEL(tile_lists_groups, ExactParameters) {
    const uint tile = (uint)get_global_id(0);
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    if (tile >= tiles) return;
    const uint count = offsets[(tile + 1) * args.chunks] - offsets[tile * args.chunks];
    groups[tile] = (count + LA_GROUP - 1u) / LA_GROUP;
}

/* Where an entry belongs in its tile's list. */
static uint key_of(const ScreenFace box, const float nearness, const float nearest,
                   const float per_bucket, const float2 origin, const float size) {
    const uint bucket =
        (uint)clamp((nearest - nearness) * per_bucket, 0.0f, (float)(DEPTH_BUCKETS - 1));
    const float scale = 0.5f * (float)CELLS_ACROSS / size, most = (float)(CELLS_ACROSS - 1);
    const uint x = (uint)clamp((box.low[0] + box.high[0] - 2.0f * origin.x) * scale, 0.0f, most);
    const uint y = (uint)clamp((box.low[1] + box.high[1] - 2.0f * origin.y) * scale, 0.0f, most);
    return (bucket * CELLS_ACROSS + y) * CELLS_ACROSS + x;
}

/* A place in a group that nothing stands in. */
static void write_nothing(__global float* group, const uint lane) {
    for (uint k = 0; k < LA_ENTRY_FLOATS; ++k) group[k * LA_GROUP + lane] = 0.0f;
    group[LA_ENTRY_LOW_X * LA_GROUP + lane] = INFINITY;
    group[LA_ENTRY_HIGH_X * LA_GROUP + lane] = -INFINITY;
    group[LA_ENTRY_NEAREST * LA_GROUP + lane] = -1.0f;
}

static void write_entry(const TileFace* face, const ScreenFace box, const float nearness,
                        const float2 origin, __global float* group, const uint lane) {
    __global float* to = group + lane;
    to[LA_ENTRY_LOW_X * LA_GROUP] = box.low[0] - origin.x;
    to[LA_ENTRY_LOW_Y * LA_GROUP] = box.low[1] - origin.y;
    to[LA_ENTRY_HIGH_X * LA_GROUP] = box.high[0] - origin.x;
    to[LA_ENTRY_HIGH_Y * LA_GROUP] = box.high[1] - origin.y;
    to[LA_ENTRY_NEAREST * LA_GROUP] = nearness;
    for (uint k = 0; k < 3; ++k) {
        to[(LA_ENTRY_SIDES + 3 * k) * LA_GROUP] = face->sides[k].a;
        to[(LA_ENTRY_SIDES + 3 * k + 1) * LA_GROUP] = face->sides[k].b;
        to[(LA_ENTRY_SIDES + 3 * k + 2) * LA_GROUP] = face->sides[k].c;
    }
    to[LA_ENTRY_PLANE * LA_GROUP] = face->nearness.a;
    to[(LA_ENTRY_PLANE + 1) * LA_GROUP] = face->nearness.b;
    to[(LA_ENTRY_PLANE + 2) * LA_GROUP] = face->nearness.c;
    to[LA_ENTRY_DOUBT * LA_GROUP] = face->doubt;
}

/* The box around a group. Returns the nearest that anything in it comes. */
static float enclose_group(const ExactParameters* args, __global const float* group, const uint g,
                           __global float* boxes) {
    float low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
    float nearest = -1.0f;
    for (uint lane = 0; lane < LA_GROUP; ++lane) {
        if (group[LA_ENTRY_NEAREST * LA_GROUP + lane] < 0.0f) continue;
        low_x = fmin(low_x, group[LA_ENTRY_LOW_X * LA_GROUP + lane]);
        low_y = fmin(low_y, group[LA_ENTRY_LOW_Y * LA_GROUP + lane]);
        high_x = fmax(high_x, group[LA_ENTRY_HIGH_X * LA_GROUP + lane]);
        high_y = fmax(high_y, group[LA_ENTRY_HIGH_Y * LA_GROUP + lane]);
        nearest = fmax(nearest, group[LA_ENTRY_NEAREST * LA_GROUP + lane]);
    }
    const uint stride = args->group_capacity + LA_GROUP;
    boxes[LA_ENTRY_LOW_X * stride + g] = low_x;
    boxes[LA_ENTRY_LOW_Y * stride + g] = low_y;
    boxes[LA_ENTRY_HIGH_X * stride + g] = high_x;
    boxes[LA_ENTRY_HIGH_Y * stride + g] = high_y;
    boxes[LA_ENTRY_NEAREST * stride + g] = nearest;
    return nearest;
}

/* The nearest that anything in a group and behind it in the list comes. */
static float note_behind(const ExactParameters* args, const uint g, const float nearest,
                         const float behind, __global float* boxes) {
    const float all = fmax(nearest, behind);
    boxes[LA_BOX_BEHIND * (args->group_capacity + LA_GROUP) + g] = all;
    return all;
}

/* How many keys there are to a unit of nearness. */
static float buckets_per_nearness(const float nearest, const float farthest) {
    return nearest > farthest ? (float)DEPTH_BUCKETS / (nearest - farthest) : 0.0f;
}

static float2 origin_of(const ExactParameters* args, const uint tile) {
    const uint columns = (uint)args->tiles.v[0];
    return float2((float)(tile % columns), (float)(tile / columns)) * args->tile_size;
}

/* Writes an entry out as lines and a plane, at its place in its tile's list. */
static void write_place(const ExactParameters* args, const Entry entry, const uint place,
                        const float2 origin, __global const ScreenFace* faces,
                        __global const float* planes, __global const float* vertices,
                        __global const uint* triangles, __global const float* screen,
                        __global float* blocks) {
    const ScreenFace box = faces[entry.face];
    __global float* group = blocks + (size_t)(place / LA_GROUP) * LA_GROUP_FLOATS;
    group[LA_ENTRY_FACE * LA_GROUP + place % LA_GROUP] = as_float(entry.face);
    TileFace face;
    if (face_in_tile(args, entry.face, box.kind, planes[4 * entry.face + 3], vertices, triangles,
                     screen, origin, &face))
        write_entry(&face, box, entry.nearness, origin, group, place % LA_GROUP);
    else
        write_nothing(group, place % LA_GROUP);
}

/* Fills up the last group of a list of so many entries. */
static void write_rest(const uint count, __global float* blocks) {
    for (uint place = count; place % LA_GROUP != 0; ++place)
        write_nothing(blocks + (size_t)(place / LA_GROUP) * LA_GROUP_FLOATS, place % LA_GROUP);
}

/* Sorts a tile's entries (stably, by counting) and writes them out as lines and planes. */
KERNEL(tile_lists_arrange, ExactParameters) {
    const uint tile = (uint)get_global_id(0);
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    if (tile >= tiles || !lists_fit(&args, ends[tiles * args.chunks], groups[tiles])) return;
    const uint first = tile > 0 ? ends[tile * args.chunks - 1] : 0;
    const uint last = ends[(tile + 1) * args.chunks - 1];
    if (first == last) return;
    const float2 origin = origin_of(&args, tile);
    float nearest = 0.0f, farthest = INFINITY;
    for (uint i = first; i < last; ++i) {
        nearest = fmax(nearest, entries[i].nearness);
        farthest = fmin(farthest, entries[i].nearness);
    }
    const float per_bucket = buckets_per_nearness(nearest, farthest);
    uint places[KEYS];
    for (uint k = 0; k < KEYS; ++k) places[k] = 0;
    for (uint i = first; i < last; ++i) {
        const uint key = key_of(faces[entries[i].face], entries[i].nearness, nearest, per_bucket,
                                origin, args.tile_size);
        entries[i].key = key;
        places[key] += 1u;
    }
    uint sum = 0;
    for (uint k = 0; k < KEYS; ++k) {
        const uint count = places[k];
        places[k] = sum;
        sum += count;
    }
    __global float* own_blocks = blocks + (size_t)groups[tile] * LA_GROUP_FLOATS;
    for (uint i = first; i < last; ++i)
        write_place(&args, entries[i], places[entries[i].key]++, origin, faces, planes, vertices,
                    triangles, screen, own_blocks);
    write_rest(last - first, own_blocks);
    float behind = -1.0f;
    for (uint g = groups[tile + 1]; g > groups[tile]; --g) {
        const float in_group =
            enclose_group(&args, blocks + (size_t)(g - 1) * LA_GROUP_FLOATS, g - 1, boxes);
        behind = note_behind(&args, g - 1, in_group, behind, boxes);
    }
}

/* Gives each entry its key among those of all tiles, and counts the entries of each key. keys: all
 * 0 before. */
KERNEL(tile_lists_keys, ExactParameters) {
    const uint i = (uint)get_global_id(0);
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    if (i >= ends[tiles] || !lists_fit(&args, ends[tiles], groups[tiles])) return;
    const Entry entry = entries[i];
    const float nearest = fmax(0.0f, from_ordered(ranges[2 * entry.key]));
    const float farthest = from_ordered(~ranges[2 * entry.key + 1]);
    const uint key = entry.key * KEYS + key_of(faces[entry.face], entry.nearness, nearest,
                                               buckets_per_nearness(nearest, farthest),
                                               origin_of(&args, entry.key), args.tile_size);
    entries[i].key = key;
    atomic_inc(keys + key);
}

/* Places entries by their keys. keys: scanned; afterwards each says where its entries end. */
KERNEL(tile_lists_place, ExactParameters) {
    const uint i = (uint)get_global_id(0);
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    if (i >= ends[tiles] || !lists_fit(&args, ends[tiles], groups[tiles])) return;
    placed[atomic_inc(keys + entries[i].key)] = entries[i];
}

/* Sorts the entries of each key by their faces: an entry counts those that come before it. A key
 * has a few entries, and thousands where as many faces lie behind each other. Counting shares such
 * a key among work-items, where sorting would leave it to one. */
KERNEL(tile_lists_sort, ExactParameters) {
    const uint i = (uint)get_global_id(0);
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    if (i >= ends[tiles] || !lists_fit(&args, ends[tiles], groups[tiles])) return;
    const Entry own = placed[i];
    const uint first = own.key > 0 ? keys[own.key - 1] : 0, last = keys[own.key];
    uint place = first;
    for (uint k = first; k < last; ++k) place += placed[k].face < own.face ? 1u : 0u;
    entries[place] = own;
}

KERNEL(tile_lists_write, ExactParameters) {
    const uint i = (uint)get_global_id(0);
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    if (i >= ends[tiles] || !lists_fit(&args, ends[tiles], groups[tiles])) return;
    const uint tile = entries[i].key / KEYS;
    const uint first = tile > 0 ? ends[tile - 1] : 0;
    __global float* own_blocks = blocks + (size_t)groups[tile] * LA_GROUP_FLOATS;
    write_place(&args, entries[i], i - first, origin_of(&args, tile), faces, planes, vertices,
                triangles, screen, own_blocks);
    if (i + 1 == ends[tile]) write_rest(i + 1 - first, own_blocks);
}

KERNEL(tile_lists_boxes, ExactParameters) {
    const uint g = (uint)get_global_id(0);
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    if (g >= groups[tiles] || !lists_fit(&args, ends[tiles], groups[tiles])) return;
    enclose_group(&args, blocks + (size_t)g * LA_GROUP_FLOATS, g, boxes);
}

KERNEL(tile_lists_behind, ExactParameters) {
    const uint tile = (uint)get_global_id(0);
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    if (tile >= tiles || !lists_fit(&args, ends[tiles], groups[tiles])) return;
    const uint stride = args.group_capacity + LA_GROUP;
    float behind = -1.0f;
    for (uint g = groups[tile + 1]; g > groups[tile]; --g)
        behind = note_behind(&args, g - 1, boxes[LA_ENTRY_NEAREST * stride + g - 1], behind, boxes);
}
