#version 450 core
// strokes: the pen's mark times the visibility along the run (§4.4).
//
// STYLED: with joins, caps and profiles of a style; without it joins are mitred, paths end round and
// visible runs fade out. HIDDEN: draws what is not visible. FOCUS, DENSITY: see stroke_style.glsl.

#include "strokes.glsl"
#include "mark.glsl"

uniform samplerBuffer alpha;     // the segment atlas

noperspective in vec2 local;
flat in vec4 run_ends;
flat in vec4 run_params;
flat in uvec4 run_indices;
flat in vec4 run_corners;
flat in vec4 run_stroke;

layout(location = 0) out vec4 picture;

// Visibility at a position counted in samples of the segment, linear between sample centres.
float visibility_at(float position) {
    float last = float(run_indices.y) - 1.0;
    float x = clamp(position - 0.5, 0.0, last);
    float before = floor(x);
    int address = int(run_indices.x) + int(before);
    float a = texelFetch(alpha, address).r;
    float b = texelFetch(alpha, address + int(before < last)).r;
    return mix(a, b, x - before);
}

#ifdef STYLED
#include "stroke_style.glsl"
#endif

void main() {
    float run_length = distance(run_ends.xy, run_ends.zw);
    float t = run_length > 0.0 ? local.x / run_length : 0.5;
    float arc = mix(run_params.x, run_params.y, t);
    float position = mix(run_params.z, run_params.w, clamp(t, 0.0, 1.0));
#ifdef STYLED
    float opacity = styled_opacity(arc, position, run_length);
#else
    float beyond = 0.0;
    uint start = run_end(run_indices.z, 0u), end = run_end(run_indices.z, 1u);
    if (start == end_round || start == end_path) beyond = max(beyond, -local.x);
    if (end == end_round || end == end_path) beyond = max(beyond, local.x - run_length);
    float distance_px = length(vec2(beyond, local.y));
    float opacity = stroke_coverage(distance_px, half_width) *
                    stroke_visibility(visibility_at(position)) * pen_mark(arc, local.y, half_width);
#endif
    opacity *= color.a;
    if (opacity <= 0.0) discard;
    picture = vec4(color.rgb * opacity, opacity);
}
