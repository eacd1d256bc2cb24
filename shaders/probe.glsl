// Visibility of one sample of a segment by probes of the depth texture (§3.2, §4.3). The same test as
// in kernels/atlas.cl, in the same order of operations.

uniform sampler2D depth;
uniform vec2 viewport;         // pixels
uniform float depth_scale;     // depth texels per pixel
uniform uint probes_per_axis;  // the probes fill a box of 1 pixel across by 1 sample along the line
uniform float tolerance;       // window depth that may stand before a line, times w

// As in kernels/segment_table.h.
const float own_face_snap = 0.0625;
const float own_face_reach = 8.0;
const float fold_clearance = 0.75;
const float depth_rounding = 2.4e-7;

// A segment in window space. A face is its depth slope across the line and its height above it.
struct Spine {
    vec3 p, d;               // window position and depth of p', and the way to q'
    float inverse_w_p, inverse_w_d;
    vec2 along;              // unit vector along the segment
    float depth_along;       // window depth per pixel along it
    vec2 face_a, face_b;
    float outside;           // of a fold: 1 left, -1 right; else 0
};

vec2 unpack_own_face(uint packed_face) {
    return vec2(uintBitsToFloat(packed_face << 16), uintBitsToFloat(packed_face & 0xFFFF0000u));
}

Spine make_spine(vec4 p, vec4 q, uvec2 own_faces) {
    vec3 scale = vec3(viewport * 0.5, 0.5);
    vec3 window_p = (p.xyz / p.w + 1.0) * scale;
    vec3 window_q = (q.xyz / q.w + 1.0) * scale;
    Spine spine;
    spine.p = window_p;
    spine.d = window_q - window_p;
    spine.inverse_w_p = 1.0 / p.w;
    spine.inverse_w_d = 1.0 / q.w - 1.0 / p.w;
    float length_px = sqrt(spine.d.x * spine.d.x + spine.d.y * spine.d.y);
    bool has_length = length_px > 0.0;
    spine.along = has_length ? spine.d.xy / length_px : vec2(1.0, 0.0);
    spine.depth_along = has_length ? spine.d.z / length_px : 0.0;
    spine.face_a = unpack_own_face(own_faces.x);
    spine.face_b = unpack_own_face(own_faces.y);
    bool both_left = spine.face_a.y > 0.0 && spine.face_b.y > 0.0;
    bool both_right = spine.face_a.y < 0.0 && spine.face_b.y < 0.0;
    spine.outside = both_left ? -1.0 : both_right ? 1.0 : 0.0;
    return spine;
}

// Whether what a probe sees is the line's own face.
bool is_own_face(vec2 face, float seen, float across, float before) {
    float expected = face.x * across;
    bool on_side = face.y > 0.0 ? across > -own_face_snap : across < own_face_snap;
    bool in_reach = abs(across) <= abs(face.y) + own_face_snap ||
                    abs(expected) <= own_face_reach * before;
    return on_side && in_reach &&
           abs(seen - expected) <= min(abs(face.x) * own_face_snap + depth_rounding, before);
}

// Visibility of sample j of l, in steps of one probe.
float visibility(Spine spine, uint j, uint l) {
    uint visible = 0u;
    float per_axis = float(probes_per_axis);
    ivec2 last_texel = textureSize(depth, 0) - 1;
    vec2 left = vec2(-spine.along.y, spine.along.x);
    float shift = probes_per_axis == 1u ? spine.outside * fold_clearance / depth_scale : 0.0;
    for (uint row = 0u; row < probes_per_axis; ++row) {
        float u = (float(j) + (float(row) + 0.5) / per_axis) / float(l);
        vec3 point = spine.p + spine.d * u;
        float before = tolerance * (spine.inverse_w_p + spine.inverse_w_d * u) + depth_rounding;
        for (uint column = 0u; column < probes_per_axis; ++column) {
            float side = (float(column) + 0.5) / per_axis - 0.5 + shift;
            vec2 probe = (point.xy + left * side) * depth_scale;
            ivec2 texel = clamp(ivec2(floor(probe)), ivec2(0), last_texel);
            vec2 offset = (vec2(texel) + 0.5) / depth_scale - point.xy;
            float along = offset.x * spine.along.x + offset.y * spine.along.y;
            float across = offset.x * left.x + offset.y * left.y;
            float line_depth = point.z + spine.depth_along * along;
            float seen = texelFetch(depth, texel, 0).r - line_depth;
            bool clear = seen >= -before;
            visible += clear || is_own_face(spine.face_a, seen, across, before) ||
                               is_own_face(spine.face_b, seen, across, before)
                           ? 1u
                           : 0u;
        }
    }
    return float(visible) / (per_axis * per_axis);
}
