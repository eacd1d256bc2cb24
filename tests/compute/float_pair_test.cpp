// Pairs of floats (kernels/shared/float_pair.h) against double.

#include <cmath>

#include "test_meshes.hpp"

#include "segment_table.h"
#include "shared/constants.h"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace kernel {
#include "compute/cpp/opencl_c.hpp"

#include "shared/float_pair.h"
} // namespace kernel
namespace {

using kernel::FloatPair;

constexpr double precision = 0x1p-46; // of a sum, and of a product

double value(const FloatPair& pair) {
    return double{pair.high} + double{pair.low};
}

/// A pair with more bits than a float.
FloatPair any_pair(Random& random) {
    const float size = std::exp2(random.between(-12, 12));
    return kernel::pair_of_sum(random.between(-size, size), random.between(-1e-8F, 1e-8F) * size);
}

TEST(FloatPair, SumsAndProductsOfFloatsAreExact) {
    Random random{1};
    for (int k = 0; k < 100000; ++k) {
        const float a = random.between(-100, 100);
        const float b = random.between(-1, 1) * std::exp2(random.between(-15, 5));
        EXPECT_EQ(value(kernel::pair_of_sum(a, b)), double{a} + double{b});
        EXPECT_EQ(value(kernel::pair_of_product(a, b)), double{a} * double{b});
    }
}

TEST(FloatPair, SumsAndProductsOfPairsAreAsGoodAsTheirBits) {
    Random random{2};
    for (int k = 0; k < 100000; ++k) {
        const FloatPair a = any_pair(random), b = any_pair(random);
        const double size = std::abs(value(a)) + std::abs(value(b));
        EXPECT_NEAR(value(kernel::add_pairs(a, b)), value(a) + value(b), precision * size);
        EXPECT_NEAR(value(kernel::subtract_pairs(a, b)), value(a) - value(b), precision * size);
        EXPECT_NEAR(value(kernel::multiply_pairs(a, b)), value(a) * value(b),
                    precision * std::abs(value(a) * value(b)));
    }
}

TEST(FloatPair, ADeterminantKnowsItsSign) {
    // Three vectors that nearly lie in a plane, for which floats alone give the wrong sign.
    Random random{3};
    int floats_wrong = 0;
    for (int k = 0; k < 20000; ++k) {
        const kernel::float3 from{random.between(-50, 50), random.between(-50, 50), 7};
        const auto place = [&](float x, float y, float off) {
            return kernel::float3{from.x + x, from.y + y, 7 + 0.3F * x - 0.2F * y + off};
        };
        const auto somewhere = [&] { return random.between(-20, 20); };
        const kernel::float3 a = place(somewhere(), somewhere(), 2e-6F),
                             b = place(somewhere(), somewhere(), 0),
                             c = place(somewhere(), somewhere(), 0);
        const kernel::PairVector u = kernel::pair_difference(a, from),
                                 v = kernel::pair_difference(b, from),
                                 w = kernel::pair_difference(c, from);
        const auto d = [](const FloatPair& pair) { return value(pair); };
        const double exact = d(u.x) * (d(v.y) * d(w.z) - d(v.z) * d(w.y)) +
                             d(u.y) * (d(v.z) * d(w.x) - d(v.x) * d(w.z)) +
                             d(u.z) * (d(v.x) * d(w.y) - d(v.y) * d(w.x));
        const double size = std::abs(d(u.x) * d(v.y) * d(w.z)) +
                            std::abs(d(u.y) * d(v.z) * d(w.x)) +
                            std::abs(d(u.z) * d(v.x) * d(w.y)) + 1e-6;
        if (std::abs(exact) > 1e-10 * size) {
            EXPECT_EQ(kernel::pair_determinant(u, v, w) > 0, exact > 0) << exact << " of " << size;
        }
        EXPECT_EQ(kernel::pair_determinant(u, v, w), -kernel::pair_determinant(u, w, v));
        const float plain = u.x.high * (v.y.high * w.z.high - v.z.high * w.y.high) +
                            u.y.high * (v.z.high * w.x.high - v.x.high * w.z.high) +
                            u.z.high * (v.x.high * w.y.high - v.y.high * w.x.high);
        floats_wrong += (plain > 0) != (exact > 0) ? 1 : 0;
    }
    EXPECT_GT(floats_wrong, 100); // otherwise this test does not need pairs
}

} // namespace
} // namespace lineatlas::test
