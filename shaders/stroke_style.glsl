// What the style of a pen leaves of a stroke; included by strokes.frag.

const int most_profile_values = 16;

uniform float width_profile[most_profile_values];    // along the stroke, evenly spaced
uniform float opacity_profile[most_profile_values];
uniform uvec2 profile_counts;                        // how many of each are in use
uniform float pen_half_width;                        // before any factor, pixels
uniform float cap_length;                            // of tapered and textured caps, pixels
uniform sampler2D cap_grain;                         // of textured caps: coverage as of a pen
uniform float cap_grain_repeat;                      // pixels along the stroke

const uint run_solid = 0x8000u;

float profile_at(float profile[most_profile_values], uint count, float t) {
    float x = clamp(t, 0.0, 1.0) * float(count - 1u);
    uint i = min(uint(x), count - 1u);
    return mix(profile[i], profile[min(i + 1u, count - 1u)], x - float(i));
}

#ifdef DENSITY
uniform samplerBuffer weights;  // of `density`: planes of cells by priority
uniform vec2 cells;             // per axis

const float cell_size = 8.0;    // pixels

float cell_weight(ivec2 cell, uint bin) {
    cell = clamp(cell, ivec2(0), ivec2(cells) - 1);
    return texelFetch(weights, (int(bin) * int(cells.y) + cell.y) * int(cells.x) + cell.x).r;
}

float bin_weight(vec2 place, uint bin) {
    vec2 x = place / cell_size - 0.5;
    ivec2 cell = ivec2(floor(x));
    vec2 f = x - vec2(cell);
    return mix(mix(cell_weight(cell, bin), cell_weight(cell + ivec2(1, 0), bin), f.x),
               mix(cell_weight(cell + ivec2(0, 1), bin), cell_weight(cell + ivec2(1, 1), bin), f.x), f.y);
}

// How much of the line is drawn at a place in the window. Its priority lies between two bins.
float density_weight(vec2 place) {
    uint priority = run_indices.z >> 16u & 255u;
    uint bin = priority >> 4u;
    float share = float(priority & 15u) / 16.0;
    float weight = bin_weight(place, bin);
    return share > 0.0 ? mix(weight, bin_weight(place, bin + 1u), share) : weight;
}
#endif

#ifdef FOCUS
uniform bool focus_in_scene;
uniform vec4 focus_point;       // pixels, or in the scene
uniform vec2 focus_range;       // radius and falloff, in the same units
uniform float far_width, far_opacity;
uniform sampler2D far_pen;
uniform float far_pen_repeat;
uniform mat4 world_from_clip;

// 0 in the focus, 1 far from it.
float focus_distance(vec2 place, float depth) {
    vec3 point = vec3(place, 0.0);
    if (focus_in_scene) {
        vec4 world = world_from_clip * vec4(vec3(place / viewport, depth) * 2.0 - 1.0, 1.0);
        point = world.xyz / world.w;
    }
    float range = distance(point, focus_point.xyz) - focus_range.x;
    return smoothstep(0.0, max(focus_range.y, 1e-6), range);
}
#endif

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
    float width = pen_half_width * profile_at(width_profile, profile_counts.x, place);
    vec2 spine = run_ends.xy + along * clamp(local.x, 0.0, run_length);
    float factor = 1.0;
#ifdef FOCUS
    float shares = run_length > 0.0 ? clamp(local.x / run_length, 0.0, 1.0) : 0.5;
    float away = focus_distance(spine, mix(run_stroke.z, run_stroke.w, shares));
    width *= mix(1.0, far_width, away);
    factor *= mix(1.0, far_opacity, away);
#endif
#ifdef DENSITY
    factor *= density_weight(spine);
#endif
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
    float opacity = covered * stroke_coverage(distance_px, width) * factor *
                    profile_at(opacity_profile, profile_counts.y, place);
    float mark = pen_mark(arc, local.y, width);
#ifdef FOCUS
    mark = mix(mark, mark_of(far_pen, far_pen_repeat, arc, local.y, width), away);
#endif
    opacity *= mark;
    float dry = to_cap(cap_texture, from_start, from_end) / cap_length;
    if (dry < 1.0) {
        float grain = texture(cap_grain, vec2(arc / cap_grain_repeat, local.y * 0.5 / max(width, 0.5) + 0.5)).r;
        opacity *= clamp((grain - 1.0 + dry) * 4.0 + dry, 0.0, 1.0);
    }
    if ((run_indices.z & run_solid) != 0u) return opacity;
#ifdef HIDDEN
    return opacity * (1.0 - stroke_visibility(visibility_at(position)));
#else
    return opacity * stroke_visibility(visibility_at(position));
#endif
}
