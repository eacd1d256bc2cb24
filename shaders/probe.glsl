// Visibility of one sample of a segment by probes of the depth texture (§3.2, §4.3). The same test as
// in kernels/atlas.cl, in the same order of operations.

uniform sampler2D depth;
uniform vec2 viewport;         // pixels
uniform float depth_scale;     // depth texels per pixel
uniform uint probes_per_axis;  // the probes fill a box of 1 pixel across by 1 sample along the line
uniform float bias_limit;      // most window depth that an own face may stand before its line, times w
uniform float bias;

// A segment in window space.
struct Spine {
    vec3 p, d;               // window position and depth of p', and the way to q'
    float inverse_w_p, inverse_w_d;
    vec2 across;             // unit vector across the segment
    vec2 slope_a, slope_b;   // depth slopes of the two faces, per pixel
};

vec2 unpack_slope(uint packed_slope) {
    return vec2(uintBitsToFloat(packed_slope << 16), uintBitsToFloat(packed_slope & 0xFFFF0000u));
}

Spine make_spine(vec4 p, vec4 q, uvec2 slopes) {
    vec3 scale = vec3(viewport * 0.5, 0.5);
    vec3 window_p = (p.xyz / p.w + 1.0) * scale;
    vec3 window_q = (q.xyz / q.w + 1.0) * scale;
    Spine spine;
    spine.p = window_p;
    spine.d = window_q - window_p;
    spine.inverse_w_p = 1.0 / p.w;
    spine.inverse_w_d = 1.0 / q.w - 1.0 / p.w;
    float length_px = sqrt(spine.d.x * spine.d.x + spine.d.y * spine.d.y);
    spine.across = length_px > 0.0 ? vec2(-spine.d.y, spine.d.x) / length_px : vec2(0.0, 1.0);
    spine.slope_a = unpack_slope(slopes.x);
    spine.slope_b = unpack_slope(slopes.y);
    return spine;
}

// Visibility of sample j of l, in steps of one probe.
float visibility(Spine spine, uint j, uint l) {
    uint visible = 0u;
    float per_axis = float(probes_per_axis);
    ivec2 last_texel = textureSize(depth, 0) - 1;
    for (uint row = 0u; row < probes_per_axis; ++row) {
        float u = (float(j) + (float(row) + 0.5) / per_axis) / float(l);
        vec3 point = spine.p + spine.d * u;
        float limit = bias_limit * (spine.inverse_w_p + spine.inverse_w_d * u);
        for (uint column = 0u; column < probes_per_axis; ++column) {
            float side = (float(column) + 0.5) / per_axis - 0.5;
            vec2 probe = (point.xy + spine.across * side) * depth_scale;
            ivec2 texel = clamp(ivec2(floor(probe)), ivec2(0), last_texel);
            vec2 offset = (vec2(texel) + 0.5) / depth_scale - point.xy;
            float own_a = spine.slope_a.x * offset.x + spine.slope_a.y * offset.y;
            float own_b = spine.slope_b.x * offset.x + spine.slope_b.y * offset.y;
            float own = min(min(own_a, own_b), 0.0);
            float nearest = point.z + max(own, -limit) - bias;
            visible += texelFetch(depth, texel, 0).r >= nearest ? 1u : 0u;
        }
    }
    return float(visible) / (per_axis * per_axis);
}
