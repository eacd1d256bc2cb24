#version 450 core
// strokes: the pen's mark times the visibility along the run (§4.4). Each style gets a shader with just
// the features that it needs:
//
// EXACT_ENDS                      ends are cut, with caps; else visibility fades out by itself BEVELS
// joins have bevels; round ones and mitres need nothing of their own TAPERS, DRY_CAPS                caps
// that are tapered, or textured WIDTH_PROFILE, OPACITY_PROFILE  both change along the stroke DENSITY,
// FOCUS                  see stroke_style.glsl FAR_TEXTURE, FAR_SOLID          the mark is another one far
// from the focus HIDDEN                          draws what is not visible PENS
// draws runs of one pen of several (strokes.glsl) PEN_TEXTURE                     see mark.glsl

#define VARYING in
#include "stroke_varyings.glsl"
#include "mark.glsl"
#include "stroke_style.glsl"

uniform float pen_half_width; // before any factor, pixels
uniform samplerBuffer alpha;  // the segment atlas

layout(location = 0) out vec4 picture;

// How much is drawn at `along` pixels from the run's start: linear between sample centres.
float visibility_at(float along) {
    float last = float(run_samples.y);
    float position = uintBitsToFloat(run_samples.z) + along * uintBitsToFloat(run_samples.w);
    float x = clamp(position - 0.5, 0.0, last);
    float before = floor(x);
    int address = int(run_samples.x) + int(before);
    float a = texelFetch(alpha, address).r;
    float b = texelFetch(alpha, address + int(before < last)).r;
    float visible = stroke_visibility(mix(a, b, x - before));
#ifdef HIDDEN
    visible = 1.0 - visible;
#endif
    return visible;
}

void main() {
    float arc = run_line.z + run_line.w * local.x;
    float width = pen_half_width;
    float opacity = color.a;
    float along = local.x;
#if defined(EXACT_ENDS) || defined(FOCUS) || defined(DENSITY)
    along = clamp(along, 0.0, run_cuts.z);
#endif
#ifdef WIDTH_PROFILE
    width *= profile_at(width_profile, profile_counts.x, stroke_share.x + stroke_share.y * local.x);
#endif
#ifdef OPACITY_PROFILE
    opacity *= profile_at(opacity_profile, profile_counts.y, stroke_share.x + stroke_share.y * local.x);
#endif
#ifdef FOCUS
    float away = focus_distance(along);
    width *= mix(1.0, far_width, away);
    opacity *= mix(1.0, far_opacity, away);
#endif
#ifdef DENSITY
    opacity *= density_weight(run_window.xy + run_window.zw * along);
#endif
#ifdef TAPERS
    width *= clamp(from_nearer(stroke_taper.xy, arc) * stroke_taper.z, 0.0, 1.0);
#endif

    float beyond = max(0.0, max(run_line.x - local.x, local.x - run_line.y));
    float distance_px = length(vec2(beyond, local.y));
#ifdef BEVELS
    vec2 from_end = vec2(local.x - run_cuts.z, local.y);
    distance_px = max(distance_px, dot(local, start_bevel.xy) + width * start_bevel.z);
    distance_px = max(distance_px, dot(from_end, end_bevel.xy) + width * end_bevel.z);
#endif
    opacity *= stroke_coverage(distance_px, width);
#ifdef EXACT_ENDS
    opacity *= clamp(0.5 - max(run_cuts.x - local.x, local.x - run_cuts.y), 0.0, 1.0);
    opacity *= max(visibility_at(along), run_cuts.w);
#else
    opacity *= visibility_at(along);
#endif

    float mark = pen_mark(arc, local.y, width);
#ifdef FAR_TEXTURE
    mark = mix(mark, mark_of(far_pen, far_pen_repeat, arc, local.y, width), away);
#elif defined(FAR_SOLID)
    mark = mix(mark, 1.0, away);
#endif
    opacity *= mark;
#ifdef DRY_CAPS
    opacity *= dry_mark(from_nearer(stroke_dry, arc), arc, width);
#endif
    if (opacity <= 0.0) discard;
    picture = vec4(color.rgb * opacity, opacity);
}
