#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "segment_table.h"

// Comparers for stages and pictures. Each is itself tested with planted errors (compare_test.cpp).
namespace lineatlas::test {

/// The first index at which two arrays of integers differ. Arrays of different length differ.
template <class T>
std::optional<std::size_t> first_difference(std::span<const T> a, std::span<const T> b) {
    const std::size_t common = std::min(a.size(), b.size());
    for (std::size_t i = 0; i < common; ++i) {
        if (a[i] != b[i]) return i;
    }
    if (a.size() != b.size()) return common;
    return std::nullopt;
}

/// Equal bit by bit, with the first difference in the message.
template <class T>
testing::AssertionResult equal(const std::vector<T>& a, const std::vector<T>& b) {
    const auto index = first_difference<T>(a, b);
    if (!index) return testing::AssertionSuccess();
    auto result = testing::AssertionFailure() << "sizes " << a.size() << ", " << b.size();
    if (*index < a.size() && *index < b.size()) {
        result << "; first difference at " << *index << ": " << +a[*index] << ", " << +b[*index];
    }
    return result;
}

/// Equal within `relative` of the larger magnitude; below `absolute` all values are equal.
bool close(float a, float b, float relative = 1e-5F, float absolute = 1e-6F);

/// True if two arrays have the same length and bytes.
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return std::ranges::equal(std::as_bytes(std::span{a}), std::as_bytes(std::span{b}));
}

/// True if two clipped segments agree: floats by `close`, the packed faces to the last kept bit.
bool close(const ClippedSegment& a, const ClippedSegment& b);
/// True if two runs agree: integers exactly, floats within a thousandth of a pixel.
bool close(const Run& a, const Run& b);
/// True if two runs have the same gaps, within a thousandth of a pixel.
bool close(const RunCuts& a, const RunCuts& b);

/// True if two intervals agree: integers exactly, floats within a thousandth of a pixel.
bool close(const Interval& a, const Interval& b);

/// The difference between two arrays of 8-bit values.
struct ByteDifference {
    std::size_t count = 0;  ///< values compared
    std::size_t beyond = 0; ///< values that differ by more than the allowed step
    int largest = 0;
    double share() const {
        return count == 0 ? 0 : static_cast<double>(beyond) / static_cast<double>(count);
    }
};

/// Arrays of different length differ everywhere.
ByteDifference compare_bytes(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                             int allowed = 1);

} // namespace lineatlas::test
