// The GLSL side of kernels/shared/language.h: what shaders need to read headers that they share with kernels.

#define FUNCTION
#define LA_TYPEDEF(name)
#define float2 vec2
#define float3 vec3
#define float4 vec4
#define int2 ivec2
#define uint2 uvec2
#define xy(v) ((v).xy)
#define zw(v) ((v).zw)
#define xyz(v) ((v).xyz)
#define as_float(v) uintBitsToFloat(v)
#define as_uint(v) floatBitsToUint(v)
#define float_of(v) float(v)
#define int_of(v) int(v)
#define fabs(v) abs(v)

// A table is a uniform, so it is no argument.
#define TABLE_ARGUMENT(type, name)
#define TABLE_AT(name, i) texelFetch(name, i).r

// These return what OpenCL's do if an argument is not a number. GLSL's own min and max leave that open.
float fmin(float a, float b) { return b < a || a != a ? b : a; }
float fmax(float a, float b) { return a < b || a != a ? b : a; }
vec2 fmin(vec2 a, vec2 b) { return vec2(fmin(a.x, b.x), fmin(a.y, b.y)); }
vec2 fmax(vec2 a, vec2 b) { return vec2(fmax(a.x, b.x), fmax(a.y, b.y)); }
ivec2 convert_int2(vec2 v) { return ivec2(v); }

// One lane (kernels/shared/lanes.h).
#define lanes_float float
#define lanes_int int
#define lanes_mask bool
#define TO_FLOAT(v) float(v)
#define FLOOR_TO_INT(v) int(floor(v))
#define ANY(mask) (mask)

// The columns of a 4x4 matrix.
struct Matrix {
    vec4 x, y, z, w;
};
Matrix to_matrix(mat4 m) { return Matrix(m[0], m[1], m[2], m[3]); }
