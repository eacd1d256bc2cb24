// spine: a stroke straight from a segment of the segment table (§3.1). Projection, clipping and the
// description of the own faces are those of kernels/shared/clipping.h.

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
uniform usamplerBuffer face_numbers;  // of the triangles, as in `numbers`

#include "shared/clipping.h"
#include "flags.h"

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

bool front(uint face) {
    uvec3 corners = texelFetch(triangles, int(face)).xyz;
    return faces_eye(vertex(corners.x), vertex(corners.y), vertex(corners.z), eye);
}

bool is_silhouette(uint face_a, uint face_b) {
    bool flipped = (face_b & LA_FACE_FLIPPED) != 0u;
    return front(face_a) != (front(face_b & LA_FACE_INDEX) != flipped);
}

// describe_own_face() of a face; 0 for LA_NO_FACE.
uint own_face(uint face, uint kind, uvec2 ends, vec4 p, vec4 q, vec2 across, float length_px) {
    if (face == LA_NO_FACE) return 0u;
    uvec3 corners = texelFetch(triangles, int(face & LA_FACE_INDEX)).xyz;
    vec3 a = vertex(corners.x), b = vertex(corners.y), c = vertex(corners.z);
    uint third = corners.x != ends.x && corners.x != ends.y   ? 0u
                 : corners.y != ends.x && corners.y != ends.y ? 1u
                                                              : 2u;
    bool holds_p = any(equal(corners, uvec3(ends.x))), holds_q = any(equal(corners, uvec3(ends.y)));
    if (!holds_p || !holds_q) // the line is a part of an edge
        third = farthest_corner(a, b, c, vertex(ends.x), vertex(ends.y));
    vec3 corner = third == 0u ? a : third == 1u ? b : c;
    uint description = describe_own_face(a, b, c, corner, p, q, across, length_px,
                                         to_matrix(clip_from_world), to_matrix(world_from_clip),
                                         viewport);
    return (1u << kind & LA_KINDS_WITHIN) != 0u ? within_own_face(description) : description;
}

uint face_number(uint face) {
    return face != LA_NO_FACE ? texelFetch(face_numbers, int(face & LA_FACE_INDEX)).x : LA_NO_NUMBER;
}

// ends: vertex indices; faces: the triangles on either side.
Stroke make_stroke(uvec2 ends, uvec2 faces, uint tag) {
    Stroke stroke;
    stroke.drawn = false;
    uint kind = tag & LA_TAG_KIND_MASK;
    if ((kind_mask & (1u << kind)) == 0u) return stroke;
    if (kind == LA_KIND_SILHOUETTE && !is_silhouette(faces.x, faces.y)) return stroke;
    Matrix m = to_matrix(clip_from_world);
    vec4 p = transform_point(m, vertex(ends.x));
    vec4 q = transform_point(m, vertex(ends.y));
    vec2 range = clip_to_frustum(p, q);
    if (!(range.x < range.y)) return stroke;
    vec4 way = q - p;
    stroke.p = p + way * range.x;
    stroke.q = range.y < 1.0 ? p + way * range.y : q;
    stroke.clipped = vec2(range.x > 0.0, range.y < 1.0);
    stroke.start = (stroke.p.xy / stroke.p.w + 1.0) * (viewport * 0.5);
    stroke.end = (stroke.q.xy / stroke.q.w + 1.0) * (viewport * 0.5);
    float length_px = distance(stroke.start, stroke.end);
    if (length_px <= 0.0) return stroke;
    vec2 along = (stroke.end - stroke.start) / length_px;
    vec2 across = vec2(-along.y, along.x);
    stroke.own_faces = uvec2(own_face(faces.x, kind, ends, stroke.p, stroke.q, across, length_px),
                             own_face(faces.y, kind, ends, stroke.p, stroke.q, across, length_px));
    vec2 depths = vec2(stroke.p.z / stroke.p.w, stroke.q.z / stroke.q.w) * 0.5 + 0.5;
    stroke.drawn = !use_tiles ||
                   !is_hidden(vec3(stroke.start, depths.x),
                              vec3(stroke.end - stroke.start, depths.y - depths.x),
                              min(stroke.p.w, stroke.q.w), stroke.own_faces.x, stroke.own_faces.y,
                              depth_scale, tolerance, ivec2(tile_count));
    if (knows_surfaces) {
        float outside = outside_of_fold(stroke.own_faces.x, stroke.own_faces.y);
        stroke.own_faces = uvec2(numbered_face(face_number(faces.x), outside > 0.0),
                                 numbered_face(face_number(faces.y), outside < 0.0));
    }
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
