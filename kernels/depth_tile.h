/* A tile of the depth buffer while it is drawn, and what of it hides what comes later. Included
 * once, by depth_triangle.h. */
#include "kernels.h"
#include "lanes.h"

/* Blocks of LA_TILE texels a side, per axis of a tile. */
#define TILE_BLOCKS (DEPTH_TILE / LA_TILE)
/* Floats from row to row: vectors that begin in the tile may end beyond it. */
#define TILE_STRIDE (DEPTH_TILE + 2 * LANES)

typedef struct Tile {
    __local float* texels;
    __local int* numbers; /* NUMBERED: of the triangle that each texel shows */
    int2 low;             /* its first texel in the whole picture */
    int2 size;            /* texels of the picture that it has */
    /* Of each block the farthest depth, or something farther while it is stale. */
    float farthest[TILE_BLOCKS * TILE_BLOCKS];
    uchar stale[TILE_BLOCKS * TILE_BLOCKS];
} Tile;

/* Texels that the picture has not hide all and never change what is farthest. */
static void clear_tile(Tile* tile) {
    for (int i = 0; i < TILE_STRIDE * DEPTH_TILE; ++i) tile->texels[i] = 1.0f;
#ifdef NUMBERED
    for (int i = 0; i < TILE_STRIDE * DEPTH_TILE; ++i) tile->numbers[i] = (int)LA_NO_FACE;
#endif
    if (tile->size.x < DEPTH_TILE || tile->size.y < DEPTH_TILE) {
        for (int y = 0; y < DEPTH_TILE; ++y) {
            for (int x = y < tile->size.y ? tile->size.x : 0; x < DEPTH_TILE; ++x)
                tile->texels[y * TILE_STRIDE + x] = 0.0f;
        }
    }
    for (int i = 0; i < TILE_BLOCKS * TILE_BLOCKS; ++i) {
        tile->farthest[i] = 1.0f;
        tile->stale[i] = 0;
    }
}

/* corner: of the tile in `depth`; width: of `depth`. */
static void load_tile(Tile* tile, __global const float* depth, __global const uint* numbers,
                      const int2 corner, const int width) {
    for (int y = 0; y < tile->size.y; ++y) {
        const size_t row = (size_t)(corner.y + y) * (size_t)width + (size_t)corner.x;
        for (int x = 0; x < tile->size.x; ++x) {
            tile->texels[y * TILE_STRIDE + x] = depth[row + (size_t)x];
#ifdef NUMBERED
            tile->numbers[y * TILE_STRIDE + x] = (int)numbers[row + (size_t)x];
#endif
        }
    }
    for (int i = 0; i < TILE_BLOCKS * TILE_BLOCKS; ++i) tile->stale[i] = 1;
}

static void store_tile(const Tile* tile, __global float* depth, __global uint* numbers,
                       const int2 corner, const int width) {
    for (int y = 0; y < tile->size.y; ++y) {
        const size_t row = (size_t)(corner.y + y) * (size_t)width + (size_t)corner.x;
        __global float* to = depth + row;
        __local const float* from = tile->texels + y * TILE_STRIDE;
        for (int x = 0; x < tile->size.x; ++x) to[x] = from[x];
#ifdef NUMBERED
        __global uint* to_numbers = numbers + row;
        __local const int* from_numbers = tile->numbers + y * TILE_STRIDE;
        for (int x = 0; x < tile->size.x; ++x) to_numbers[x] = (uint)from_numbers[x];
#endif
    }
}

static float farthest_of_block(const Tile* tile, const int x, const int y) {
    __local const float* row = tile->texels + y * LA_TILE * TILE_STRIDE + x * LA_TILE;
    /* Two, since each waits for its last; max, since fmax would look for what is no number. */
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

static void store_farthest(const Tile* tile, __global float* pyramid, const int2 corner,
                           const int blocks_a_row) {
    for (int y = 0; y * LA_TILE < tile->size.y; ++y) {
        __global float* to = pyramid + (corner.y / LA_TILE + y) * blocks_a_row + corner.x / LA_TILE;
        for (int x = 0; x * LA_TILE < tile->size.x; ++x) {
            const int block = y * TILE_BLOCKS + x;
            to[x] = tile->stale[block] != 0 ? farthest_of_block(tile, x, y) : tile->farthest[block];
        }
    }
}

/* Whether anything as near as `nearest` can be seen in a box of texels, corners included. If so the
 * box will be drawn to. */
static bool cluster_shows(Tile* tile, const int4 box, const float nearest) {
    const int left = box.x / LA_TILE, right = box.z / LA_TILE;
    const int below = box.y / LA_TILE, above = box.w / LA_TILE;
    bool shows = false;
    for (int y = below; y <= above; ++y) {
        for (int x = left; x <= right; ++x) {
            const int block = y * TILE_BLOCKS + x;
            if (tile->farthest[block] < nearest) continue;
            if (tile->stale[block] != 0) {
                tile->farthest[block] = farthest_of_block(tile, x, y);
                tile->stale[block] = 0;
            }
            shows = shows || tile->farthest[block] >= nearest;
        }
    }
    if (!shows) return false;
    for (int y = below; y <= above; ++y) {
        for (int x = left; x <= right; ++x) tile->stale[y * TILE_BLOCKS + x] = 1;
    }
    return true;
}

/* The same of a triangle, by what is known already. */
static bool triangle_shows(const Tile* tile, const int4 box, const float nearest) {
    for (int y = box.y / LA_TILE; y <= box.w / LA_TILE; ++y) {
        for (int x = box.x / LA_TILE; x <= box.z / LA_TILE; ++x) {
            if (tile->farthest[y * TILE_BLOCKS + x] >= nearest) return true;
        }
    }
    return false;
}
