#include "compare.hpp"

#include <algorithm>

#include "compute/compare/layouts.hpp"

namespace lineatlas::test {

namespace {

template <class T>
bool agree(const compute::Layout& layout, const T& a, const T& b) {
    return !compute::first_difference(layout, std::as_bytes(std::span{&a, 1}),
                                      std::as_bytes(std::span{&b, 1}));
}

} // namespace

bool close(float a, float b, float relative, float absolute) {
    return compute::agree(a, b, relative, absolute);
}
bool close(const ClippedSegment& a, const ClippedSegment& b) {
    return agree(compute::layout_of("ClippedSegment"), a, b);
}
bool close(const Run& a, const Run& b) {
    return agree(compute::layout_of("Run"), a, b);
}
bool close(const RunCuts& a, const RunCuts& b) {
    return agree(compute::layout_of("RunCuts"), a, b);
}
bool close(const Interval& a, const Interval& b) {
    return agree(compute::layout_of("Interval"), a, b);
}

ByteDifference compare_bytes(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                             int allowed) {
    if (a.size() != b.size()) {
        const std::size_t count = std::max(a.size(), b.size());
        return {.count = count, .beyond = count, .largest = 255};
    }
    ByteDifference result{.count = a.size()};
    for (std::size_t i = 0; i < a.size(); ++i) {
        const int difference = std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i]));
        result.largest = std::max(result.largest, difference);
        if (difference > allowed) ++result.beyond;
    }
    return result;
}

} // namespace lineatlas::test
