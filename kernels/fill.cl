/* fill: the colours under the lines, by the triangle that each texel of the depth buffer shows.
 *
 * Two steps. First each triangle of a visible cluster gets its colour. Then each pixel gets the
 * mean of its texels' colours, so that edges are as smooth as the depth buffer is fine.
 *
 * DEPTH_LANES: triangles at once, 1 on GPUs. */

#define LANES DEPTH_LANES
#include "kernels.h"
#include "lanes.h"
#include "meshlet_faces.h"

/* Light adds up linearly, but colours are coded for the screen: x to the power of 1 / 2.2. The
 * result is exact at 0 and 1 and off by at most 2e-4 between them. It is a parabola of x^(1/4),
 * which the power nearly is. */
static lanes_float coded(const lanes_float x) {
    const lanes_float one = 1.0f, t = SQUARE_ROOT(SQUARE_ROOT(x));
    const lanes_float bend = ((0.188157f * t - 0.397165f) * t + 0.374439f) * t - 0.976627f;
    return t + t * (one - t) * bend;
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
            const Color color = args.has_colors != 0 ? colors[start + first + i] : 0u;
            const bool own_color = color >> 24 != 0;
            const float red = own_color ? (float)(color & 255u) : plain.x;
            const float green = own_color ? (float)(color >> 8 & 255u) : plain.y;
            const float blue = own_color ? (float)(color >> 16 & 255u) : plain.z;
            shaded[start + first + i] = rounded(red * shades[i]) | rounded(green * shades[i]) << 8 |
                                        rounded(blue * shades[i]) << 16 | 0xFF000000u;
        }
    }
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
    Color color = 0;
    for (int x = from; x < to; ++x) {
        uint differs = 0;
        for (int v = 0; v < scale; ++v) {
            for (int u = 0; u < scale; ++u) differs |= texels[v * args.row + x * scale + u] ^ last;
        }
        if (differs == 0) {
            out[x] = color;
            continue;
        }
        uint red_blue = 0, green_alpha = 0; /* two sums of 16 bits each */
        for (int v = 0; v < scale; ++v) {
            for (int u = 0; u < scale; ++u) {
                const uint number = texels[v * args.row + x * scale + u];
                if (number != last) {
                    last = number;
                    color = number == LA_NO_FACE ? 0u : shaded[number];
                }
                red_blue += color & 0x00FF00FFu;
                green_alpha += color >> 8 & 0x00FF00FFu;
            }
        }
        const uint red = ((red_blue & 0xFFFFu) + half_count) * inverse >> 16;
        const uint blue = ((red_blue >> 16) + half_count) * inverse >> 16;
        const uint green = ((green_alpha & 0xFFFFu) + half_count) * inverse >> 16;
        const uint alpha = ((green_alpha >> 16) + half_count) * inverse >> 16;
        out[x] = red | green << 8 | blue << 16 | alpha << 24;
    }
}
