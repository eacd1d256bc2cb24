// What the style of a pen leaves of a stroke; included by strokes.frag.

const int most_profile_values = 16;

uniform float width_profile[most_profile_values];    // along the stroke, evenly spaced
uniform float opacity_profile[most_profile_values];
uniform ivec2 profile_counts;                        // how many of each are in use
uniform float widest_profile;                        // the largest width factor; half_width has it
uniform float cap_length;                            // of tapered and textured caps, pixels
uniform sampler2D cap_grain;                         // of textured caps: coverage as of a pen
uniform float cap_grain_repeat;                      // pixels along the stroke

flat in vec4 run_corners;
flat in vec4 run_stroke;

const uint run_solid = 0x8000u;

float width_factor(float t) {
    float x = clamp(t, 0.0, 1.0) * float(profile_counts.x - 1);
    int i = min(int(x), max(profile_counts.x - 2, 0));
    return mix(width_profile[i], width_profile[min(i + 1, profile_counts.x - 1)], x - float(i));
}

float opacity_factor(float t) {
    float x = clamp(t, 0.0, 1.0) * float(profile_counts.y - 1);
    int i = min(int(x), max(profile_counts.y - 2, 0));
    return mix(opacity_profile[i], opacity_profile[min(i + 1, profile_counts.y - 1)], x - float(i));
}

// What a join leaves, as a distance from the spine. corner: from the spine to the left corner on the
// bisector, for half-width 1. beyond: pixels beyond the joint along the run.
float joined_distance(vec2 corner, vec2 from_joint, vec2 outwards, float beyond, float width) {
    float distance_px = abs(local.y);
    float stretch = length(corner);                    // 1 / cos of half the turn
    bool bevel = join_kind == join_bevel || (join_kind == join_mitre && stretch > mitre_limit);
    if (bevel) {
        // The edge of a bevel runs between the outer corners of the two quads.
        vec2 outer = corner / stretch;
        if (dot(outer, outwards) < 0.0) outer = -outer;
        return max(distance_px, dot(from_joint, outer) + width * (1.0 - 1.0 / stretch));
    }
    return join_kind == join_round && beyond > 0.0 ? length(vec2(beyond, local.y)) : distance_px;
}

// How far a position on the stroke is from an end of it that has cap `kind`; far if none has.
float to_cap(uint kind, float from_start, float from_end) {
    float nearest = 1e9;
    if (stroke_end(run_indices.z, 0u) >= end_hidden && cap_of(stroke_end(run_indices.z, 0u)) == kind) {
        nearest = min(nearest, from_start);
    }
    if (stroke_end(run_indices.z, 1u) >= end_hidden && cap_of(stroke_end(run_indices.z, 1u)) == kind) {
        nearest = min(nearest, from_end);
    }
    return nearest;
}

float styled_opacity(float arc, float position, float run_length) {
    vec2 along = run_length > 0.0 ? (run_ends.zw - run_ends.xy) / run_length : vec2(1.0, 0.0);
    vec2 left = vec2(-along.y, along.x);
    float stroke_length = run_stroke.y - run_stroke.x;
    float from_start = arc - run_stroke.x, from_end = run_stroke.y - arc;
    float place = stroke_length > 0.0 ? from_start / stroke_length : 0.5;
    float width = half_width * width_factor(place) / widest_profile;
    // A tapered end never meets the other one in less than a point.
    float taper = clamp(to_cap(cap_taper, from_start, from_end) / min(cap_length, 0.5 * stroke_length + 1e-3), 0.0, 1.0);
    width *= taper;

    float distance_px = abs(local.y);
    float covered = 1.0;
    for (uint end = 0u; end < 2u; ++end) {
        uint kind = run_end(run_indices.z, end);
        float beyond = end == 0u ? -local.x : local.x - run_length;
        if (kind == end_join) {
            vec2 from_joint = along * (end == 0u ? local.x : local.x - run_length) + left * local.y;
            vec2 corner = end == 0u ? run_corners.xy : run_corners.zw;
            vec2 outwards = end == 0u ? -along : along;
            distance_px = max(distance_px, joined_distance(corner, from_joint, outwards, beyond, width));
        } else if (kind == end_round || (kind >= end_hidden && cap_of(kind) == cap_round)) {
            if (beyond > 0.0) distance_px = length(vec2(beyond, local.y));
        } else if (kind >= end_hidden) {
            covered = min(covered, clamp(0.5 - beyond, 0.0, 1.0));
        }
    }
    float opacity = covered * stroke_coverage(distance_px, width) * opacity_factor(place);
    opacity *= pen_mark(arc, local.y, width);
    float dry = to_cap(cap_texture, from_start, from_end) / cap_length;
    if (dry < 1.0) {
        float grain = texture(cap_grain, vec2(arc / cap_grain_repeat, local.y * 0.5 / max(width, 0.5) + 0.5)).r;
        opacity *= clamp((grain - 1.0 + dry) * 4.0 + dry, 0.0, 1.0);
    }
    bool solid = (run_indices.z & run_solid) != 0u;
    return opacity * (solid ? 1.0 : stroke_visibility(visibility_at(position)));
}
