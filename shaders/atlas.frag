#version 450 core
// atlas, raster form: one fragment is one sample.

#include "probe.glsl"

uniform vec2 atlas_size;

flat in vec3 spine_p, spine_d;
flat in vec3 spine_rest;
flat in vec3 spine_along;
flat in vec4 spine_faces;
flat in uvec2 sample_base;

layout(location = 0) out float alpha;

void main() {
    uvec2 texel = uvec2(gl_FragCoord.xy);
    uint j = texel.y * uint(atlas_size.x) + texel.x - sample_base.x;
    Spine spine = Spine(spine_p, spine_d, spine_rest.x, spine_rest.y, spine_along.xy,
                        spine_along.z, spine_faces.xy, spine_faces.zw, spine_rest.z);
    alpha = visibility(spine, j, sample_base.y);
}
