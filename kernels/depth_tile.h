/* A tile of the depth buffer while it is drawn, and what of it hides what comes later. Included
 * once, by depth_triangle.h. */
#include "kernels.h"
#include "shared/lanes.h"

/* Blocks of LA_TILE texels a side, per axis of a tile. */
#define TILE_BLOCKS (DEPTH_TILE / LA_TILE)
/* Floats from row to row: vectors that begin in the tile may end beyond it. */
#define TILE_STRIDE (DEPTH_TILE + 2 * LANES)

/* The state of a block of a tile. UNTOUCHED: nothing was drawn to it, and it is not in local
 * memory. KNOWN: `farthest` is its farthest depth. STALE: something was drawn to it after
 * `farthest` was computed. */
#define BLOCK_UNTOUCHED 0
#define BLOCK_KNOWN 1
#define BLOCK_STALE 2

typedef struct Tile {
    __local float* texels;
    __local int* numbers; /* NUMBERED: number of the triangle that each texel shows */
    int2 low;             /* its first texel in the whole picture */
    int2 size;            /* texels of the picture that it has */
    bool begins;          /* untouched blocks show nothing; else what was drawn before */
    bool keeps_depth;     /* `depth` is stored */
    /* The images from the tile's first texel on, and texels of theirs from row to row. */
    __global float* depth;
    __global int* depth_numbers;
    int width;
    /* The tables of blocks from its first on, and blocks from row to row. */
    __global float* pyramid;
    __global uchar* blank;
    int blocks_a_row;
    /* The farthest depth of each block; of a stale block that or something farther. */
    float farthest[TILE_BLOCKS * TILE_BLOCKS];
    uchar state[TILE_BLOCKS * TILE_BLOCKS];
} Tile;

INLINED void begin_tile(Tile* tile) {
    for (int i = 0; i < TILE_BLOCKS * TILE_BLOCKS; ++i) {
        tile->farthest[i] = 1.0f;
        tile->state[i] = BLOCK_UNTOUCHED;
    }
    if (tile->begins) return;
    for (int y = 0; y * LA_TILE < tile->size.y; ++y) {
        for (int x = 0; x * LA_TILE < tile->size.x; ++x)
            tile->farthest[y * TILE_BLOCKS + x] = tile->pyramid[y * tile->blocks_a_row + x];
    }
}

INLINED void clear_row(const Tile* tile, const int at) {
    const lanes_float far = 1.0f;
    for (int i = 0; i < LA_TILE; i += LANES) STORE_LANES(far, tile->texels + at + i);
#ifdef NUMBERED
    const lanes_int nobody = (int)LA_NO_FACE;
    for (int i = 0; i < LA_TILE; i += LANES) STORE_LANES(nobody, tile->numbers + at + i);
#endif
}

INLINED void load_row(const Tile* tile, const int at, const size_t from, const int count) {
    for (int i = 0; i < count; ++i) {
        tile->texels[at + i] = tile->depth[from + (size_t)i];
#ifdef NUMBERED
        tile->numbers[at + i] = tile->depth_numbers[from + (size_t)i];
#endif
    }
}

INLINED void store_row(const Tile* tile, const int at, const size_t to, const int count) {
    const int whole = count < LA_TILE ? 0 : LA_TILE;
    if (tile->keeps_depth) {
        __global float* out = tile->depth + to;
        for (int i = 0; i < whole; i += LANES)
            STORE_LANES(LOAD_LANES(tile->texels + at + i), out + i);
        for (int i = whole; i < count; ++i) out[i] = tile->texels[at + i];
    }
#ifdef NUMBERED
    __global int* out = tile->depth_numbers + to;
    for (int i = 0; i < whole; i += LANES) STORE_LANES(LOAD_INTS(tile->numbers + at + i), out + i);
    for (int i = whole; i < count; ++i) out[i] = tile->numbers[at + i];
#endif
}

/* Fetches what the block shows, before it is drawn to. */
INLINED void touch_block(const Tile* tile, const int x, const int y) {
    const int columns = min(tile->size.x - x * LA_TILE, LA_TILE);
    const int rows = min(tile->size.y - y * LA_TILE, LA_TILE);
    for (int k = 0; k < LA_TILE; ++k) {
        const int row = y * LA_TILE + k;
        const int at = row * TILE_STRIDE + x * LA_TILE;
        const int count = k < rows ? columns : 0;
        if (tile->begins)
            clear_row(tile, at);
        else
            load_row(tile, at, (size_t)row * (size_t)tile->width + (size_t)(x * LA_TILE), count);
        /* Texels beyond the picture hide everything, so they never change the farthest depth. */
        for (int i = count; i < LA_TILE; ++i) tile->texels[at + i] = 0.0f;
    }
}

INLINED float farthest_of_block(const Tile* tile, const int x, const int y) {
    __local const float* row = tile->texels + y * LA_TILE * TILE_STRIDE + x * LA_TILE;
    /* Two maxima, since each waits for its last step; max(), since fmax() would also test for
     * NaN. */
    lanes_float even = 0.0f, odd = 0.0f;
    for (int k = 0; k < LA_TILE; k += 2) {
        for (int i = 0; i < LA_TILE; i += LANES) {
            even = max(even, LOAD_LANES(row + i));
            odd = max(odd, LOAD_LANES(row + TILE_STRIDE + i));
        }
        row += 2 * TILE_STRIDE;
    }
    return LARGEST(max(even, odd));
}

/* True if a block that lies in the picture shows nothing. */
INLINED bool shows_nothing(const Tile* tile, const int x, const int y) {
    __local const float* row = tile->texels + y * LA_TILE * TILE_STRIDE + x * LA_TILE;
    const lanes_float far = 1.0f;
    for (int k = 0; k < LA_TILE; ++k) {
        for (int i = 0; i < LA_TILE; i += LANES) {
            if (ANY(LOAD_LANES(row + i) < far)) return false;
        }
        row += TILE_STRIDE;
    }
    return true;
}

/* Whether the block must be written to the images; says in the tables of blocks what it shows. */
INLINED bool differs(Tile* tile, const int x, const int y) {
    const int block = y * TILE_BLOCKS + x, there = y * tile->blocks_a_row + x;
    const bool untouched = tile->state[block] == BLOCK_UNTOUCHED;
    if (untouched && !tile->begins) return false;
    if (tile->state[block] == BLOCK_STALE) tile->farthest[block] = farthest_of_block(tile, x, y);
    const float farthest = tile->farthest[block];
    const bool was_blank = tile->blank[there] != 0;
    const bool is_blank = untouched || (farthest >= 1.0f && shows_nothing(tile, x, y));
    tile->pyramid[there] = farthest;
    tile->blank[there] = is_blank ? 1 : 0;
    if (is_blank && was_blank) return false;
    if (untouched) touch_block(tile, x, y);
    return true;
}

/* Writes the blocks that have changed. If a model is small, memory takes most of a frame's time, so
 * blocks that stay blank are not written. */
INLINED void store_tile(Tile* tile) {
    for (int y = 0; y * LA_TILE < tile->size.y; ++y) {
        bool written[TILE_BLOCKS], any = false;
        for (int x = 0; x * LA_TILE < tile->size.x; ++x) {
            written[x] = differs(tile, x, y);
            any = any || written[x];
        }
        if (!any) continue;
        const int end = min((y + 1) * LA_TILE, tile->size.y);
        for (int row = y * LA_TILE; row < end; ++row) {
            for (int x = 0; x * LA_TILE < tile->size.x; ++x) {
                if (!written[x]) continue;
                store_row(tile, row * TILE_STRIDE + x * LA_TILE,
                          (size_t)row * (size_t)tile->width + (size_t)(x * LA_TILE),
                          min(tile->size.x - x * LA_TILE, LA_TILE));
            }
        }
    }
}

/* True if a cluster as near as `nearest` may be seen in a box of texels, corners included. Then the
 * blocks of the box are prepared for drawing. */
INLINED bool cluster_shows(Tile* tile, const int4 box, const float nearest) {
    const int left = box.x / LA_TILE, right = box.z / LA_TILE;
    const int below = box.y / LA_TILE, above = box.w / LA_TILE;
    bool shows = false;
    for (int y = below; y <= above; ++y) {
        for (int x = left; x <= right; ++x) {
            const int block = y * TILE_BLOCKS + x;
            if (tile->farthest[block] < nearest) continue;
            if (tile->state[block] == BLOCK_STALE) {
                tile->farthest[block] = farthest_of_block(tile, x, y);
                tile->state[block] = BLOCK_KNOWN;
            }
            shows = shows || tile->farthest[block] >= nearest;
        }
    }
    if (!shows) return false;
    for (int y = below; y <= above; ++y) {
        for (int x = left; x <= right; ++x) {
            const int block = y * TILE_BLOCKS + x;
            if (tile->state[block] == BLOCK_UNTOUCHED) touch_block(tile, x, y);
            tile->state[block] = BLOCK_STALE;
        }
    }
    return true;
}

/* The same for a triangle, by the farthest depths that are known already. Changes nothing. */
INLINED bool triangle_shows(const Tile* tile, const int4 box, const float nearest) {
    for (int y = box.y / LA_TILE; y <= box.w / LA_TILE; ++y) {
        for (int x = box.x / LA_TILE; x <= box.z / LA_TILE; ++x) {
            if (tile->farthest[y * TILE_BLOCKS + x] >= nearest) return true;
        }
    }
    return false;
}
