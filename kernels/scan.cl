/* scan: exclusive prefix sum of unsigned integers, in place (§4.1; Sengupta et al. 2007 as cited
 * there).
 *
 * values holds n inputs and room for one more: afterwards values[i] is the sum of the inputs before
 * i and values[n] the total. There are two forms of one algorithm. For CPU devices chunks are each
 * summed serially by one work-item. For GPUs tiles in local memory are summed by one work-group
 * each. Neither form needs work-groups that wait for each other, for which OpenCL promises no
 * progress.
 *
 * SCAN_SATURATE 1: the sum stops at 0xFFFFFFFF, so that a total that is too large is recognised.
 * SCAN_SATURATE 0: the sum wraps around; differences of sums stay right (arc lengths). */

#ifndef SCAN_SATURATE
#error "SCAN_SATURATE must be 0 or 1"
#endif

#include "kernels.h"

/* Stream compaction (§4.6). The inputs were 0 or 1 and have been scanned in place into `values`.
 * Writes list[k], the index of the k-th input that was 1. One work-item per input. */
KERNEL(scan_list, CountParameters) {
    const uint i = (uint)get_global_id(0);
    if (i < args.count && values[i + 1] != values[i]) list[values[i]] = i;
}

#if SCAN_SATURATE
#define SCAN_ADD(a, b) add_sat((uint)(a), (uint)(b))
#else
#define SCAN_ADD(a, b) ((uint)(a) + (uint)(b))
#endif

/* Chunks, step 1: sums[c] = sum of chunk c. One work-item per chunk of `chunk` values. The sum has
 * 64 bits, which no chunk exceeds. Unlike a saturating sum it takes one vector addition for several
 * values. */
KERNEL(scan_chunks_reduce, ScanParameters) {
    const uint n = args.n, chunk = args.chunk;
    const uint c = (uint)get_global_id(0);
    const uint begin = min(c * chunk, n);
    const uint end = n - begin < chunk ? n : begin + chunk;
#if SCAN_SATURATE
    ulong sum = 0;
    for (uint i = begin; i < end; ++i) sum += values[i];
    sums[c] = (uint)min(sum, (ulong)0xFFFFFFFFu);
#else
    uint sum = 0;
    for (uint i = begin; i < end; ++i) sum += values[i];
    sums[c] = sum;
#endif
}

/* Chunks, step 2: each work-item adds up the chunks before its own (there are few) and scans it. */
KERNEL(scan_chunks_apply, ScanParameters) {
    const uint n = args.n, chunk = args.chunk;
    const uint c = (uint)get_global_id(0);
    uint sum = 0;
    for (uint i = 0; i < c; ++i) sum = SCAN_ADD(sum, sums[i]);
    const uint begin = min(c * chunk, n);
    const uint end = n - begin < chunk ? n : begin + chunk;
    uint i = begin;
    /* If the sum stays below the largest value, the chunk needs no saturation. Values are taken
     * four at a time. Each sum waits for the one before it, so only every fourth addition has to
     * wait. */
    if (!SCAN_SATURATE || SCAN_ADD(sum, sums[c]) != 0xFFFFFFFFu) {
        for (; end - i >= 4; i += 4) {
            const uint v0 = values[i], v1 = values[i + 1], v2 = values[i + 2], v3 = values[i + 3];
            values[i] = sum;
            values[i + 1] = sum + v0;
            values[i + 2] = sum + (v0 + v1);
            values[i + 3] = sum + (v0 + v1 + v2);
            sum += (v0 + v1) + (v2 + v3);
        }
    }
    for (; i < end; ++i) {
        const uint value = values[i];
        values[i] = sum;
        sum = SCAN_ADD(sum, value);
    }
    if (c + 1 == (uint)get_global_size(0)) values[n] = sum;
}

/* Tile width: set by the host to the work-group size, a power of two. */
#ifdef SCAN_TILE
#ifndef SCAN_PER_ITEM
#error "SCAN_PER_ITEM must be set with SCAN_TILE: values per work-item"
#endif

/* Exclusive scan over a work-group, one value per work-item (Hillis and Steele 1986). Returns the
 * sum of the values of the work-items before this one. *total: the sum of all values. */
INLINED uint scan_group(const uint value, __local uint* scratch, uint* total) {
    const uint lane = (uint)get_local_id(0);
    scratch[lane] = value;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (uint reach = 1; reach < SCAN_TILE; reach *= 2) {
        const uint before = lane >= reach ? scratch[lane - reach] : 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        scratch[lane] = SCAN_ADD(scratch[lane], before);
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    const uint exclusive = lane > 0 ? scratch[lane - 1] : 0;
    *total = scratch[SCAN_TILE - 1];
    barrier(CLK_LOCAL_MEM_FENCE);
    return exclusive;
}

/* Sum of the work-item's own SCAN_PER_ITEM neighbouring values. */
static uint sum_own(__global const uint* values, const uint n, const uint begin) {
    uint sum = 0;
    for (uint k = 0; k < SCAN_PER_ITEM; ++k) {
        if (begin + k < n) sum = SCAN_ADD(sum, values[begin + k]);
    }
    return sum;
}

/* Tiles, step 1: sums[g] = sum of tile g, of SCAN_TILE * SCAN_PER_ITEM values. */
KERNEL(scan_tiles_reduce, ScanParameters) {
    const uint n = args.n;
    __local uint scratch[SCAN_TILE];
    uint total;
    const uint begin = (uint)get_global_id(0) * SCAN_PER_ITEM;
    scan_group(sum_own(values, n, begin), scratch, &total);
    if (get_local_id(0) == 0) sums[get_group_id(0)] = total;
}

/* Scans these values in place. Whoever has the last of all also writes the total. sum: of the
 * values before `begin`. */
static void scan_own(__global uint* values, const uint n, const uint begin, uint sum) {
    for (uint k = 0; k < SCAN_PER_ITEM; ++k) {
        if (begin + k >= n) break;
        const uint value = values[begin + k];
        values[begin + k] = sum;
        sum = SCAN_ADD(sum, value);
        if (begin + k + 1 == n) values[n] = sum;
    }
}

/* Tiles, step 2: one work-group scans the sums of all tiles in place. Few values are scanned by
 * this step alone. */
KERNEL(scan_tiles_sums, ScanParameters) {
    const uint n = args.n;
    __local uint scratch[SCAN_TILE];
    uint carry = 0;
    for (uint begin = 0; begin < n; begin += SCAN_TILE * SCAN_PER_ITEM) {
        const uint own = begin + (uint)get_local_id(0) * SCAN_PER_ITEM;
        uint total;
        const uint before = scan_group(sum_own(sums, n, own), scratch, &total);
        scan_own(sums, n, own, SCAN_ADD(carry, before));
        carry = SCAN_ADD(carry, total);
    }
}

/* Tiles, step 3: every tile scanned, from the sum of the tiles before it. If there are at most
 * SCAN_TILE of them, each work-group adds up their sums itself, and step 2 is left out. */
KERNEL(scan_tiles_apply, ScanParameters) {
    const uint n = args.n;
    __local uint scratch[SCAN_TILE];
    const uint lane = (uint)get_local_id(0), tile = (uint)get_group_id(0);
    const uint own = lane < tile ? sums[lane] : 0, all = lane == 0 ? sums[tile] : 0;
    uint first, total;
    scan_group(args.scanned != 0 ? all : own, scratch, &first);
    const uint begin = (uint)get_global_id(0) * SCAN_PER_ITEM;
    const uint before = scan_group(sum_own(values, n, begin), scratch, &total);
    scan_own(values, n, begin, SCAN_ADD(first, before));
}
#endif
