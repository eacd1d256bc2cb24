// Lanes (kernels/shared/lanes.h) for counting operations. Lanes are computed one after the other by
// the functions for single numbers, with the same results as lanes of opencl_c.hpp, which includes
// this file.

inline int sum(int a, int b) {
    return static_cast<int>(static_cast<uint>(a) + static_cast<uint>(b));
}
inline int difference(int a, int b) {
    return static_cast<int>(static_cast<uint>(a) - static_cast<uint>(b));
}
inline int product(int a, int b) {
    return static_cast<int>(static_cast<uint>(a) * static_cast<uint>(b));
}
inline float sum(float a, float b) {
    return a + b;
}
inline float difference(float a, float b) {
    return a - b;
}
inline float product(float a, float b) {
    return a * b;
}

template <class T, int n>
struct LanesOf {
    T each[n];
    LanesOf() = default;
    LanesOf(T all) {
        for (T& one : each) one = all;
    }
    template <class U>
    requires(std::is_arithmetic_v<U> && !std::is_same_v<U, T>) LanesOf(U all)
        : LanesOf(static_cast<T>(all)) {}

#define LANES_FUNCTION(Result, name, parameters, value)                                            \
    friend LanesOf<Result, n> name parameters {                                                    \
        LanesOf<Result, n> result;                                                                 \
        for (int i = 0; i < n; ++i) result.each[i] = value;                                        \
        return result;                                                                             \
    }
#define OF_TWO (const LanesOf& a, const LanesOf& b)
    LANES_FUNCTION(T, operator+, OF_TWO, sum(a.each[i], b.each[i]))
    LANES_FUNCTION(T, operator-, OF_TWO, difference(a.each[i], b.each[i]))
    LANES_FUNCTION(T, operator*, OF_TWO, product(a.each[i], b.each[i]))
    LANES_FUNCTION(T, operator/, OF_TWO, a.each[i] / b.each[i])
    LANES_FUNCTION(T, operator-, (const LanesOf& a), -a.each[i])
    LANES_FUNCTION(int, operator<, OF_TWO, a.each[i] < b.each[i] ? -1 : 0)
    LANES_FUNCTION(int, operator>, OF_TWO, a.each[i] > b.each[i] ? -1 : 0)
    LANES_FUNCTION(int, operator<=, OF_TWO, a.each[i] <= b.each[i] ? -1 : 0)
    LANES_FUNCTION(int, operator>=, OF_TWO, a.each[i] >= b.each[i] ? -1 : 0)
    LANES_FUNCTION(int, operator==, OF_TWO, a.each[i] == b.each[i] ? -1 : 0)
    LANES_FUNCTION(int, operator!=, OF_TWO, a.each[i] != b.each[i] ? -1 : 0)
    LANES_FUNCTION(T, operator&, OF_TWO, a.each[i] & b.each[i])
    LANES_FUNCTION(T, operator|, OF_TWO, a.each[i] | b.each[i])
    LANES_FUNCTION(T, operator<<, (const LanesOf& a, int bits), a.each[i] << bits)
    LANES_FUNCTION(T, operator>>, (const LanesOf& a, int bits), a.each[i] >> bits)
    // For results of comparisons, which are -1 or 0.
    LANES_FUNCTION(T, operator&&, OF_TWO, a.each[i] & b.each[i])
    LANES_FUNCTION(T, operator||, OF_TWO, a.each[i] | b.each[i])
    LANES_FUNCTION(T, operator!, (const LanesOf& a), ~a.each[i])
    LANES_FUNCTION(T, min, OF_TWO, b.each[i] < a.each[i] ? b.each[i] : a.each[i])
    LANES_FUNCTION(T, max, OF_TWO, a.each[i] < b.each[i] ? b.each[i] : a.each[i])
    LANES_FUNCTION(T, fmin, OF_TWO, fmin(a.each[i], b.each[i]))
    LANES_FUNCTION(T, fmax, OF_TWO, fmax(a.each[i], b.each[i]))
    LANES_FUNCTION(T, fabs, (const LanesOf& a), fabs(a.each[i]))
    LANES_FUNCTION(T, copysign, OF_TWO, copysign(a.each[i], b.each[i]))
#undef OF_TWO
#undef LANES_FUNCTION
    LanesOf& operator+=(const LanesOf& b) {
        return *this = *this + b;
    }
};

template <class To, class From, int n, class Function>
LanesOf<To, n> converted(const LanesOf<From, n>& a, const Function& function) {
    LanesOf<To, n> result;
    for (int i = 0; i < n; ++i) result.each[i] = function(a.each[i]);
    return result;
}
template <int n>
LanesOf<float, n> to_float_lanes(const LanesOf<int, n>& a) {
    return converted<float>(a, [](int v) { return static_cast<float>(v); });
}
template <int n>
LanesOf<int, n> floor_to_int_lanes(const LanesOf<float, n>& a) {
    return converted<int>(a, [](float v) { return convert_int_rtn(v); });
}
template <int n>
LanesOf<int, n> round_to_int_lanes(const LanesOf<float, n>& a) {
    return converted<int>(a, [](float v) { return convert_int_rte(v); });
}
template <int n>
LanesOf<float, n> square_root(const LanesOf<float, n>& a) {
    return converted<float>(a, [](float v) { return sqrt(v); });
}
template <int n>
bool any_lane(const LanesOf<int, n>& mask) {
    for (const int one : mask.each)
        if (one != 0) return true;
    return false;
}
template <int n>
uint lane_bits(const LanesOf<int, n>& mask) {
    uint bits = 0;
    for (int i = 0; i < n; ++i) bits |= static_cast<uint>(mask.each[i]) & (1U << i);
    return bits;
}
template <class T, int n>
LanesOf<T, n> select(const LanesOf<T, n>& a, const LanesOf<T, n>& b, const LanesOf<int, n>& mask) {
    LanesOf<T, n> result;
    for (int i = 0; i < n; ++i) result.each[i] = mask.each[i] != 0 ? b.each[i] : a.each[i];
    return result;
}
template <int n>
int count_true_lanes(const LanesOf<int, n>& mask) {
    int count = 0;
    for (const int one : mask.each) count -= one;
    return count;
}
template <int n>
float largest_of_lanes(const LanesOf<float, n>& a) {
    float largest = a.each[0];
    for (int i = 1; i < n; ++i) largest = max(largest, a.each[i]);
    return largest;
}
template <int n>
LanesOf<int, n> convert_lanes(const uchar* from) {
    LanesOf<int, n> result;
    for (int i = 0; i < n; ++i) result.each[i] = from[i];
    return result;
}
template <class T, int n, class To>
void store_lanes(const LanesOf<T, n>& lanes, To* to) {
    for (int i = 0; i < n; ++i) to[i] = static_cast<To>(lanes.each[i]);
}
template <int in_use, class T, class From, int n>
LanesOf<T, n> gather_lanes(const From* from, const LanesOf<int, n>& at) {
    LanesOf<T, n> result{T{}};
    for (int i = 0; i < in_use; ++i) result.each[i] = static_cast<T>(from[at.each[i]]);
    return result;
}
template <class Lanes, class From>
Lanes load_lanes(const From* from) {
    Lanes result;
    int i = 0;
    for (auto& one : result.each)
        one = static_cast<std::remove_reference_t<decltype(one)>>(from[i++]);
    return result;
}
template <int n>
LanesOf<int, n> first_numbers() {
    LanesOf<int, n> result;
    for (int i = 0; i < n; ++i) result.each[i] = i;
    return result;
}
