// OpenCL C, as far as kernels use it, as C++20: the C++ side of kernels/shared/language.h. It is
// included in the namespace of each instruction set (kernels.cpp), which share none of it. So it
// has no include guard, and uses no standard library, whose functions would be shared.

using uint = unsigned int;
using uchar = unsigned char;
using la_long = long long;
using ulong = unsigned long long;
using size_t = decltype(sizeof(0));
// The argument for builtin functions; a counting float (counted_float.hpp) needs a conversion.
#ifndef PLAIN_FLOAT
#define PLAIN_FLOAT(v) (v)
#endif
#ifndef INFINITY
#define INFINITY __builtin_inff()
#endif

/// The work-item that a kernel runs as.
struct WorkItem {
    size_t id, count;
};
#define get_global_id(dimension) work_item.id
#define get_global_size(dimension) work_item.count

#define __global
#define __local
#define LOCAL_TABLE(type, name, count) alignas(64) type name[count]
#define FUNCTION static
#define INLINED static inline __attribute__((always_inline))
#define LA_TYPEDEF(name)
#define float_of(v) static_cast<float>(v)
#define int_of(v) static_cast<int>(v)
#define restrict __restrict
#define TABLE_ARGUMENT(type, name) const type *name,
#define TABLE_AT(name, i) name[i]
#define TABLE_IN(type, name) , const type* __restrict name
#define TABLE_OUT(type, name) , type* __restrict name
#define KERNEL(name, Parameters)                                                                   \
    static inline void name(                                                                       \
        const WorkItem work_item,                                                                  \
        const Parameters& args name##_tables(TABLE_IN, TABLE_OUT, TABLE_OUT, TABLE_OUT))

// Vectors of two, three and four: what a kernel computes with per element.

// Constructors of vectors of counting floats from plain floats.
#ifdef LINEATLAS_COUNTED
#define FROM_PLAIN_FLOAT(Vector)                                                                   \
    template <class U>                                                                             \
    requires(__is_same(U, decltype(0.0F)) && __is_class(T)) Vector(U all) : Vector(T(all)) {}
#else
#define FROM_PLAIN_FLOAT(Vector)
#endif
#define VECTOR_OPERATOR(Vector, op, each)                                                          \
    friend Vector operator op(const Vector& a, const Vector& b) {                                  \
        return each(op);                                                                           \
    }                                                                                              \
    Vector& operator op##=(const Vector& b) {                                                      \
        return *this = *this op b;                                                                 \
    }
#define VECTOR_OPERATORS(Vector, each)                                                             \
    VECTOR_OPERATOR(Vector, +, each)                                                               \
    VECTOR_OPERATOR(Vector, -, each)                                                               \
    VECTOR_OPERATOR(Vector, *, each)                                                               \
    VECTOR_OPERATOR(Vector, /, each)

template <class T>
struct Vector2 {
    T x, y;
    Vector2() = default;
    Vector2(T all) : x(all), y(all) {}
    FROM_PLAIN_FLOAT(Vector2)
    Vector2(T x_, T y_) : x(x_), y(y_) {}
#define EACH(op) Vector2(a.x op b.x, a.y op b.y)
    VECTOR_OPERATORS(Vector2, EACH)
#undef EACH
};
template <class T>
struct Vector3 {
    T x, y, z;
    Vector3() = default;
    Vector3(T all) : x(all), y(all), z(all) {}
    FROM_PLAIN_FLOAT(Vector3)
    Vector3(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
#define EACH(op) Vector3(a.x op b.x, a.y op b.y, a.z op b.z)
    VECTOR_OPERATORS(Vector3, EACH)
#undef EACH
};
template <class T>
struct Vector4 {
    T x, y, z, w;
    Vector4() = default;
    Vector4(T all) : x(all), y(all), z(all), w(all) {}
    FROM_PLAIN_FLOAT(Vector4)
    Vector4(T x_, T y_, T z_, T w_) : x(x_), y(y_), z(z_), w(w_) {}
#define EACH(op) Vector4(a.x op b.x, a.y op b.y, a.z op b.z, a.w op b.w)
    VECTOR_OPERATORS(Vector4, EACH)
#undef EACH
};
#undef VECTOR_OPERATORS
#undef FROM_PLAIN_FLOAT
#undef VECTOR_OPERATOR

using float2 = Vector2<float>;
using float3 = Vector3<float>;
using float4 = Vector4<float>;
using int2 = Vector2<int>;
using int4 = Vector4<int>;
using uint2 = Vector2<uint>;

template <class T>
Vector2<T> xy(const Vector3<T>& v) {
    return {v.x, v.y};
}
template <class T>
Vector2<T> xy(const Vector4<T>& v) {
    return {v.x, v.y};
}
template <class T>
Vector2<T> zw(const Vector4<T>& v) {
    return {v.z, v.w};
}
template <class T>
Vector3<T> xyz(const Vector4<T>& v) {
    return {v.x, v.y, v.z};
}

template <class T>
Vector2<T> vload2(size_t i, const T* from) {
    return {from[2 * i], from[2 * i + 1]};
}
template <class T>
Vector3<T> vload3(size_t i, const T* from) {
    return {from[3 * i], from[3 * i + 1], from[3 * i + 2]};
}
template <class T>
Vector4<T> vload4(size_t i, const T* from) {
    return {from[4 * i], from[4 * i + 1], from[4 * i + 2], from[4 * i + 3]};
}
template <class T>
void vstore2(const Vector2<T>& v, size_t i, T* to) {
    to[2 * i] = v.x, to[2 * i + 1] = v.y;
}
template <class T>
void vstore3(const Vector3<T>& v, size_t i, T* to) {
    to[3 * i] = v.x, to[3 * i + 1] = v.y, to[3 * i + 2] = v.z;
}
template <class T>
void vstore4(const Vector4<T>& v, size_t i, T* to) {
    to[4 * i] = v.x, to[4 * i + 1] = v.y, to[4 * i + 2] = v.z, to[4 * i + 3] = v.w;
}

// Parameters, in the layout that the host gives them.

using la_int = int;
struct la_vec2 {
    float v[2];
};
struct la_vec4 {
    float v[4];
};
struct la_ivec2 {
    int v[2];
};
struct la_ivec4 {
    int v[4];
};
struct la_mat4 {
    float v[16];
};
inline float2 to_float2(const la_vec2& value) {
    return vload2(0, value.v);
}
inline float4 to_float4(const la_vec4& value) {
    return vload4(0, value.v);
}
inline int2 to_int2(const la_ivec2& value) {
    return vload2(0, value.v);
}
inline int4 to_int4(const la_ivec4& value) {
    return vload4(0, value.v);
}
struct Matrix {
    float4 x, y, z, w;
};
inline Matrix to_matrix(const la_mat4& value) {
    return {vload4(0, value.v), vload4(1, value.v), vload4(2, value.v), vload4(3, value.v)};
}

// Functions with OpenCL's results for arguments that are not numbers. They use |, which compiles to
// no branch.

inline float fmin(float a, float b) {
    return ((b < a) | (a != a)) ? b : a;
}
inline float fmax(float a, float b) {
    return ((a < b) | (a != a)) ? b : a;
}
inline float max(float a, float b) {
    return a < b ? b : a;
}
inline float2 fmin(float2 a, float2 b) {
    return {fmin(a.x, b.x), fmin(a.y, b.y)};
}
inline float2 fmax(float2 a, float2 b) {
    return {fmax(a.x, b.x), fmax(a.y, b.y)};
}
inline float3 fmin(float3 a, float3 b) {
    return {fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z)};
}
inline float3 fmax(float3 a, float3 b) {
    return {fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z)};
}
inline float fabs(float a) {
    return __builtin_fabsf(PLAIN_FLOAT(a));
}
inline float sqrt(float a) {
    return __builtin_sqrtf(PLAIN_FLOAT(a));
}
inline float copysign(float size, float sign) {
    return __builtin_copysignf(PLAIN_FLOAT(size), PLAIN_FLOAT(sign));
}
inline uint abs(int a) {
    return a < 0 ? 0U - static_cast<uint>(a) : static_cast<uint>(a);
}
inline int min(int a, int b) {
    return b < a ? b : a;
}
inline int max(int a, int b) {
    return a < b ? b : a;
}
inline uint min(uint a, uint b) {
    return b < a ? b : a;
}
inline uint max(uint a, uint b) {
    return a < b ? b : a;
}
inline uchar max(uchar a, uchar b) {
    return a < b ? b : a;
}
inline ulong min(ulong a, ulong b) {
    return b < a ? b : a;
}
inline la_long min(la_long a, la_long b) {
    return b < a ? b : a;
}
inline la_long max(la_long a, la_long b) {
    return a < b ? b : a;
}
inline int clamp(int v, int low, int high) {
    return min(max(v, low), high);
}
inline float clamp(float v, float low, float high) {
    return fmin(fmax(v, low), high);
}
inline int2 clamp(int2 v, int2 low, int2 high) {
    return {clamp(v.x, low.x, high.x), clamp(v.y, low.y, high.y)};
}
inline uint add_sat(uint a, uint b) {
    return a + b < a ? 0xFFFFFFFFU : a + b;
}
inline uint as_uint(float v) {
    return __builtin_bit_cast(uint, v);
}
inline float as_float(uint v) {
    return __builtin_bit_cast(float, v);
}

inline uint lowest_bit(uint bits) {
    return static_cast<uint>(__builtin_ctz(bits));
}

/// Rounds to the nearest int, and to the even one if two are as near.
inline int convert_int_rte(float v) {
    return static_cast<int>(__builtin_nearbyintf(PLAIN_FLOAT(v)));
}
/// Rounds down, or up below. There is no floorf(), which is a function call without SSE 4.1.
inline int convert_int_rtn(float v) {
    const int cut = static_cast<int>(v);
    return cut - (static_cast<float>(cut) > v ? 1 : 0);
}
inline int convert_int_rtp(float v) {
    const int cut = static_cast<int>(v);
    return cut + (static_cast<float>(cut) < v ? 1 : 0);
}
inline int convert_int_sat_rtn(float v) {
    if (v != v) return 0;
    if (v >= 0x1p31F) return 0x7FFFFFFF;
    return v < -0x1p31F ? -0x7FFFFFFF - 1 : convert_int_rtn(v);
}
inline int2 convert_int2(float2 v) {
    return {static_cast<int>(v.x), static_cast<int>(v.y)};
}
inline int2 convert_int2_rtn(float2 v) {
    return {convert_int_rtn(v.x), convert_int_rtn(v.y)};
}
inline float2 convert_float2(int2 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}
/// Numbers from 2^23 on are whole.
inline float floor(float v) {
    return fabs(v) < 0x1p23F ? copysign(static_cast<float>(convert_int_rtn(v)), v) : v;
}
inline float ceil(float v) {
    return fabs(v) < 0x1p23F ? copysign(static_cast<float>(convert_int_rtp(v)), v) : v;
}
inline float2 floor(float2 v) {
    return {floor(v.x), floor(v.y)};
}

inline uint atomic_add(uint* to, uint v) {
    return __atomic_fetch_add(to, v, __ATOMIC_RELAXED);
}
inline uint atomic_max(uint* to, uint v) {
    uint old = __atomic_load_n(to, __ATOMIC_RELAXED);
    while (old < v &&
           !__atomic_compare_exchange_n(to, &old, v, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
    }
    return old;
}
inline uint atomic_min(uint* to, uint v) {
    uint old = __atomic_load_n(to, __ATOMIC_RELAXED);
    while (old > v &&
           !__atomic_compare_exchange_n(to, &old, v, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
    }
    return old;
}
inline ulong atom_min(ulong* to, ulong v) {
    ulong old = __atomic_load_n(to, __ATOMIC_RELAXED);
    while (old > v &&
           !__atomic_compare_exchange_n(to, &old, v, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
    }
    return old;
}
inline uint atomic_inc(uint* to) {
    return atomic_add(to, 1);
}

// Lanes, see kernels/shared/lanes.h.

#ifdef LINEATLAS_COUNTED
#include "counted_lanes.hpp"
#else
/// The compiler's own vectors.
template <class T, int n>
struct VectorOf {
    typedef T type __attribute__((vector_size(n * sizeof(T))));
};

template <class T, int n>
struct LanesOf {
    using All = typename VectorOf<T, n>::type;
    using Mask = typename VectorOf<int, n>::type;
    /// Integers wrap, as on every device, because numbers in lanes that a kernel does not use may
    /// be of any size.
    using Wrapping =
        std::conditional_t<std::is_same_v<T, int>, typename VectorOf<uint, n>::type, All>;
    All all;
    LanesOf() = default;
    LanesOf(All all_) : all(all_) {}
    LanesOf(T each) : all(each - All{}) {}
    friend LanesOf operator+(const LanesOf& a, const LanesOf& b) {
        return All(Wrapping(a.all) + Wrapping(b.all));
    }
    friend LanesOf operator-(const LanesOf& a, const LanesOf& b) {
        return All(Wrapping(a.all) - Wrapping(b.all));
    }
    friend LanesOf operator*(const LanesOf& a, const LanesOf& b) {
        return All(Wrapping(a.all) * Wrapping(b.all));
    }
    friend LanesOf operator/(const LanesOf& a, const LanesOf& b) { return a.all / b.all; }
    friend LanesOf operator-(const LanesOf& a) { return All(-Wrapping(a.all)); }
    friend LanesOf<int, n> operator<(const LanesOf& a, const LanesOf& b) { return a.all < b.all; }
    friend LanesOf<int, n> operator>(const LanesOf& a, const LanesOf& b) { return a.all > b.all; }
    friend LanesOf<int, n> operator<=(const LanesOf& a, const LanesOf& b) { return a.all <= b.all; }
    friend LanesOf<int, n> operator>=(const LanesOf& a, const LanesOf& b) { return a.all >= b.all; }
    friend LanesOf operator&(const LanesOf& a, const LanesOf& b) { return a.all & b.all; }
    friend LanesOf operator|(const LanesOf& a, const LanesOf& b) { return a.all | b.all; }
    friend LanesOf operator<<(const LanesOf& a, int bits) { return a.all << bits; }
    friend LanesOf operator>>(const LanesOf& a, int bits) { return a.all >> bits; }
    friend LanesOf<int, n> operator==(const LanesOf& a, const LanesOf& b) { return a.all == b.all; }
    friend LanesOf<int, n> operator!=(const LanesOf& a, const LanesOf& b) { return a.all != b.all; }
    LanesOf& operator+=(const LanesOf& b) { return *this = *this + b; }
    // For results of comparisons, which are -1 or 0.
    friend LanesOf operator&&(const LanesOf& a, const LanesOf& b) { return a.all & b.all; }
    friend LanesOf operator||(const LanesOf& a, const LanesOf& b) { return a.all | b.all; }
    friend LanesOf operator!(const LanesOf& a) { return ~a.all; }

    friend LanesOf min(const LanesOf& a, const LanesOf& b) { return b.all < a.all ? b.all : a.all; }
    friend LanesOf max(const LanesOf& a, const LanesOf& b) { return a.all < b.all ? b.all : a.all; }
    friend LanesOf fmin(const LanesOf& a, const LanesOf& b) {
        return ((b.all < a.all) | (a.all != a.all)) ? b.all : a.all;
    }
    friend LanesOf fmax(const LanesOf& a, const LanesOf& b) {
        return ((a.all < b.all) | (a.all != a.all)) ? b.all : a.all;
    }
    friend LanesOf fabs(const LanesOf& a) {
        return __builtin_bit_cast(All, __builtin_bit_cast(Mask, a.all) & 0x7FFFFFFF);
    }
    friend LanesOf copysign(const LanesOf& size, const LanesOf& sign) {
        const Mask bits = __builtin_bit_cast(Mask, fabs(size).all);
        return __builtin_bit_cast(All, bits | (__builtin_bit_cast(Mask, sign.all) & ~0x7FFFFFFF));
    }
};
template <int n>
LanesOf<float, n> to_float_lanes(const LanesOf<int, n>& a) {
    return __builtin_convertvector(a.all, typename LanesOf<float, n>::All);
}
template <int n>
LanesOf<int, n> floor_to_int_lanes(const LanesOf<float, n>& a) {
    using Ints = typename LanesOf<int, n>::All;
    const Ints cut = __builtin_convertvector(a.all, Ints);
    return cut + static_cast<Ints>(to_float_lanes(LanesOf<int, n>{cut}).all > a.all); // -1 for true
}
template <int n>
LanesOf<int, n> round_to_int_lanes(const LanesOf<float, n>& a) {
    // Written out, because g++ 12 takes the vector apart for nearbyint().
    const LanesOf<int, n> cut = __builtin_convertvector(a.all, typename LanesOf<int, n>::All);
    const LanesOf<float, n> rest = a - to_float_lanes(cut);
    const auto odd = (cut.all & 1) != 0;
    const auto up = (rest.all > 0.5F) | ((rest.all == 0.5F) & odd);
    const auto down = (rest.all < -0.5F) | ((rest.all == -0.5F) & odd);
    return cut.all - static_cast<typename LanesOf<int, n>::All>(up) +
           static_cast<typename LanesOf<int, n>::All>(down); // -1 for true
}
/// The bitwise or of all lanes, by halves, because a loop would take lanes out one by one.
inline uint or_of_lanes(const VectorOf<int, 4>::type& a) {
    const auto halves = __builtin_bit_cast(VectorOf<long long, 2>::type, a);
    const auto both = static_cast<ulong>(halves[0] | halves[1]);
    return static_cast<uint>(both) | static_cast<uint>(both >> 32);
}
inline uint or_of_lanes(const VectorOf<int, 8>::type& a) {
    return or_of_lanes(__builtin_shufflevector(a, a, 0, 1, 2, 3) |
                       __builtin_shufflevector(a, a, 4, 5, 6, 7));
}
inline uint or_of_lanes(const VectorOf<int, 16>::type& a) {
    return or_of_lanes(__builtin_shufflevector(a, a, 0, 1, 2, 3, 4, 5, 6, 7) |
                       __builtin_shufflevector(a, a, 8, 9, 10, 11, 12, 13, 14, 15));
}
template <int n>
bool any_lane(const LanesOf<int, n>& mask) {
    return or_of_lanes(mask.all) != 0;
}
template <int n>
uint lane_bits(const LanesOf<int, n>& mask) {
    typename LanesOf<int, n>::All bits;
    for (int i = 0; i < n; ++i) bits[i] = 1 << i;
    return or_of_lanes(mask.all & bits);
}
template <int n>
LanesOf<float, n> select(const LanesOf<float, n>& a, const LanesOf<float, n>& b,
                         const LanesOf<int, n>& mask) {
    return mask.all ? b.all : a.all;
}
template <int n>
LanesOf<int, n> select(const LanesOf<int, n>& a, const LanesOf<int, n>& b,
                       const LanesOf<int, n>& mask) {
    return mask.all ? b.all : a.all;
}
template <int n>
LanesOf<int, n> convert_lanes(const uchar* from) {
    typename VectorOf<uchar, n>::type bytes;
    __builtin_memcpy(&bytes, from, sizeof(bytes));
    return __builtin_convertvector(bytes, typename LanesOf<int, n>::All);
}
template <class T, int n>
void store_lanes(const LanesOf<T, n>& lanes, T* to) {
    __builtin_memcpy(to, &lanes, sizeof(lanes));
}
template <int n>
int count_true_lanes(const LanesOf<int, n>& mask) {
    int sum = 0;
    for (int i = 0; i < n; ++i) sum -= mask.all[i];
    return sum;
}
template <int n>
float largest_of_lanes(const LanesOf<float, n>& a) {
    float largest = a.all[0];
    for (int i = 1; i < n; ++i) largest = max(largest, a.all[i]);
    return largest;
}
template <int in_use, class T, class From, int n>
LanesOf<T, n> gather_lanes(const From* from, const LanesOf<int, n>& at) {
    LanesOf<T, n> result{T{}};
    for (int i = 0; i < in_use; ++i) result.all[i] = static_cast<T>(from[at.all[i]]);
    return result;
}
template <int n>
LanesOf<float, n> square_root(const LanesOf<float, n>& a) {
    LanesOf<float, n> result{0.0F};
    for (int i = 0; i < n; ++i) result.all[i] = __builtin_sqrtf(a.all[i]);
    return result;
}
template <class Lanes, class T>
Lanes load_lanes(const T* from) {
    Lanes result;
    __builtin_memcpy(&result, from, sizeof(result));
    return result;
}
template <int n>
LanesOf<int, n> first_numbers() {
    LanesOf<int, n> result{0};
    for (int i = 0; i < n; ++i) result.all[i] = i;
    return result;
}
#endif
