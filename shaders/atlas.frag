#version 450 core
// atlas, raster form: one fragment is one sample.

#include "probe.glsl"

uniform vec2 atlas_size;

flat in vec4 spine_line;
flat in vec4 spine_depths;
flat in vec4 spine_along;
flat in vec4 spine_faces;
flat in ivec4 spine_surfaces;
flat in uvec2 sample_base;

layout(location = 0) out float alpha;

void main() {
    uvec2 texel = uvec2(gl_FragCoord.xy);
    uint j = texel.y * uint(atlas_size.x) + texel.x - sample_base.x;
    Spine spine = unpacked(spine_line, spine_depths, spine_along, spine_faces,
                           spine_surfaces);
    alpha = visibility(spine, float(j), 1.0 / float(sample_base.y));
}
