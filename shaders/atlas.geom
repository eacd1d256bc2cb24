#version 450 core
// atlas, raster form: a proxy line l texels long at the segment's place in the atlas (§4.2, eq. 2).

#include "probe.glsl"

layout(points) in;
layout(line_strip, max_vertices = 2) out;

uniform vec2 atlas_size;  // texels; w and h
uniform uint capacity;    // samples that the atlas holds
uniform bool second_draw; // true: draws at (-w, +1) what went beyond the end of a row

in VertexSegment {
    vec4 p, q;
    flat uvec2 own_faces;
    flat uvec2 range;
} segment[];

flat out vec4 spine_line;    // p, d
flat out vec4 spine_depths;  // depth, inverse_w
flat out vec4 spine_along;   // along, depth_along, outside
flat out vec4 spine_faces;   // face_a, face_b
flat out ivec4 spine_surfaces; // number_a, number_b, patch_a, patch_b
flat out uvec2 sample_base; // s, l

void main() {
    uint s = segment[0].range.x;
    uint l = segment[0].range.y;
    if (l == 0u || s >= capacity || l > capacity - s) return;
    uint row = uint(atlas_size.x);
    uvec2 place = uvec2(s % row, s / row);
    // From the centre of the first texel to the centre of the one after the last: the diamond-exit rule
    // draws every texel that such a line leaves, which is l of them.
    vec2 start = vec2(place) + 0.5;
    if (second_draw) {
        if (place.x + l <= row) return;
        start += vec2(-atlas_size.x, 1.0);
    }
    vec2 end = start + vec2(float(l), 0.0);

    Spine spine = spine_of(segment[0].p, segment[0].q, segment[0].own_faces);
    for (int i = 0; i < 2; ++i) {
        spine_line = vec4(spine.p, spine.d);
        spine_depths = vec4(spine.depth_p, spine.depth_d, spine.inverse_w_p, spine.inverse_w_d);
        spine_along = vec4(spine.along, spine.depth_along, spine.outside);
        spine_faces = vec4(spine.a.slope, spine.a.height, spine.b.slope, spine.b.height);
        spine_surfaces = ivec4(spine.number_a, spine.number_b, spine.patch_a, spine.patch_b);
        sample_base = uvec2(s, l);
        gl_Position = vec4((i == 0 ? start : end) / atlas_size * 2.0 - 1.0, 0.0, 1.0);
        EmitVertex();
    }
    EndPrimitive();
}
