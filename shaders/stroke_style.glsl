// Uniforms and functions that the features of a style need in the fragments of a stroke. strokes.frag
// includes this file and lists the features.

#if defined(WIDTH_PROFILE) || defined(OPACITY_PROFILE)
const int most_profile_values = 16;

uniform float width_profile[most_profile_values]; // along the stroke, evenly spaced
uniform float opacity_profile[most_profile_values];
uniform uvec2 profile_counts;                     // values in use of either profile

float profile_at(float profile[most_profile_values], uint count, float share) {
    float x = clamp(share, 0.0, 1.0) * float(count - 1u);
    uint i = min(uint(x), count - 1u);
    return mix(profile[i], profile[min(i + 1u, count - 1u)], x - float(i));
}
#endif

#ifdef DENSITY
uniform samplerBuffer weights;  // of `density`: planes of cells by priority
uniform vec2 cells;             // per axis
uniform float cell_size;        // pixels

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

// How much of the line is drawn at a place in the window. The line's priority lies between two bins.
float density_weight(vec2 place) {
    uint bin = run_priority >> 4u;
    float share = float(run_priority & 15u) / 16.0;
    float weight = bin_weight(place, bin);
    return share > 0.0 ? mix(weight, bin_weight(place, bin + 1u), share) : weight;
}
#endif

#ifdef FOCUS
uniform vec2 focus_range; // radius and falloff, pixels or in the scene
uniform float far_width, far_opacity;

// 0 in the focus, 1 far from it.
float focus_distance(float along) {
    vec4 point = focus_start + focus_way * along;
    float range = length(point.xyz / point.w) - focus_range.x;
    return smoothstep(0.0, max(focus_range.y, 1e-6), range);
}
#endif

#ifdef FAR_TEXTURE
uniform sampler2D far_pen;
uniform float far_pen_repeat;
#endif

#ifdef DRY_CAPS
uniform float cap_length;
uniform sampler2D cap_grain;    // coverage, as in `pen`
uniform float cap_grain_repeat; // pixels along the stroke

// The share of the mark that is left at `from_end` pixels from a textured end.
float dry_mark(float from_end, float arc, float width) {
    float dry = from_end / cap_length;
    float grain = mark_of(cap_grain, cap_grain_repeat, arc, local.y, width);
    return dry < 1.0 ? clamp((grain - 1.0 + dry) * 4.0 + dry, 0.0, 1.0) : 1.0;
}
#endif

// Pixels from the nearer of two arc lengths inwards.
float from_nearer(vec2 ends, float arc) { return min(arc - ends.x, ends.y - arc); }
