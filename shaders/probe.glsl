// Visibility of one sample of a segment by probes of the depth texture (§3.2, §4.3): kernels/shared/spine.h.

uniform sampler2D depth;
uniform vec2 viewport;         // pixels
uniform float depth_scale;     // depth texels per pixel
uniform uint probes_per_axis;  // the probes fill a box of 1 pixel across by 1 sample along the line
uniform float tolerance;       // window depth that may stand before a line, times w
uniform bool knows_surfaces;   // numbers, planes and patches are those of the triangles in `depth`
uniform bool parallel_view;
uniform float bend;            // nearness by which a line's own patch may stand before it, times w
uniform usampler2D numbers;    // of the triangle that each texel shows
uniform samplerBuffer planes;  // of each triangle (kernels/planes.cl)
uniform usamplerBuffer patches;

#include "shared/constants.h"
#include "kernel_language.glsl"

// The size of the depth texture, or of the numbers if they are read in its place.
struct Depth {
    ivec2 size;
    float scale, tolerance;
    bool knows_surfaces, parallel;
    float bend;
    vec2 screen_scale, screen_origin;
};
float depth_at(Depth depths, int column, int row) {
    return texelFetch(depth, ivec2(column, row), 0).r;
}

int number_at(Depth depths, int column, int row) {
    return int(texelFetch(numbers, ivec2(column, row), 0).r);
}
float plane_at(Depth depths, int number, int part) { return texelFetch(planes, number)[part]; }
int patch_at(Depth depths, int number) { return int(texelFetch(patches, number).r); }

#include "shared/spine.h"

int own_patch(int number) {
    return number != int(LA_NO_NUMBER) ? int(texelFetch(patches, number).r) : LA_NO_PATCH;
}

Spine spine_of(vec4 p, vec4 q, uvec2 own_faces) {
    Spine spine =
        make_spine(p, q, own_faces.x, own_faces.y, knows_surfaces, viewport, depth_scale);
    if (knows_surfaces) {
        spine.patch_a = own_patch(spine.number_a);
        spine.patch_b = own_patch(spine.number_b);
    }
    return spine;
}

// The spine that atlas.geom has packed into varyings.
Spine unpacked(vec4 line, vec4 depths, vec4 along, vec4 faces, ivec4 surfaces) {
    return Spine(line.xy, line.zw, depths.x, depths.y, depths.z, depths.w, along.xy, along.z,
                 OwnFace(faces.x, faces.y), OwnFace(faces.z, faces.w), along.w, surfaces.x,
                 surfaces.y, surfaces.z, surfaces.w);
}

// Visibility of sample j, given 1 / l, in steps of one probe.
float visibility(Spine spine, float j, float inverse_l) {
    ivec2 size = knows_surfaces ? textureSize(numbers, 0) : textureSize(depth, 0);
    Depth seen = Depth(size, depth_scale, tolerance, knows_surfaces, parallel_view,
                       bend, 2.0 / (viewport * depth_scale), vec2(-1.0));
    int per_axis = int(probes_per_axis);
    float shift = lone_probe_shift(spine, per_axis, depth_scale);
    float visible = 0.0;
    for (int row = 0; row < per_axis; ++row) {
        for (int column = 0; column < per_axis; ++column) {
            float side = probe_side(column, row, per_axis) + shift;
            float u = (j + probe_ahead(column, row, per_axis)) * inverse_l;
            visible += sees_line(spine, u, side, true, seen) ? 1.0 : 0.0;
        }
    }
    return visible / float(per_axis * per_axis);
}

// Visibility at the point `at` pixels along a segment of `length_px` pixels, by probes in a box `step`
// pixels long. The box is centred on the point, but stays within the segment (spine test, §3.2).
float visibility_around(Spine spine, float at, float length_px, float step) {
    float cell = min(step, length_px);
    float first = clamp(at - 0.5 * cell, 0.0, length_px - cell);
    return visibility(spine, first / cell, cell / length_px);
}
