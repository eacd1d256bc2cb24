/* Visible parts of a segment, as visible.cl cuts and collects them: first of a piece of the segment
 * within a tile, then of the whole segment. */
#ifndef LINEATLAS_VISIBLE_PARTS_H
#define LINEATLAS_VISIBLE_PARTS_H

#include "shared/language.h"

/* Parts of a piece that are held at once. A piece with more parts is cut several times: first for
 * its first parts, then for those beyond them. */
#if FACE_LANES > 1
#define MOST_PARTS 64
#else
#define MOST_PARTS 16 /* GPUs have little memory for each work-item */
#endif
/* Visible parts shorter than this, in pixels, are left out, and gaps of that length closed. */
#define SHORTEST_PART 0.02f
/* Share of that length. Something hidden that is no longer than this, at an end of a segment, is
 * not looked at: rounding takes faces at the segment's vertex for faces before it. */
#define NOTHING_AT_AN_END 0.1f

/* Visible parts of a piece: from x to y each, ascending. */
typedef struct Parts {
    float2 part[MOST_PARTS];
    int count;
    float end; /* what is visible beyond this is not known; 1: all is */
} Parts;

/* The whole piece from u on as one visible part, before anything is taken away. */
static void begin_parts(Parts* parts, const float u) {
    parts->part[0] = float2(u, 1.0f);
    parts->count = 1;
    parts->end = 1.0f;
}

/* Splits part k by what hides it from `low` to `high`. If there is no room for both, the last part
 * is given up: it lies beyond `end` then. */
static void split_part(Parts* parts, const int k, const float low, const float high) {
    const float2 part = parts->part[k];
    parts->part[k].y = low;
    if (k == MOST_PARTS - 1) {
        parts->end = high;
        return;
    }
    if (parts->count == MOST_PARTS) {
        parts->count -= 1;
        parts->end = parts->part[parts->count].x;
    }
    for (int j = parts->count; j > k + 1; --j) parts->part[j] = parts->part[j - 1];
    parts->part[k + 1] = float2(high, part.y);
    parts->count += 1;
}

/* Takes u from `low` to `high` away from what is visible. least: shorter parts are left out. */
static void hide(Parts* parts, const float low, const float high, const float least) {
    int k = 0;
    while (k + 8 < parts->count && parts->part[k + 8].y <= low) k += 8;
    while (k < parts->count && parts->part[k].y <= low) ++k;
    while (k < parts->count && parts->part[k].x < high) {
        const float2 part = parts->part[k];
        const bool before = low - part.x > least, after = part.y - high > least;
        if (before && after) {
            split_part(parts, k, low, high);
            return;
        }
        if (before) {
            parts->part[k++].y = low;
        } else if (after) {
            parts->part[k++].x = high;
        } else {
            --parts->count;
            for (int j = k; j < parts->count; ++j) parts->part[j] = parts->part[j + 1];
        }
    }
}

/* Collects visible parts of a segment. Parts that touch are joined, all are counted, the first two
 * are kept, and all are written if there is a table. */
typedef struct Found {
    float gap;   /* SHORTEST_PART as s: a place nearer than this to an end of the segment is that
                    end */
    float2 open; /* the part that may go on; none if x > y */
    uint count;
    float4 kept;
    __global float* out;
} Found;

/* way: from the segment's start to its end on the screen, pixels. */
static Found nothing_found(const float2 way, __global float* out) {
    const float length_px = sqrt(way.x * way.x + way.y * way.y);
    const Found found = {SHORTEST_PART / length_px, float2(1.0f, 0.0f), 0,
                         float4(0.0f, 0.0f, 0.0f, 0.0f), out};
    return found;
}

static void close_part(Found* found) {
    if (found->open.x > found->open.y) return;
    if (found->open.x <= found->gap) found->open.x = 0.0f;
    if (1.0f - found->open.y <= found->gap) found->open.y = 1.0f;
    if (found->count == 0) found->kept = float4(found->open.x, found->open.y, 0.0f, 0.0f);
    if (found->count == 1)
        found->kept = float4(found->kept.x, found->kept.y, found->open.x, found->open.y);
    if (found->out != 0) vstore2(found->open, found->count, found->out);
    found->count += 1u;
}

static void add_part(Found* found, const float2 part) {
    if (found->open.x <= found->open.y && part.x - found->open.y <= found->gap) {
        found->open.y = part.y;
        return;
    }
    close_part(found);
    found->open = part;
}

#endif
