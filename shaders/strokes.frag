#version 450 core
// strokes: the pen's mark times the visibility along the run (§4.4).

#include "strokes.glsl"
#include "mark.glsl"

uniform samplerBuffer alpha;     // the segment atlas

noperspective in vec2 local;
flat in vec4 run_ends;
flat in vec4 run_cuts;
flat in vec4 run_params;
flat in uvec4 run_indices;
flat in vec4 run_stroke;

layout(location = 0) out vec4 picture;

const uint run_solid = 0x8000u;

// Visibility at a position counted in samples of the segment, linear between sample centres.
float visibility_at(float position) {
    if ((run_indices.z & run_solid) != 0u) return 1.0;
    float last = float(run_indices.y) - 1.0;
    float x = clamp(position - 0.5, 0.0, last);
    float before = floor(x);
    int address = int(run_indices.x) + int(before);
    float a = texelFetch(alpha, address).r;
    float b = texelFetch(alpha, address + int(before < last)).r;
    return mix(a, b, x - before);
}

// Whether the fragment lies on the run's side of the bisector at a join. Both runs decide alike, so
// that each fragment is drawn by one of them; a tie is the later run's.
bool before_cut(vec2 joint, vec2 normal) { return dot(gl_FragCoord.xy - joint, normal) <= 0.0; }
bool after_cut(vec2 joint, vec2 normal) { return dot(gl_FragCoord.xy - joint, -normal) > 0.0; }

// The edge of a bevel as a distance from the spine: it cuts the corner between the outer edges.
float bevel_distance(vec2 joint, vec2 normal, vec2 along, float width) {
    vec2 outer = vec2(-normal.y, normal.x);
    if (dot(outer, along) * dot(normal, along) < 0.0) outer = -outer;
    return dot(gl_FragCoord.xy - joint, outer) + width * (1.0 - abs(dot(normal, along)));
}

// What an end of the run leaves of a fragment `beyond` pixels behind it: changes its distance from
// the spine, or the share of it that is covered.
void apply_end(uint end, float beyond, vec2 joint, vec2 normal, vec2 along, float width,
               inout float distance_px, inout float covered) {
    uint kind = run_end(run_indices.z, end);
    if (kind == end_join) {
        uint join = join_of(abs(dot(normal, along)));
        if (join == join_round && beyond > 0.0) distance_px = length(vec2(beyond, local.y));
        if (join == join_bevel) distance_px = max(distance_px, bevel_distance(joint, normal, along, width));
    } else if (kind == end_round || (kind >= end_hidden && cap_of(kind) == cap_round)) {
        if (beyond > 0.0) distance_px = length(vec2(beyond, local.y));
    } else if (kind >= end_hidden) {
        covered = min(covered, clamp(0.5 - beyond, 0.0, 1.0));
    }
}

void main() {
    vec2 way = run_ends.zw - run_ends.xy;
    float run_length = length(way);
    vec2 along = run_length > 0.0 ? way / run_length : vec2(1.0, 0.0);
    if (run_end(run_indices.z, 0u) == end_join && !after_cut(run_ends.xy, run_cuts.xy)) discard;
    if (run_end(run_indices.z, 1u) == end_join && !before_cut(run_ends.zw, run_cuts.zw)) discard;

    float t = run_length > 0.0 ? local.x / run_length : 0.5;
    float arc = mix(run_params.x, run_params.y, t);
    float width = half_width;
    float distance_px = abs(local.y);
    float covered = 1.0;
    apply_end(0u, -local.x, run_ends.xy, run_cuts.xy, along, width, distance_px, covered);
    apply_end(1u, local.x - run_length, run_ends.zw, run_cuts.zw, along, width, distance_px, covered);

    float opacity = covered * stroke_coverage(distance_px, width) * color.a;
    float position = mix(run_params.z, run_params.w, clamp(t, 0.0, 1.0));
    opacity *= stroke_visibility(visibility_at(position));
    opacity *= pen_mark(arc, local.y, width);
    if (opacity <= 0.0) discard;
    picture = vec4(color.rgb * opacity, opacity);
}
