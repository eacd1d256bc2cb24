#version 450 core
// spine: the pen's mark times the visibility at the nearest point of the stroke's spine (§3.2).

#include "probe.glsl"
#include "mark.glsl"

uniform float half_width;
uniform float probe_step;    // length of the box of probes along the line, pixels

noperspective in vec2 local;
flat in vec4 stroke_p, stroke_q;
flat in vec2 stroke_clipped;
flat in uvec2 own_faces;

layout(location = 0) out vec4 picture;

void main() {
    Spine spine = spine_of(stroke_p, stroke_q, own_faces);
    float length_px = length(spine.d) / depth_scale;
    float nearest = clamp(local.x, 0.0, length_px);
    float distance_px = length(vec2(local.x - nearest, local.y));
    float coverage = stroke_coverage(distance_px, half_width);
    if (coverage <= 0.0) discard;
    // Texture coordinates are uniform on the screen, with zero in the middle of the stroke (§3.1).
    coverage *= pen_mark(local.x - 0.5 * length_px, local.y, half_width);
    float alpha = visibility_around(spine, nearest, length_px, probe_step);
    float opacity = coverage * stroke_visibility(alpha) * color.a;
    if (opacity <= 0.0) discard;
    picture = vec4(color.rgb * opacity, opacity);
}
