#pragma once

#include <cstdint>
#include <type_traits>

namespace lineatlas::compute {

/// Operations of this thread so far.
inline thread_local std::uint64_t counted_operations = 0;

/// A float that counts operations: sums, differences, products, quotients, roots and comparisons.
/// It is as large as a float and behaves like one wherever kernels use it.
struct CountedFloat {
    float value;

    CountedFloat() = default;
    template <class T>
    requires std::is_arithmetic_v<T> CountedFloat(T from) : value(static_cast<float>(from)) {}
    template <class T>
    requires std::is_arithmetic_v<T>
    explicit operator T() const { return static_cast<T>(value); }

#define COUNTED_OPERATOR(Result, op)                                                               \
    friend Result operator op(CountedFloat a, CountedFloat b) {                                    \
        ++counted_operations;                                                                      \
        return a.value op b.value;                                                                 \
    }
    COUNTED_OPERATOR(CountedFloat, +)
    COUNTED_OPERATOR(CountedFloat, -)
    COUNTED_OPERATOR(CountedFloat, *)
    COUNTED_OPERATOR(CountedFloat, /)
    COUNTED_OPERATOR(bool, <)
    COUNTED_OPERATOR(bool, >)
    COUNTED_OPERATOR(bool, <=)
    COUNTED_OPERATOR(bool, >=)
    COUNTED_OPERATOR(bool, ==)
    COUNTED_OPERATOR(bool, !=)
#undef COUNTED_OPERATOR
    CountedFloat operator-() const {
        return -value;
    }
    CountedFloat& operator+=(CountedFloat b) {
        return *this = *this + b;
    }
    CountedFloat& operator-=(CountedFloat b) {
        return *this = *this - b;
    }
    CountedFloat& operator*=(CountedFloat b) {
        return *this = *this * b;
    }
    CountedFloat& operator/=(CountedFloat b) {
        return *this = *this / b;
    }
};
static_assert(sizeof(CountedFloat) == sizeof(float) && std::is_trivially_copyable_v<CountedFloat>);

} // namespace lineatlas::compute
