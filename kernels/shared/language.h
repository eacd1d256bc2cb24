/* What kernels are written in: OpenCL C 1.2 as far as C++20 can be made to read it too. This is the
 * OpenCL side; host/compute/cpp/opencl_c.hpp says the same things in C++. Three things differ from
 * plain OpenCL C. Vectors are made by `float2(x, y)`. Parts of vectors are taken by `xy(v)`. A
 * kernel is written KERNEL(name, Parameters) { ... }, and kernels.h lists its tables. */
#ifndef LINEATLAS_LANGUAGE_H
#define LINEATLAS_LANGUAGE_H

#ifdef __OPENCL_VERSION__
#pragma OPENCL FP_CONTRACT OFF

typedef uint la_uint;
typedef int la_int;
typedef long la_long; /* 64 bits, which a long of C++ need not have */

/* Vectors in parameters: 4-byte members only, which every compiler lays out alike. They are read
 * whole, because rusticl 22.3 cannot index a parameter by a variable. */
typedef struct la_vec2 {
    float v[2];
} la_vec2;
typedef struct la_vec4 {
    float v[4];
} la_vec4;
typedef struct la_ivec2 {
    int v[2];
} la_ivec2;
typedef struct la_ivec4 {
    int v[4];
} la_ivec4;
typedef struct la_mat4 {
    float v[16];
} la_mat4;
#define to_float2(value) vload2(0, (value).v)
#define to_float4(value) vload4(0, (value).v)
#define to_int2(value) vload2(0, (value).v)
#define to_int4(value) vload4(0, (value).v)

#define float2(x, y) ((float2)(x, y))
#define float3(x, y, z) ((float3)(x, y, z))
#define float4(x, y, z, w) ((float4)(x, y, z, w))
#define int2(x, y) ((int2)(x, y))
#define int4(x, y, z, w) ((int4)(x, y, z, w))
#define uint2(x, y) ((uint2)(x, y))
#define FUNCTION static
/* A function that is always inlined. Functions with local memory among their arguments, or in a
 * struct among them, must be: PoCL may lose what other functions write there
 * (host/compute/opencl/quirks.cpp). Others are faster if they are compiled for the constants that
 * they are called with, which compilers do not see. */
#define INLINED static inline __attribute__((always_inline))
#define LA_TYPEDEF(name) typedef struct name name;
#define float_of(v) ((float)(v))
#define int_of(v) ((int)(v))
#define xy(v) ((v).xy)
#define zw(v) ((v).zw)
#define xyz(v) ((v).xyz)

/* A table among the arguments of a function, and its i-th element. */
#define TABLE_ARGUMENT(type, name) __global const type *name,
#define TABLE_AT(name, i) name[i]

/* Memory of a work-group. In kernels that are launched in groups of one it belongs to one
 * work-item. */
#define LOCAL_TABLE(type, name, count) __local type name[count]

/* The number of the lowest bit that is set; bits is not 0. */
static uint lowest_bit(const uint bits) {
    return 31u - clz(bits & (0u - bits));
}

#define TABLE_IN(type, name) , __global const type* restrict name
#define TABLE_OUT(type, name) , __global type* restrict name
#define KERNEL(name, Parameters)                                                                   \
    __kernel void name(                                                                            \
        const Parameters args name##_tables(TABLE_IN, TABLE_OUT, TABLE_OUT, TABLE_OUT))

/* The columns of a 4x4 matrix. */
typedef struct Matrix {
    float4 x, y, z, w;
} Matrix;

static Matrix to_matrix(const la_mat4 value) {
    const Matrix m = {vload4(0, value.v), vload4(1, value.v), vload4(2, value.v),
                      vload4(3, value.v)};
    return m;
}
#endif

#endif
