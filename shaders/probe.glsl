// Visibility of one sample of a segment by probes of the depth texture (§3.2, §4.3). The same test as
// in kernels/atlas.cl, in the same order of operations.

uniform sampler2D depth;
uniform vec2 viewport;         // pixels
uniform float depth_scale;     // depth texels per pixel
uniform uint probes_per_axis;  // the probes fill a box of 1 pixel across by 1 sample along the line
uniform float tolerance;       // window depth that may stand before a line, times w

// As in kernels/segment_table.h.
const float own_face_snap = 0.00390625;
const float own_face_reach = 2.0;
const float fold_clearance = 0.75;
const float depth_rounding = 2.4e-7;

// A segment on the screen. Texels are those of the depth texture; a face is its depth slope across the
// line and its height above it, to the left.
struct Spine {
    vec2 p, d;              // p' in texels, and the way to q'
    vec2 depth;             // window depth of p', and the way to q'
    vec2 inverse_w;         // 1/w of p', and the way to q'
    vec2 along;             // unit vector along the segment
    float depth_along;      // window depth per pixel along it
    vec2 face_a, face_b;
    float outside;          // of a fold: 1 left, -1 right; else 0
};

vec2 unpack_own_face(uint packed_face) {
    return vec2(uintBitsToFloat(packed_face << 16), uintBitsToFloat(packed_face & 0xFFFF0000u));
}

Spine make_spine(vec4 p, vec4 q, uvec2 own_faces) {
    vec3 scale = vec3(viewport * 0.5, 0.5);
    vec3 window_p = (p.xyz / p.w + 1.0) * scale;
    vec3 window_q = (q.xyz / q.w + 1.0) * scale;
    vec3 d = window_q - window_p;
    float length_px = sqrt(d.x * d.x + d.y * d.y);
    bool has_length = length_px > 0.0;
    Spine spine;
    spine.p = window_p.xy * depth_scale;
    spine.d = d.xy * depth_scale;
    spine.depth = vec2(window_p.z, d.z);
    spine.inverse_w = vec2(1.0 / p.w, 1.0 / q.w - 1.0 / p.w);
    spine.along = has_length ? d.xy / length_px : vec2(1.0, 0.0);
    spine.depth_along = has_length ? d.z / length_px : 0.0;
    spine.face_a = unpack_own_face(own_faces.x);
    spine.face_b = unpack_own_face(own_faces.y);
    bool both_left = spine.face_a.y > 0.0 && spine.face_b.y > 0.0;
    bool both_right = spine.face_a.y < 0.0 && spine.face_b.y < 0.0;
    spine.outside = both_left ? -1.0 : both_right ? 1.0 : 0.0;
    return spine;
}

// Whether what a probe sees is the line's own face.
bool is_own_face(vec2 face, float seen, float across, float before) {
    float side = face.y > 0.0 ? 1.0 : -1.0;
    float snap = abs(face.x) * own_face_snap + depth_rounding;
    float expected = face.x * across;
    bool on_side = across * side > -own_face_snap;
    bool in_reach = abs(across) <= abs(face.y) + own_face_snap ||
                    abs(expected) <= own_face_reach * before;
    return on_side && in_reach && abs(seen - expected) <= min(snap, before);
}

// Visibility of sample j, given 1 / l, in steps of one probe.
float visibility(Spine spine, float j, float inverse_l) {
    float visible = 0.0;
    float inverse_axis = 1.0 / float(probes_per_axis);
    float inverse_scale = 1.0 / depth_scale;
    ivec2 last_texel = textureSize(depth, 0) - 1;
    vec2 left = vec2(-spine.along.y, spine.along.x);
    float shift = probes_per_axis == 1u ? spine.outside * fold_clearance * inverse_scale : 0.0;
    float middle = 0.5 * float(probes_per_axis - 1u);
    float inverse_probes = inverse_axis * inverse_axis;
    for (uint row = 0u; row < probes_per_axis; ++row) {
        for (uint column = 0u; column < probes_per_axis; ++column) {
            float row_shift = (float(column) - middle) * inverse_probes;
            float column_shift = (float(row) - middle) * inverse_probes;
            float side = (float(column) + 0.5) * inverse_axis - 0.5 + column_shift + shift;
            float u = (j + (float(row) + 0.5) * inverse_axis + row_shift) * inverse_l;
            vec2 point = spine.p + spine.d * u;
            float before = tolerance * (spine.inverse_w.x + spine.inverse_w.y * u) + depth_rounding;
            ivec2 texel = clamp(ivec2(floor(point + left * (side * depth_scale))), ivec2(0), last_texel);
            vec2 offset = (vec2(texel) + 0.5 - point) * inverse_scale;
            float along = offset.x * spine.along.x + offset.y * spine.along.y;
            float across = offset.x * left.x + offset.y * left.y;
            float line_depth = (spine.depth.x + spine.depth.y * u) + spine.depth_along * along;
            float seen = texelFetch(depth, texel, 0).r - line_depth;
            bool sees = seen >= -before || is_own_face(spine.face_a, seen, across, before) ||
                        is_own_face(spine.face_b, seen, across, before);
            visible += sees ? 1.0 : 0.0;
        }
    }
    return visible * inverse_axis * inverse_axis;
}

// Visibility at the point `at` pixels along a segment of `length_px` pixels, by probes in a box `step`
// pixels long. The box is centred on the point, but stays within the segment (spine test, §3.2).
float visibility_around(Spine spine, float at, float length_px, float step) {
    float cell = min(step, length_px);
    float first = clamp(at - 0.5 * cell, 0.0, length_px - cell);
    return visibility(spine, first / cell, cell / length_px);
}
