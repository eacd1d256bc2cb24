#version 450 core
// strokes: the pen's mark times the visibility along the run (§4.4).

#include "strokes.glsl"
#include "mark.glsl"

uniform samplerBuffer alpha;     // the segment atlas

noperspective in vec2 local;
flat in vec4 run_ends;
flat in vec4 run_params;
flat in uvec4 run_indices;

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

void main() {
    float run_length = distance(run_ends.xy, run_ends.zw);
    Run run = Run(run_ends, vec4(0.0), run_params, run_indices);
    // Beyond a round end the distance is to the end point, elsewhere to the spine.
    float beyond = 0.0;
    if (end_style(run, 0u) == end_round) beyond = max(beyond, -local.x);
    if (end_style(run, 1u) == end_round) beyond = max(beyond, local.x - run_length);
    float distance_px = length(vec2(beyond, local.y));
    float coverage = stroke_coverage(distance_px, half_width);

    float t = run_length > 0.0 ? local.x / run_length : 0.5;
    float position = mix(run_params.z, run_params.w, clamp(t, 0.0, 1.0));
    coverage *= stroke_visibility(visibility_at(position));
    coverage *= pen_mark(mix(run_params.x, run_params.y, t), local.y, half_width);
    float opacity = coverage * color.a;
    if (opacity <= 0.0) discard;
    picture = vec4(color.rgb * opacity, opacity);
}
