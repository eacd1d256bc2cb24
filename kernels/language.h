/* What kernels are written in: OpenCL C 1.2 as far as C++20 can be made to read it too. This is the
 * OpenCL side; host/compute/cpp/opencl_c.hpp says the same things in C++. What differs from plain
 * OpenCL C: vectors are made by `float2(x, y)`, parts of them taken by `xy(v)`, and a kernel is
 * written KERNEL(name, Parameters) { ... }, with its tables listed in kernels.h. */
#ifndef LINEATLAS_LANGUAGE_H
#define LINEATLAS_LANGUAGE_H

#ifdef __OPENCL_VERSION__
#pragma OPENCL FP_CONTRACT OFF

typedef uint la_uint;
typedef int la_int;
typedef long la_long; /* of 64 bits, which C++'s need not be */

/* Vectors in parameters: 4-byte members only, which every compiler lays out alike. They are read
 * whole: rusticl 22.3 cannot index a parameter by what is not constant. */
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
/* Inlined always: what is given local memory, in a struct too, since PoCL may lose what other
 * functions write there (host/compute/opencl/quirks.cpp); and what pays where it is compiled for
 * the constants that it is called with, which compilers don't see. */
#define INLINED static inline __attribute__((always_inline))
#define LA_TYPEDEF(name) typedef struct name name;
#define float_of(v) ((float)(v))
#define int_of(v) ((int)(v))
#define xy(v) ((v).xy)
#define zw(v) ((v).zw)
#define xyz(v) ((v).xyz)

/* A table among the arguments of a function, and what stands in it. */
#define TABLE_ARGUMENT(type, name) __global const type *name,
#define TABLE_AT(name, i) name[i]

/* Memory of a work-group: of a single work-item, in kernels launched in groups of one. */
#define LOCAL_TABLE(type, name, count) __local type name[count]

/* The lowest bit that is set, of any. */
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
