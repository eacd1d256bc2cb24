/* What a line's samples see of the depth buffer (§3.2, §4.3), for `atlas`, `intervals`, and the
 * atlas and spine passes. The file that includes this one defines lanes and Depth first, with
 * depth_at(depths, column, row) and, for the triangles in the buffer, number_at(depths, column,
 * row), plane_at(depths, number, part) and patch_at(depths, number). Each includes it once, so
 * there is no guard.
 *
 * There are two rules. If the triangles in the depth buffer are known by number, a probe judges the
 * surface that it sees (sees_past_surface). Otherwise, as with a program's own depth, it judges by
 * depth alone (sees_past_depth). */
#include "shared/own_face.h"

/* One of the two faces of a line, as describe_own_face() in clipping.h packs it. */
struct OwnFace {
    float slope;  /* window depth per pixel across the line, to the left */
    float height; /* of the third corner above the line, pixels, positive to the left; 0: no face;
                     LA_BOTH_SIDES: the line runs within it */
};
LA_TYPEDEF(OwnFace)

FUNCTION OwnFace unpack_own_face(const uint bits) {
    OwnFace face;
    face.slope = as_float(bits << 16);
    face.height = as_float(bits & 0xFFFF0000u);
    return face;
}

/* A segment on the screen, ready for its samples. Texels are those of the depth buffer. */
struct Spine {
    float2 p, d;                    /* p' in texels, and the way to q' */
    float depth_p, depth_d;         /* window depth, linear on the screen */
    float inverse_w_p, inverse_w_d; /* so is 1/w */
    float2 along;                   /* unit vector along the segment */
    float depth_along;              /* window depth per pixel along it */
    OwnFace a, b;
    float outside; /* the outside of a fold, whose faces are both on one side (a silhouette): 1
                      left, -1 right; LA_OUTSIDE_NOWHERE: no probe sees the line; else 0 */
    /* Numbers and smooth patches of its two faces, if these are known by number. */
    int number_a, number_b, patch_a, patch_b;
};
LA_TYPEDEF(Spine)

/* p, q: clipped ends in clip space. own_a, own_b: packed faces, or numbered ones, whose patches the
 * caller has to find. */
FUNCTION Spine make_spine(const float4 p, const float4 q, const uint own_a, const uint own_b,
                          const bool numbered, const float2 viewport, const float depth_scale) {
    const float3 scale = float3(viewport.x * 0.5f, viewport.y * 0.5f, 0.5f);
    const float3 window_p = (xyz(p) / p.w + 1.0f) * scale;
    const float3 window_q = (xyz(q) / q.w + 1.0f) * scale;
    const float3 d = window_q - window_p;
    const float length_px = sqrt(d.x * d.x + d.y * d.y);
    const bool has_length = length_px > 0.0f;
    Spine spine;
    spine.p = xy(window_p) * depth_scale;
    spine.d = xy(d) * depth_scale;
    spine.depth_p = window_p.z;
    spine.depth_d = d.z;
    spine.inverse_w_p = 1.0f / p.w;
    spine.inverse_w_d = 1.0f / q.w - 1.0f / p.w;
    spine.along = has_length ? xy(d) / length_px : float2(1.0f, 0.0f);
    spine.depth_along = has_length ? d.z / length_px : 0.0f;
    spine.a = unpack_own_face(numbered ? 0u : own_a);
    spine.b = unpack_own_face(numbered ? 0u : own_b);
    spine.number_a = int_of(own_a & LA_NO_NUMBER);
    spine.number_b = int_of(own_b & LA_NO_NUMBER);
    spine.patch_a = LA_NO_PATCH;
    spine.patch_b = LA_NO_PATCH;
    spine.outside = own_a == LA_OWN_BURIED && own_b == LA_OWN_BURIED ? LA_OUTSIDE_NOWHERE
                    : numbered ? outside_of_numbered(own_a, own_b)
                               : outside_of_fold(own_a, own_b);
    return spine;
}

/* Lanes whose probes see the line's own face. seen: the depth seen, less the line's depth beside
 * it. across: pixels to the left of the line. before: the tolerance there, in window depth. */
FUNCTION lanes_mask is_own_face(const OwnFace face, const lanes_float seen,
                                const lanes_float across, const lanes_float before) {
    const float sign = face.height > 0.0f ? 1.0f : -1.0f;
    const float reach = fabs(face.height) + LA_OWN_FACE_SNAP;
    const float snap = fabs(face.slope) * LA_OWN_FACE_SNAP + LA_DEPTH_ROUNDING;
    const lanes_float expected = face.slope * across;
    const float least = face.height > LA_HEIGHT_LIMIT ? -LA_HEIGHT_LIMIT : -LA_OWN_FACE_SNAP;
    const lanes_mask on_side = across * sign > least;
    const lanes_mask in_reach =
        fabs(across) <= reach || fabs(expected) <= LA_OWN_FACE_REACH * before;
    return on_side && in_reach && fabs(seen - expected) <= fmin(snap, before);
}

/* By depth: a probe sees the line if nothing there stands before the line by more than the
 * tolerance, or if one of the line's own two faces stands there. Their planes are known, so they
 * need no bias. x, y: the point of the line; column, row: the texel that is probed. */
FUNCTION lanes_mask sees_past_depth(const Spine spine, const lanes_float u, const lanes_float x,
                                    const lanes_float y, const lanes_int column,
                                    const lanes_int row, const lanes_mask in_use,
                                    const Depth depths) {
    const float inverse_scale = 1.0f / depths.scale;
    const float2 left = float2(-spine.along.y, spine.along.x);
    const lanes_float offset_x = (TO_FLOAT(column) + 0.5f - x) * inverse_scale;
    const lanes_float offset_y = (TO_FLOAT(row) + 0.5f - y) * inverse_scale;
    const lanes_float along = offset_x * spine.along.x + offset_y * spine.along.y;
    const lanes_float across = offset_x * left.x + offset_y * left.y;
    const lanes_float line_depth = (spine.depth_p + spine.depth_d * u) + spine.depth_along * along;
    const lanes_float before =
        depths.tolerance * (spine.inverse_w_p + spine.inverse_w_d * u) + LA_DEPTH_ROUNDING;

    const lanes_float seen = depth_at(depths, column, row) - line_depth;
    lanes_mask sees = seen >= -before;
    if (ANY(!sees && in_use)) {
        sees = sees || is_own_face(spine.a, seen, across, before) ||
               is_own_face(spine.b, seen, across, before);
    }
    return sees && in_use;
}

/* By surface: the face that the texel shows hides the line with four exceptions: it is one of the
 * line's own faces, it touches the line, it does not stand before the probe, or it belongs to the
 * line's own smooth patch and bends into the way beside its outline. A face is judged by its plane
 * at the probe, because the probe is not in the middle of the texel. side_x, side_y: texels from
 * the point of the line at (x, y) to the probe. */
FUNCTION lanes_mask sees_past_surface(const Spine spine, const lanes_float u, const lanes_float x,
                                      const lanes_float y, const lanes_float side_x,
                                      const lanes_float side_y, const lanes_int column,
                                      const lanes_int row, const lanes_mask in_use,
                                      const Depth depths) {
    const lanes_int none = 0;
    const lanes_int number = number_at(depths, column, row);
    lanes_mask sees = number < none || number == spine.number_a || number == spine.number_b;
    if (ANY(!sees && in_use)) {
        const lanes_int face = max(number, none);
        const lanes_float plane_x = plane_at(depths, face, 0), plane_y = plane_at(depths, face, 1);
        const lanes_float screen_x = x * depths.screen_scale.x + depths.screen_origin.x;
        const lanes_float screen_y = y * depths.screen_scale.y + depths.screen_origin.y;
        const lanes_float at_line =
            (plane_x * screen_x + plane_y * screen_y) + plane_at(depths, face, 2);
        const lanes_float beside =
            plane_x * (side_x * depths.screen_scale.x) + plane_y * (side_y * depths.screen_scale.y);
        const lanes_float inverse_w = spine.inverse_w_p + spine.inverse_w_d * u;
        /* As in `planes`: 1 - z in a parallel view. */
        const lanes_float nearness =
            depths.parallel ? 2.0f - 2.0f * (spine.depth_p + spine.depth_d * u) : inverse_w;
        const lanes_float contact = (plane_at(depths, face, 3) + LA_NEARNESS_ROUNDING) * inverse_w;
        const lanes_float before_line = at_line - nearness, before = before_line + beside;
        sees = sees || fabs(before_line) < contact || !(before > contact);
        const lanes_mask bends = before < inverse_w * depths.bend;
        if (ANY(!sees && bends && in_use)) {
            const lanes_int own = patch_at(depths, face);
            sees = sees || (bends && (own == spine.patch_a || own == spine.patch_b));
        }
    }
    return sees && in_use;
}

/* Lanes whose probes see the line. The probes stand `side` pixels to the left of the point at share
 * u of the segment. Only lanes in `in_use` are of interest. */
FUNCTION lanes_mask sees_line(const Spine spine, const lanes_float u, const lanes_float side,
                              const lanes_mask in_use, const Depth depths) {
    if (spine.outside == LA_OUTSIDE_NOWHERE) return fabs(u) < 0.0f; /* none */
    const lanes_float x = spine.p.x + spine.d.x * u;
    const lanes_float y = spine.p.y + spine.d.y * u;
    const lanes_float side_texels = side * depths.scale;
    const lanes_float side_x = side_texels * -spine.along.y;
    const lanes_float side_y = side_texels * spine.along.x;
    /* Vectors on both sides: Oclgrind reads past a scalar beside a vector in min and max. */
    const lanes_int none = 0, right = depths.size.x - 1, top = depths.size.y - 1;
    const lanes_int column = min(max(FLOOR_TO_INT(x + side_x), none), right);
    const lanes_int row = min(max(FLOOR_TO_INT(y + side_y), none), top);
    if (depths.knows_surfaces)
        return sees_past_surface(spine, u, x, y, side_x, side_y, column, row, in_use, depths);
    return sees_past_depth(spine, u, x, y, column, row, in_use, depths);
}

/* The box of probes around a sample is one pixel wide across the line and one sample long along it
 * (§3.2, §4.3). Each row and column of probes is a little further along than the one before, so
 * that no two are at the same place along or across the line. These return where probe `column` of
 * `row` stands: pixels to the left of the line, and samples from the start of the box. per_axis:
 * probes per axis. */
FUNCTION lanes_float probe_side(const lanes_int column, const lanes_int row, const int per_axis) {
    const float inverse = 1.0f / float_of(per_axis);
    const float middle = 0.5f * float_of(per_axis - 1);
    const lanes_float shift = (TO_FLOAT(row) - middle) * (1.0f / float_of(per_axis * per_axis));
    return (TO_FLOAT(column) + 0.5f) * inverse - 0.5f + shift;
}

FUNCTION lanes_float probe_ahead(const lanes_int column, const lanes_int row, const int per_axis) {
    const float inverse = 1.0f / float_of(per_axis);
    const float middle = 0.5f * float_of(per_axis - 1);
    const lanes_float shift = (TO_FLOAT(column) - middle) * (1.0f / float_of(per_axis * per_axis));
    return (TO_FLOAT(row) + 0.5f) * inverse + shift;
}

/* How many pixels to the left of the line a single probe stands. On a smooth silhouette it would
 * hit the surface or miss it by chance, and the outline would be dashed. So it stands outside of
 * the fold. */
FUNCTION float lone_probe_shift(const Spine spine, const int per_axis, const float depth_scale) {
    return per_axis == 1 ? spine.outside * LA_FOLD_CLEARANCE * (1.0f / depth_scale) : 0.0f;
}
