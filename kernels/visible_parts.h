/* Visible parts of a segment, as visible.cl cuts and collects them: of a piece of it within a tile,
 * then of all of it. */
#ifndef LINEATLAS_VISIBLE_PARTS_H
#define LINEATLAS_VISIBLE_PARTS_H

#include "language.h"

/* Parts of a piece that are held at once. A piece with more is halved, and each half done alone. */
#define MOST_PARTS 8
/* Visible parts shorter than this, in pixels, are left out, and gaps of that length closed. */
#define SHORTEST_PART 0.02f

/* Visible parts of a piece: from x to y each, ascending. */
typedef struct Parts {
    float2 part[MOST_PARTS];
    int count;
    bool full; /* there were more: `part` is not all */
} Parts;

/* Takes u from `low` to `high` away from what is visible. least: shorter parts are left out. */
static void hide(Parts* parts, const float low, const float high, const float least) {
    int k = 0;
    while (k < parts->count && parts->part[k].y <= low) ++k;
    while (k < parts->count && parts->part[k].x < high) {
        const float2 part = parts->part[k];
        const bool before = low - part.x > least, after = part.y - high > least;
        if (before && after) {
            if (parts->count == MOST_PARTS) {
                parts->full = true;
                return;
            }
            for (int j = parts->count; j > k; --j) parts->part[j] = parts->part[j - 1];
            ++parts->count;
            parts->part[k].y = low;
            parts->part[k + 1].x = high;
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

/* Where visible parts of a segment go: joined where they touch, counted, the first two kept, and
 * written if there is a table. */
typedef struct Found {
    float gap;   /* SHORTEST_PART as s: what is nearer to an end of the segment is that end */
    float2 open; /* the part that may go on; none if x > y */
    uint count;
    float4 kept;
    __global float* out;
} Found;

/* way: of the segment on the screen, pixels. */
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
