/* Numbers of twice a float's precision, as the sum of two floats (Dekker 1971, Knuth 1969), because
 * double is optional in OpenCL. A pair holds about 48 bits in the range of a float; products below
 * 1e-30 lose some of them. Nothing here survives compilers that reorder sums or contract products.
 */
#ifndef LINEATLAS_FLOAT_PAIR_H
#define LINEATLAS_FLOAT_PAIR_H

#include "shared/language.h"

typedef struct FloatPair {
    float high, low; /* abs(low) is at most half an ulp of high */
} FloatPair;

/* high + low as a pair; abs(high) is at least abs(low). */
static FloatPair normal_pair(const float high, const float low) {
    FloatPair sum;
    sum.high = high + low;
    sum.low = low - (sum.high - high);
    return sum;
}

/* a + b, exactly. */
static FloatPair pair_of_sum(const float a, const float b) {
    FloatPair sum;
    sum.high = a + b;
    const float from_b = sum.high - a;
    sum.low = (a - (sum.high - from_b)) + (b - from_b);
    return sum;
}

/* The upper half of a float's bits. */
static float upper_half(const float a) {
    const float shifted = 4097.0f * a;
    return shifted - (shifted - a);
}

/* a b, exactly. */
static FloatPair pair_of_product(const float a, const float b) {
    const float a_high = upper_half(a), b_high = upper_half(b);
    const float a_low = a - a_high, b_low = b - b_high;
    FloatPair product;
    product.high = a * b;
    product.low =
        a_low * b_low - (((product.high - a_high * b_high) - a_low * b_high) - a_high * b_low);
    return product;
}

static FloatPair add_pairs(const FloatPair a, const FloatPair b) {
    const FloatPair high = pair_of_sum(a.high, b.high), low = pair_of_sum(a.low, b.low);
    const FloatPair sum = normal_pair(high.high, high.low + low.high);
    return normal_pair(sum.high, sum.low + low.low);
}

static FloatPair subtract_pairs(const FloatPair a, const FloatPair b) {
    const FloatPair negative = {-b.high, -b.low};
    return add_pairs(a, negative);
}

static FloatPair multiply_pairs(const FloatPair a, const FloatPair b) {
    const FloatPair product = pair_of_product(a.high, b.high);
    return normal_pair(product.high, product.low + (a.high * b.low + a.low * b.high));
}

/* Vectors of pairs. */
typedef struct PairVector {
    FloatPair x, y, z;
} PairVector;

/* a - b, exactly. */
static PairVector pair_difference(const float3 a, const float3 b) {
    const PairVector difference = {pair_of_sum(a.x, -b.x), pair_of_sum(a.y, -b.y),
                                   pair_of_sum(a.z, -b.z)};
    return difference;
}

static FloatPair pair_minor(const FloatPair a, const FloatPair b, const FloatPair c,
                            const FloatPair d) {
    return subtract_pairs(multiply_pairs(a, d), multiply_pairs(b, c));
}

/* a . (b x c), six times the volume of the tetrahedron between them. If b and c change places, the
 * result changes its sign and no other bit. */
static float pair_determinant(const PairVector a, const PairVector b, const PairVector c) {
    const FloatPair x = multiply_pairs(a.x, pair_minor(b.y, b.z, c.y, c.z));
    const FloatPair y = multiply_pairs(a.y, pair_minor(b.z, b.x, c.z, c.x));
    const FloatPair z = multiply_pairs(a.z, pair_minor(b.x, b.y, c.x, c.y));
    return add_pairs(add_pairs(x, y), z).high;
}

#endif
