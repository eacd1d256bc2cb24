/* fill: the colours under the lines, by the triangle that each texel of the depth buffer shows.
 *
 * Two steps. First each triangle of a visible cluster gets its colour. Then each pixel gets the
 * mean of its texels' colours, so that edges are as smooth as the depth buffer is fine.
 *
 * A triangle of a smooth surface gets its colour without light. Each of its texels is lit by the
 * normal there, interpolated between those of the triangle's corners (Phong 1975). smooth_corners:
 * of each triangle three of `normals`, or LA_NO_SURFACE.
 *
 * DEPTH_LANES: triangles at once, 1 on GPUs. */

#define LANES DEPTH_LANES
#include "kernels.h"
#include "shared/lanes.h"
#include "shared/meshlet_faces.h"

/* Light adds up linearly, and colours are coded for the screen: x to the power of 1 / 2.2. As a
 * function of x^(1/4) that is nearly a parabola. The result is exact at 0 and 1, and off by at most
 * 2e-4 between them. */
#define CODED_BEND(t) (((0.188157f * t - 0.397165f) * t + 0.374439f) * t - 0.976627f)
static lanes_float coded(const lanes_float x) {
    const lanes_float one = 1.0f, t = SQUARE_ROOT(SQUARE_ROOT(x));
    const lanes_float bend = CODED_BEND(t);
    return t + t * (one - t) * bend;
}
static float coded_one(const float x) {
    const float t = sqrt(sqrt(x)), bend = CODED_BEND(t);
    return t + t * (1.0f - t) * bend;
}

/* How bright a face is, seen from the eye's side, whichever way its corners go round. */
static lanes_float shade_of(const FillColorsParameters* args, const Vector a, const Vector b,
                            const Vector c) {
    const lanes_float none = 0.0f, one = 1.0f;
    if (args->lit == 0) return one;
    const Vector n = normal_of(a, b, c);
    const Matrix m = to_matrix(args->eye_from_normal);
    const float4 light = to_float4(args->light), eye = to_float4(args->eye);
    const Vector to_eye = {eye.x - a.x * eye.w, eye.y - a.y * eye.w, eye.z - a.z * eye.w};
    const Vector seen = {(n.x * m.x.x + n.y * m.y.x) + n.z * m.z.x,
                         (n.x * m.x.y + n.y * m.y.y) + n.z * m.z.y,
                         (n.x * m.x.z + n.y * m.y.z) + n.z * m.z.z};
    const lanes_float least = 1e-30f;
    const lanes_float along = ((seen.x * light.x + seen.y * light.y) + seen.z * light.z) /
                              fmax(SQUARE_ROOT(dot_of(seen, seen)), least);
    lanes_float lambert = fmax(SELECT(along, -along, dot_of(n, to_eye) < none), none);
    if (args->steps > 0.0f) {
        const lanes_float last = args->steps - 1.0f;
        lambert = fmin(TO_FLOAT(FLOOR_TO_INT(lambert * args->steps)), last) / last;
    }
    return coded(fmin(args->ambient + lambert * (1.0f - args->ambient), one));
}

/* One channel, from a value of 0 to 255. */
static uint rounded(const float value) {
    return (uint)int_of(fmin(fmax(value, 0.0f), 255.0f) + 0.5f);
}

/* One work-item per cluster. colors: one per triangle; alpha 0: none. shaded: the colours in the
 * light, opaque. */
KERNEL(fill_colors, FillColorsParameters) {
    const uint cluster = (uint)get_global_id(0);
    if (cluster >= args.count || seen[cluster] == 0) return;
    const Meshlet meshlet = meshlets[cluster];
    const float4 plain = to_float4(args.plain) * 255.0f;
    Corners places;
    if (args.lit != 0)
        load_corners(&places, vertex_list + meshlet.vertices, meshlet.vertex_count, vertices);
    const uint row = row_of(meshlet), start = clusters[cluster].first;
    for (uint first = 0; first < meshlet.triangle_count; first += LANES) {
        float shades[LANES];
        const lanes_float full = 1.0f;
        STORE_LANES(full, shades);
        if (args.lit != 0) {
            __global const uchar* own = corners + meshlet.corners + first;
            STORE_LANES(shade_of(&args, corner_at(&places, LOAD_BYTES(own)),
                                 corner_at(&places, LOAD_BYTES(own + row)),
                                 corner_at(&places, LOAD_BYTES(own + 2u * row))),
                        shades);
        }
        const uint end = min((uint)LANES, meshlet.triangle_count - first);
        for (uint i = 0; i < end; ++i) {
            const uint number = start + first + i;
            const Color color = args.has_colors != 0 ? colors[number] : 0u;
            const bool is_smooth =
                args.has_smooth != 0 && smooth_corners[3 * number] != LA_NO_SURFACE;
            const float shade = is_smooth ? 1.0f : shades[i];
            const bool own_color = color >> 24 != 0;
            const float red = own_color ? (float)(color & 255u) : plain.x;
            const float green = own_color ? (float)(color >> 8 & 255u) : plain.y;
            const float blue = own_color ? (float)(color >> 16 & 255u) : plain.z;
            shaded[number] = rounded(red * shade) | rounded(green * shade) << 8 |
                             rounded(blue * shade) << 16 | 0xFF000000u;
        }
    }
}

static float dot_of_two(const float3 a, const float3 b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/* A smooth triangle: the x, y and w of its corners in clip space, and their normals, which look to
 * the side that is seen. */
typedef struct SmoothFace {
    float3 at[3];
    float3 normal[3];
} SmoothFace;

static SmoothFace smooth_face(const FillPixelsParameters* args, __global const uint* own,
                              __global const ContourCorner* normals,
                              __global const float* vertices) {
    const Matrix m = to_matrix(args->clip_from_world);
    const float4 eye = to_float4(args->eye);
    SmoothFace face;
    float3 place[3], sum = 0.0f;
    for (int k = 0; k < 3; ++k) {
        __global const ContourCorner* corner = normals + own[k];
        const float3 v = vload3(corner->vertex, vertices);
        face.normal[k] = vload3(0, corner->normal);
        face.at[k] = float3((m.x.x * v.x + m.y.x * v.y) + (m.z.x * v.z + m.w.x),
                            (m.x.y * v.x + m.y.y * v.y) + (m.z.y * v.z + m.w.y),
                            (m.x.w * v.x + m.y.w * v.y) + (m.z.w * v.z + m.w.w));
        place[k] = v;
        sum += face.normal[k];
    }
    const float3 u = place[1] - place[0], w = place[2] - place[0];
    const float3 front =
        float3(u.y * w.z - u.z * w.y, u.z * w.x - u.x * w.z, u.x * w.y - u.y * w.x);
    const float3 to_eye = float3(eye.x, eye.y, eye.z) - place[0] * eye.w;
    const float side = dot_of_two(front, to_eye) * dot_of_two(front, sum) < 0.0f ? -1.0f : 1.0f;
    for (int k = 0; k < 3; ++k) face.normal[k] = face.normal[k] * side;
    return face;
}

/* How bright a smooth triangle is at a texel, or between texels. The shares of its corners are
 * computed relative to that place, so that little is lost if triangles are small. */
static float smooth_shade(const FillPixelsParameters* args, const SmoothFace* face,
                          const float column, const float line) {
    const float x = args->first.v[0] + column * args->step.v[0];
    const float y = args->first.v[1] + line * args->step.v[1];
    float2 at[3];
    for (int k = 0; k < 3; ++k)
        at[k] = float2(face->at[k].x - x * face->at[k].z, face->at[k].y - y * face->at[k].z);
    const float a = at[1].x * at[2].y - at[1].y * at[2].x;
    const float b = at[2].x * at[0].y - at[2].y * at[0].x;
    const float c = at[0].x * at[1].y - at[0].y * at[1].x;
    /* A place at the border may lie beside the triangle. */
    const float sign = (a + b) + c < 0.0f ? -1.0f : 1.0f;
    const float3 n =
        (face->normal[0] * fmax(a * sign, 0.0f) + face->normal[1] * fmax(b * sign, 0.0f)) +
        face->normal[2] * fmax(c * sign, 0.0f);
    const Matrix m = to_matrix(args->eye_from_normal);
    const float3 seen =
        float3((n.x * m.x.x + n.y * m.y.x) + n.z * m.z.x, (n.x * m.x.y + n.y * m.y.y) + n.z * m.z.y,
               (n.x * m.x.z + n.y * m.y.z) + n.z * m.z.z);
    const float4 light = to_float4(args->light);
    const float along = dot_of_two(seen, float3(light.x, light.y, light.z));
    const float length = sqrt(dot_of_two(seen, seen));
    float lambert = length > 0.0f ? fmax(along / length, 0.0f) : 0.0f;
    if (args->steps > 0.0f) {
        const float last = args->steps - 1.0f;
        lambert = fmin((float)convert_int_rtn(lambert * args->steps), last) / last;
    }
    return coded_one(fmin(args->ambient + lambert * (1.0f - args->ambient), 1.0f));
}

static Color in_shade(const Color color, const float shade) {
    return rounded((float)(color & 255u) * shade) |
           rounded((float)(color >> 8 & 255u) * shade) << 8 |
           rounded((float)(color >> 16 & 255u) * shade) << 16 | 0xFF000000u;
}

/* One work-item per block of pixels in a row. pixels: the mean, alpha the share that triangles
 * cover; premultiplied. */
KERNEL(fill_pixels, FillPixelsParameters) {
    const uint i = (uint)get_global_id(0);
    if (args.blocks == 0) return; /* there is no picture */
    const int2 size = to_int2(args.size), low = to_int2(args.low), wanted = to_int2(args.wanted);
    const int2 origin = to_int2(args.origin);
    const int y = (int)(i / args.blocks), scale = args.scale;
    if (y >= wanted.y) return;
    const int from = (int)(i % args.blocks * args.block);
    const int to = min(from + (int)args.block, wanted.x);
    const size_t first_row = (size_t)(origin.y + (low.y + y) * scale) * (size_t)args.row;
    __global const uint* texels = numbers + first_row + (size_t)(origin.x + low.x * scale);
    __global Color* out = pixels + (size_t)(low.y + y) * (size_t)size.x + (size_t)low.x;
    const uint count = (uint)(scale * scale), half_count = count / 2u;
    const uint inverse = (65536u + count - 1u) / count; /* exact for sums below 4096 */
    /* Neighbouring texels mostly show the same triangle. */
    uint last = LA_NO_FACE;
    bool is_smooth = false;
    SmoothFace face;
    Color color = 0, lit = 0;
    /* Light without steps changes so little within a pixel that its value in the middle is
     * enough. */
    const bool by_pixels = args.steps == 0.0f;
    const float to_middle = 0.5f * (float)(scale - 1);
    for (int x = from; x < to; ++x) {
        uint differs = 0;
        for (int v = 0; v < scale; ++v) {
            for (int u = 0; u < scale; ++u) differs |= texels[v * args.row + x * scale + u] ^ last;
        }
        const float column = (float)((low.x + x) * scale), line = (float)((low.y + y) * scale);
        if (is_smooth && by_pixels)
            lit = in_shade(color, smooth_shade(&args, &face, column + to_middle, line + to_middle));
        if (differs == 0 && (by_pixels || !is_smooth)) {
            out[x] = lit;
            continue;
        }
        uint red_blue = 0, green_alpha = 0; /* two sums of 16 bits each */
        for (int v = 0; v < scale; ++v) {
            for (int u = 0; u < scale; ++u) {
                const uint number = texels[v * args.row + x * scale + u];
                const bool is_other = number != last;
                if (is_other) {
                    last = number;
                    color = lit = number == LA_NO_FACE ? 0u : shaded[number];
                    const size_t own = 3 * (size_t)number;
                    is_smooth = args.has_smooth != 0 && number != LA_NO_FACE &&
                                smooth_corners[own] != LA_NO_SURFACE;
                    if (is_smooth)
                        face = smooth_face(&args, smooth_corners + own, normals, vertices);
                }
                if (is_smooth && (is_other || !by_pixels)) {
                    const float aside = by_pixels ? to_middle : (float)u;
                    const float above = by_pixels ? to_middle : (float)v;
                    lit = in_shade(color, smooth_shade(&args, &face, column + aside, line + above));
                }
                red_blue += lit & 0x00FF00FFu;
                green_alpha += lit >> 8 & 0x00FF00FFu;
            }
        }
        const uint red = ((red_blue & 0xFFFFu) + half_count) * inverse >> 16;
        const uint blue = ((red_blue >> 16) + half_count) * inverse >> 16;
        const uint green = ((green_alpha & 0xFFFFu) + half_count) * inverse >> 16;
        const uint alpha = ((green_alpha >> 16) + half_count) * inverse >> 16;
        out[x] = red | green << 8 | blue << 16 | alpha << 24;
    }
}
