// spine: a stroke straight from a segment of the segment table (§3.1), shared by the geometry-shader and
// vertex-shader forms. Projection, clipping and the description of the own faces are those of
// kernels/project_clip.cl.

#include "probe.glsl"

uniform mat4 clip_from_world;
uniform mat4 world_from_clip;
uniform vec4 eye;                     // homogeneous, in world coordinates
uniform uint kind_mask;
uniform float half_width;             // of the stroke, pixels
uniform samplerBuffer vertices;       // positions
uniform usamplerBuffer triangles;     // vertex indices
uniform samplerBuffer tiles;          // the depth pyramid (kernels/pyramid.cl)
uniform vec2 tile_count;
uniform bool use_tiles;

// As in kernels/segment_table.h.
const uint kind_silhouette = 3u;
const uint no_face = 0xFFFFFFFFu;
const uint face_flipped = 0x80000000u;
const uint face_index = 0x7FFFFFFFu;
const float slope_limit = 100.0;
const float height_limit = 100000.0;
const float tile_size = 16.0;
const int most_tiles_tested = 64;

// A quad reaches this far beyond the stroke's edge, for antialiasing.
const float fringe = 1.0;

struct Stroke {
    bool drawn;
    vec4 p, q;          // clipped ends in clip space
    vec2 start, end;    // the same on the screen, pixels
    vec2 clipped;       // 1 where an end was cut off by the frustum
    uvec2 own_faces;
};

vec3 vertex(uint index) { return texelFetch(vertices, int(index)).xyz; }

bool faces_eye(uint face) {
    uvec3 corners = texelFetch(triangles, int(face)).xyz;
    vec3 a = vertex(corners.x);
    vec3 normal = cross(vertex(corners.y) - a, vertex(corners.z) - a);
    return dot(normal, eye.xyz - a * eye.w) > 0.0;
}

bool is_silhouette(uint face_a, uint face_b) {
    bool flipped = (face_b & face_flipped) != 0u;
    return faces_eye(face_a) != (faces_eye(face_b & face_index) != flipped);
}

bool clip_plane(float dp, float dq, inout float t0, inout float t1) {
    if (dp < 0.0 && dq < 0.0) return false;
    if (dp < 0.0) t0 = max(t0, dp / (dp - dq));
    if (dq < 0.0) t1 = min(t1, dp / (dp - dq));
    return true;
}

bool clip_to_frustum(vec4 p, vec4 q, out float t0, out float t1) {
    t0 = 0.0;
    t1 = 1.0;
    return clip_plane(p.w + p.z, q.w + q.z, t0, t1) && clip_plane(p.w - p.z, q.w - q.z, t0, t1) &&
           clip_plane(p.w + p.x, q.w + q.x, t0, t1) && clip_plane(p.w - p.x, q.w - q.x, t0, t1) &&
           clip_plane(p.w + p.y, q.w + q.y, t0, t1) && clip_plane(p.w - p.y, q.w - q.y, t0, t1) &&
           t0 < t1;
}

uint own_face(uint face, uvec2 ends, vec4 p, vec4 q, vec2 across, float length_px) {
    if (face == no_face) return 0u;
    uvec3 corners = texelFetch(triangles, int(face & face_index)).xyz;
    vec3 v = vertex(corners.x);
    vec3 n = cross(vertex(corners.y) - v, vertex(corners.z) - v);
    vec4 plane = vec4(n, -dot(n, v)) * world_from_clip;
    float slope = -dot(plane.xy / viewport, across) / plane.z;
    uint third = corners.x != ends.x && corners.x != ends.y   ? corners.x
                 : corners.y != ends.x && corners.y != ends.y ? corners.y
                                                              : corners.z;
    vec4 r = clip_from_world * vec4(vertex(third), 1.0);
    float area = dot(cross(p.xyw, q.xyw), r.xyw) / (p.w * q.w) * (viewport.x * viewport.y * 0.25);
    float height = r.w > 0.0 ? area / (r.w * length_px) : area * height_limit;
    return (floatBitsToUint(clamp(slope, -slope_limit, slope_limit)) >> 16) |
           (floatBitsToUint(clamp(height, -height_limit, height_limit)) & 0xFFFF0000u);
}

float own_depth(uint packed_face, float reach, float before) {
    vec2 face = abs(unpack_own_face(packed_face));
    float within = face.x * min(face.y + own_face_snap, reach);
    return min(face.x * reach, max(within, own_face_reach * before));
}

// Whether every probe of the stroke is sure to be blocked; is_hidden in kernels/project_clip.cl.
bool is_hidden(Stroke stroke, float length_px) {
    float reach_texels = 0.5 * depth_scale + 1.0;
    float reach = reach_texels / depth_scale;
    float before = tolerance / min(stroke.p.w, stroke.q.w) + depth_rounding;
    vec2 ends_z = vec2(stroke.p.z / stroke.p.w, stroke.q.z / stroke.q.w) * 0.5 + 0.5;
    vec3 p = vec3(stroke.start * depth_scale, ends_z.x);
    vec3 d = vec3(stroke.end * depth_scale, ends_z.y) - p;
    float margin = before + max(own_depth(stroke.own_faces.x, reach, before),
                                own_depth(stroke.own_faces.y, reach, before)) +
                   abs(d.z) / length_px * reach + 2.0 * depth_rounding;
    int pieces = int(length_px * depth_scale / tile_size) + 1;
    if (pieces > most_tiles_tested) return false;
    for (int i = 0; i < pieces; ++i) {
        vec3 a = p + d * (float(i) / float(pieces));
        vec3 b = p + d * (float(i + 1) / float(pieces));
        float nearest = min(a.z, b.z) - margin;
        vec2 last_tile = tile_count - 1.0;
        ivec2 low = ivec2(clamp(floor((min(a.xy, b.xy) - reach_texels) / tile_size), vec2(0.0), last_tile));
        ivec2 high = ivec2(clamp(floor((max(a.xy, b.xy) + reach_texels) / tile_size), vec2(0.0), last_tile));
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                if (texelFetch(tiles, y * int(tile_count.x) + x).r >= nearest) return false;
            }
        }
    }
    return true;
}

// ends: vertex indices; faces: the triangles on either side.
Stroke make_stroke(uvec2 ends, uvec2 faces, uint tag) {
    Stroke stroke;
    stroke.drawn = false;
    uint kind = tag & 7u;
    if ((kind_mask & (1u << kind)) == 0u) return stroke;
    if (kind == kind_silhouette && !is_silhouette(faces.x, faces.y)) return stroke;
    vec4 p = clip_from_world * vec4(vertex(ends.x), 1.0);
    vec4 q = clip_from_world * vec4(vertex(ends.y), 1.0);
    float t0, t1;
    if (!clip_to_frustum(p, q, t0, t1)) return stroke;
    stroke.p = mix(p, q, t0);
    stroke.q = t1 < 1.0 ? mix(p, q, t1) : q;
    stroke.clipped = vec2(t0 > 0.0, t1 < 1.0);
    stroke.start = (stroke.p.xy / stroke.p.w + 1.0) * (viewport * 0.5);
    stroke.end = (stroke.q.xy / stroke.q.w + 1.0) * (viewport * 0.5);
    float length_px = distance(stroke.start, stroke.end);
    if (length_px <= 0.0) return stroke;
    vec2 along = (stroke.end - stroke.start) / length_px;
    vec2 across = vec2(-along.y, along.x);
    stroke.own_faces = uvec2(own_face(faces.x, ends, stroke.p, stroke.q, across, length_px),
                             own_face(faces.y, ends, stroke.p, stroke.q, across, length_px));
    stroke.drawn = !use_tiles || !is_hidden(stroke, length_px);
    return stroke;
}

// Corner i of 4: start left, start right, end left, end right. local: pixels along and across.
vec4 stroke_corner(Stroke stroke, uint i, out vec2 local) {
    vec2 along = normalize(stroke.end - stroke.start);
    vec2 left = vec2(-along.y, along.x);
    float reach = half_width + fringe;
    bool at_end = i >= 2u;
    float beyond = (at_end ? stroke.clipped.y : stroke.clipped.x) > 0.0 ? 0.0 : reach;
    float side = (i & 1u) == 0u ? reach : -reach;
    local = vec2(at_end ? distance(stroke.start, stroke.end) + beyond : -beyond, side);
    return vec4((stroke.start + along * local.x + left * local.y) / viewport * 2.0 - 1.0, 0.0, 1.0);
}
