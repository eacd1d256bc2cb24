/* Vectors that do several things of a kernel at once. LANES: how many, 1 on GPUs, else 4, 8 or 16.
 * If LANES_IN_USE is defined, only so many lanes hold something. Each kernel file that says how
 * many it wants includes this file once, so there is no guard. LARGEST(x): the largest of the lanes
 * that are numbers.
 *
 * A comparison of vectors gives -1 for true, of scalars 1; `& 1` serves both. LANE_BITS makes a
 * uint whose bit k is that of lane k. */
#if !defined(LANES)
#error "LANES must be 1, 4, 8 or 16"
#endif
#ifndef LANES_IN_USE
#define LANES_IN_USE LANES
#endif

#undef LANE_INDEX
#undef TO_FLOAT
#undef FLOOR_TO_INT
#undef LOAD_LANES
#undef STORE_LANES
#undef GATHER_LANES
#undef GATHER_INTS
#undef SQUARE_ROOT
#undef ANY
#undef COUNT
#undef LANE_BITS
#undef LARGEST
#undef ROUND_TO_INT
#undef LOAD_BYTES
#undef LOAD_INTS
#undef SELECT

#if LANES == 1
typedef float lanes_float;
typedef int lanes_int;
typedef int lanes_mask;
#define LANE_INDEX 0
#define TO_FLOAT(x) ((float)(x))
#define FLOOR_TO_INT(x) convert_int_rtn(x)
#define LOAD_LANES(from) (*(from))
#define STORE_LANES(mask, to) (*(to) = (mask))
#define GATHER_LANES(from, i) ((from)[i])
#define GATHER_INTS(from, i) ((int)(from)[i])
#define SQUARE_ROOT(x) sqrt(x)
#define ANY(mask) ((mask) != 0)
#define COUNT(mask) ((mask)&1)
#define LANE_BITS(mask) ((uint)((mask)&1))
#define LARGEST(x) (x)
/* To the nearest int, and to the even one if two are as near. */
#define ROUND_TO_INT(x) convert_int_rte(x)
#define LOAD_BYTES(from) ((int)*(from))
#define LOAD_INTS(from) ((int)*(from))
/* b where the mask is set, else a. */
#define SELECT(a, b, mask) ((mask) ? (b) : (a))

#elif defined(__OPENCL_VERSION__)
#define LANES_TYPE_OF(type, n) type##n
#define LANES_TYPE(type, n) LANES_TYPE_OF(type, n)
typedef LANES_TYPE(float, LANES) lanes_float;
typedef LANES_TYPE(int, LANES) lanes_int;
typedef LANES_TYPE(int, LANES) lanes_mask;
#define TO_FLOAT(x) LANES_TYPE(convert_float, LANES)(x)
#define LANES_ROUNDED_OF(n) convert_int##n##_rtn
#define LANES_ROUNDED(n) LANES_ROUNDED_OF(n)
#define FLOOR_TO_INT(x) LANES_ROUNDED(LANES)(x)
#define LOAD_LANES(from) LANES_TYPE(vload, LANES)(0, from)
#define STORE_LANES(mask, to) LANES_TYPE(vstore, LANES)(mask, 0, to)
#define ANY(mask) any(mask)
#define COUNT(mask) count_lanes(mask)
#define LANE_BITS(mask) lane_bits(mask)
#define LARGEST(x) largest_lane(x)
#define NEAREST_OF(n) convert_int##n##_rte
#define NEAREST(n) NEAREST_OF(n)
#define ROUND_TO_INT(x) NEAREST(LANES)(x)
#define LOAD_BYTES(from) LANES_TYPE(convert_int, LANES)(LANES_TYPE(vload, LANES)(0, from))
#define LOAD_INTS(from) LOAD_BYTES(from)
#define SELECT(a, b, mask) select(a, b, mask)
#define SQUARE_ROOT(x) sqrt(x)
static uint bits_of_four(const int4 bits) {
    return (uint)((bits.x | bits.y) | (bits.z | bits.w));
}
#if LANES == 4
static uint lane_bits(const int4 mask) {
    return bits_of_four(mask & (int4)(1, 2, 4, 8));
}
#elif LANES == 8
static uint lane_bits(const int8 mask) {
    const int8 bits = mask & (int8)(1, 2, 4, 8, 16, 32, 64, 128);
    return bits_of_four(bits.lo | bits.hi);
}
#else
static uint lane_bits(const int16 mask) {
    const int16 bits =
        mask & (int16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);
    const int8 eight = bits.lo | bits.hi;
    return bits_of_four(eight.lo | eight.hi);
}
#endif
#if LANES == 4
#define LANE_INDEX (int4)(0, 1, 2, 3)
#define GATHER_LANES(from, i) (float4)((from)[i.x], (from)[i.y], (from)[i.z], (from)[i.w])
#define GATHER_INTS(from, i)                                                                       \
    (int4)((int)(from)[i.x], (int)(from)[i.y], (int)(from)[i.z], (int)(from)[i.w])
static int count_lanes(const int4 mask) {
    const int4 ones = mask & 1;
    return ones.x + ones.y + ones.z + ones.w;
}
static float largest_lane(const float4 x) {
    return max(max(x.x, x.y), max(x.z, x.w));
}
#elif LANES == 8
#define LANE_INDEX (int8)(0, 1, 2, 3, 4, 5, 6, 7)
#define GATHER_LANES(from, i)                                                                      \
    (float8)((from)[i.s0], (from)[i.s1], (from)[i.s2], (from)[i.s3], (from)[i.s4], (from)[i.s5],   \
             (from)[i.s6], (from)[i.s7])
#define GATHER_INTS(from, i)                                                                       \
    (int8)((int)(from)[i.s0], (int)(from)[i.s1], (int)(from)[i.s2], (int)(from)[i.s3],             \
           (int)(from)[i.s4], (int)(from)[i.s5], (int)(from)[i.s6], (int)(from)[i.s7])
static float largest_lane(const float8 x) {
    const float4 four = max(x.lo, x.hi);
    return max(max(four.x, four.y), max(four.z, four.w));
}
#elif LANES == 16
#define LANE_INDEX (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15)
#if LANES_IN_USE == 9
#define GATHER_LANES(from, i)                                                                      \
    (float16)((from)[i.s0], (from)[i.s1], (from)[i.s2], (from)[i.s3], (from)[i.s4], (from)[i.s5],  \
              (from)[i.s6], (from)[i.s7], (from)[i.s8], 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f)
#define GATHER_INTS(from, i)                                                                       \
    (int16)((int)(from)[i.s0], (int)(from)[i.s1], (int)(from)[i.s2], (int)(from)[i.s3],            \
            (int)(from)[i.s4], (int)(from)[i.s5], (int)(from)[i.s6], (int)(from)[i.s7],            \
            (int)(from)[i.s8], 0, 0, 0, 0, 0, 0, 0)
#else
#define GATHER_LANES(from, i)                                                                      \
    (float16)((from)[i.s0], (from)[i.s1], (from)[i.s2], (from)[i.s3], (from)[i.s4], (from)[i.s5],  \
              (from)[i.s6], (from)[i.s7], (from)[i.s8], (from)[i.s9], (from)[i.sa], (from)[i.sb],  \
              (from)[i.sc], (from)[i.sd], (from)[i.se], (from)[i.sf])
#define GATHER_INTS(from, i)                                                                       \
    (int16)((int)(from)[i.s0], (int)(from)[i.s1], (int)(from)[i.s2], (int)(from)[i.s3],            \
            (int)(from)[i.s4], (int)(from)[i.s5], (int)(from)[i.s6], (int)(from)[i.s7],            \
            (int)(from)[i.s8], (int)(from)[i.s9], (int)(from)[i.sa], (int)(from)[i.sb],            \
            (int)(from)[i.sc], (int)(from)[i.sd], (int)(from)[i.se], (int)(from)[i.sf])
#endif
static int count_lanes(const int16 mask) {
    const int16 ones = mask & 1;
    const int8 eight = ones.lo + ones.hi;
    const int4 four = eight.lo + eight.hi;
    return four.x + four.y + four.z + four.w;
}
static float largest_lane(const float16 x) {
    const float8 eight = max(x.lo, x.hi);
    const float4 four = max(eight.lo, eight.hi);
    return max(max(four.x, four.y), max(four.z, four.w));
}
#endif

#else
typedef LanesOf<float, LANES> lanes_float;
typedef LanesOf<int, LANES> lanes_int;
typedef LanesOf<int, LANES> lanes_mask;
#define LANE_INDEX first_numbers<LANES>()
#define TO_FLOAT(x) to_float_lanes(x)
#define FLOOR_TO_INT(x) floor_to_int_lanes(x)
#define LOAD_LANES(from) load_lanes<lanes_float>(from)
#define STORE_LANES(mask, to) store_lanes(mask, to)
#define GATHER_LANES(from, i) gather_lanes<LANES_IN_USE, float>(from, i)
#define GATHER_INTS(from, i) gather_lanes<LANES_IN_USE, int>(from, i)
#define SQUARE_ROOT(x) square_root(x)
#define ANY(mask) any_lane(mask)
#define COUNT(mask) count_true_lanes(mask)
#define LANE_BITS(mask) lane_bits(mask)
#define LARGEST(x) largest_of_lanes(x)
#define ROUND_TO_INT(x) round_to_int_lanes(x)
#define LOAD_BYTES(from) convert_lanes<LANES>(from)
#define LOAD_INTS(from) load_lanes<lanes_int>(from)
#define SELECT(a, b, mask) select(a, b, mask)
#endif
