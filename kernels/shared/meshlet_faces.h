/* The triangles of a meshlet, LANES at a time, as faces in the world. Included once by each kernel
 * file that looks at faces, after lanes.h. */

typedef struct Vector {
    lanes_float x, y, z;
} Vector;

static Vector difference(const Vector a, const Vector b) {
    const Vector d = {a.x - b.x, a.y - b.y, a.z - b.z};
    return d;
}

static lanes_float dot_of(const Vector a, const Vector b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

static Vector chosen(const Vector a, const Vector b, const lanes_mask second) {
    const Vector v = {SELECT(a.x, b.x, second), SELECT(a.y, b.y, second), SELECT(a.z, b.z, second)};
    return v;
}

/* Normal to the triangle: the cross product of its two shorter edges, which loses least. */
static Vector normal_of(const Vector a, const Vector b, const Vector c) {
    const Vector ab = difference(b, a), bc = difference(c, b), ca = difference(a, c);
    const lanes_float ab2 = dot_of(ab, ab), bc2 = dot_of(bc, bc), ca2 = dot_of(ca, ca);
    const lanes_mask without_ab = (ab2 >= bc2) & (ab2 >= ca2);
    const lanes_mask without_bc = bc2 >= ca2;
    /* The pairs follow each other around the triangle. */
    const Vector u = chosen(chosen(ab, ca, without_bc), bc, without_ab);
    const Vector v = chosen(chosen(bc, ab, without_bc), ca, without_ab);
    const Vector n = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    return n;
}

/* The vertices of a meshlet. */
typedef struct Corners {
    float x[LA_MESHLET_VERTICES + LA_MESHLET_PADDING];
    float y[LA_MESHLET_VERTICES + LA_MESHLET_PADDING];
    float z[LA_MESHLET_VERTICES + LA_MESHLET_PADDING];
} Corners;

static Vector corner_at(const Corners* corners, const lanes_int at) {
    const Vector v = {GATHER_LANES(corners->x, at), GATHER_LANES(corners->y, at),
                      GATHER_LANES(corners->z, at)};
    return v;
}

static void load_corners(Corners* places, __global const uint* list, const uint count,
                         __global const float* vertices) {
    for (uint i = 0; i < count; ++i) {
        const float3 v = vload3(list[i], vertices);
        places->x[i] = v.x;
        places->y[i] = v.y;
        places->z[i] = v.z;
    }
}

/* From each row of a meshlet's corners to the next. */
static uint row_of(const Meshlet meshlet) {
    return (meshlet.triangle_count + LA_MESHLET_PADDING - 1u) & ~(LA_MESHLET_PADDING - 1u);
}
