#version 450 core
// spine, sampled: what the spine test finds at the centre of every sample, in the layout of the atlas.
// bench/quality measures the spine test by it. Drawing needs no samples.

#include "probe.glsl"

uniform vec2 atlas_size;
uniform float probe_step; // as in spine.frag

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
    float length_px = length(spine.d) / depth_scale;
    float at = (float(j) + 0.5) / float(sample_base.y) * length_px;
    // A segment without length gets no stroke (spine.glsl).
    alpha = length_px > 0.0 ? visibility_around(spine, at, length_px, probe_step) : 0.0;
}
