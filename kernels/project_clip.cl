/* project_clip: segments to clip space, clipped to the frustum, with their sample counts (§4.1).
 *
 * project_clip_boxes, project_clip_batches: one work-item per batch of segments. The first runs
 * after the model has changed, the second in every frame. project_clip: one work-item per segment.
 * Every operation is written out in a fixed order without contraction, so that sample counts are
 * equal bit by bit on every device. */

#include "kernels.h"

#include "shared/batches.h"
#include "shared/clipping.h"
#include "shared/screen_box.h"
#include "shared/silhouette.h"

static bool is_other_batch(const uint i, const uint other) {
    return i / LA_BATCH != other / LA_BATCH;
}

/* batches: of `count` segments. */
KERNEL(project_clip_boxes, CountParameters) {
    const uint b = (uint)get_global_id(0);
    const uint first = b * LA_BATCH;
    if (first >= args.count) return;
    const uint last = min(first + LA_BATCH, args.count);
    Box box = no_box();
    uint joined[2] = {0, 0};
    for (uint i = first; i < last; ++i) {
        const Segment segment = segments[i];
        add_to_box(&box, vload3(segment.p, vertices));
        add_to_box(&box, vload3(segment.q, vertices));
        if (segment.face_a != LA_NO_FACE)
            add_face_to_box(&box, segment.face_a & LA_FACE_INDEX, vertices, triangles);
        if (segment.face_b != LA_NO_FACE)
            add_face_to_box(&box, segment.face_b & LA_FACE_INDEX, vertices, triangles);
        /* As in path_end() in run.h. */
        const bool closed = (segment.tag & LA_TAG_CLOSED) != 0;
        const uint before = segment.from_start, after = segment.to_end;
        if (((before > 0 || closed) && is_other_batch(i, before > 0 ? i - 1u : i + after)) ||
            ((after > 0 || closed) && is_other_batch(i, after > 0 ? i + 1u : i - before)))
            joined[(i - first) / 32u] |= 1u << (i - first) % 32u;
    }
    vstore3(box.low, 0, batches[b].low);
    vstore3(box.high, 0, batches[b].high);
    batches[b].joined[0] = joined[0];
    batches[b].joined[1] = joined[1];
    batches[b].widest = 0.0f;
}

/* states: an LA_BATCH_* for every batch. Only a pyramid over the numbered triangles' depth can hide
 * batches. A batch is hidden if each tile that a probe of its segments can touch is nearer all over
 * than the batch's nearest point less the tolerance. The batch's own faces count as parts of it. */
KERNEL(project_clip_batches, ProjectClipParameters) {
    const uint b = (uint)get_global_id(0);
    if (b * LA_BATCH >= args.batched) return;
    const float2 viewport = to_float2(args.viewport);
    const BatchOnScreen box =
        batch_on_screen(to_matrix(args.clip_from_world), viewport, batches + b);
    states[b] = box.is_outside ? LA_BATCH_OUTSIDE : LA_BATCH_SEEN;
    if (box.is_outside || !box.is_bounded || args.hidden == LA_HIDDEN_SAMPLED) return;
    const float2 size = viewport * args.depth_scale;
    const float reach = LA_PROBE_REACH(args.depth_scale) + 1.0f;
    const float nearest =
        box.low.z * 0.5f + 0.5f - args.tolerance / box.least_w - 4.0f * LA_DEPTH_ROUNDING;
    if (tiles_hide((xy(box.low) * 0.5f + 0.5f) * size - reach,
                   (xy(box.high) * 0.5f + 0.5f) * size + reach, nearest, tiles,
                   to_int2(args.tile_count)))
        states[b] = LA_BATCH_HIDDEN;
}

/* describe_own_face() of a face, which may be LA_NO_FACE. within: the line runs through the face.
 */
static uint own_face(const uint face, const bool within, const uint vertex_p, const uint vertex_q,
                     const float4 p, const float4 q, const float2 across, const float length_px,
                     __global const float* vertices, __global const uint* triangles,
                     const Matrix clip_from_world, const Matrix world_from_clip,
                     const float2 viewport) {
    if (face == LA_NO_FACE) return 0;
    const uint i = face & LA_FACE_INDEX;
    const uint i0 = triangles[3 * i], i1 = triangles[3 * i + 1], i2 = triangles[3 * i + 2];
    const float3 a = vload3(i0, vertices), b = vload3(i1, vertices), c = vload3(i2, vertices);
    uint third = i0 != vertex_p && i0 != vertex_q ? 0u : i1 != vertex_p && i1 != vertex_q ? 1u : 2u;
    const bool holds_p = i0 == vertex_p || i1 == vertex_p || i2 == vertex_p;
    const bool holds_q = i0 == vertex_q || i1 == vertex_q || i2 == vertex_q;
    if (!holds_p || !holds_q) /* the line is a part of an edge */
        third = farthest_corner(a, b, c, vload3(vertex_p, vertices), vload3(vertex_q, vertices));
    const float3 corner = third == 0u ? a : third == 1u ? b : c;
    const uint description = describe_own_face(a, b, c, corner, p, q, across, length_px,
                                               clip_from_world, world_from_clip, viewport);
    return within ? within_own_face(description) : description;
}

/* True if a ridge lies where its surface turns away from the eye. An outline runs beside it there
 * and says the same. The surface is the mean of a few triangles along the path. */
static bool is_grazing(__global const Segment* segments, const uint i,
                       __global const float* vertices, __global const uint* triangles,
                       const float3 middle, const Matrix world_from_clip) {
    const uint last = i + min(segments[i].to_end, LA_GRAZING_STEPS);
    float3 n = float3(0.0f, 0.0f, 0.0f);
    for (uint k = i - min(segments[i].from_start, LA_GRAZING_STEPS); k <= last; ++k) {
        const uint t = 3 * segments[k].face_a;
        n = n + face_normal(vload3(triangles[t], vertices), vload3(triangles[t + 1], vertices),
                            vload3(triangles[t + 2], vertices));
    }
    /* The eye is the point that the projection maps to no place of the picture. */
    const float4 eye = world_from_clip.z;
    const float3 to_eye = xyz(eye) - middle * eye.w;
    const float rise = (n.x * to_eye.x + n.y * to_eye.y) + n.z * to_eye.z;
    const float n2 = (n.x * n.x + n.y * n.y) + n.z * n.z;
    const float far2 = (to_eye.x * to_eye.x + to_eye.y * to_eye.y) + to_eye.z * to_eye.z;
    return rise * rise < LA_GRAZING * LA_GRAZING * n2 * far2;
}

/* True if this view shows a centre line. It shows an axis unless the axis is seen end on. It shows
 * a centre mark, whose face is square to the axis, if the axis is seen end on from the side of the
 * mark. */
static bool is_centre_of_view(const uint face, const bool turned, const float3 p, const float3 q,
                              __global const float* vertices, __global const uint* triangles,
                              const Matrix world_from_clip) {
    const bool is_mark = face != LA_NO_FACE;
    const uint t = is_mark ? 3 * face : 0;
    const float3 axis =
        is_mark ? face_normal(vload3(triangles[t], vertices), vload3(triangles[t + 1], vertices),
                              vload3(triangles[t + 2], vertices))
                : q - p;
    const float4 eye = world_from_clip.z;
    const float3 to_eye = xyz(eye) - (p + q) * 0.5f * eye.w;
    const float along = (axis.x * to_eye.x + axis.y * to_eye.y) + axis.z * to_eye.z;
    const float axis2 = (axis.x * axis.x + axis.y * axis.y) + axis.z * axis.z;
    const float far2 = (to_eye.x * to_eye.x + to_eye.y * to_eye.y) + to_eye.z * to_eye.z;
    const bool end_on = along * along >= LA_END_ON * LA_END_ON * axis2 * far2;
    const bool looks_away = along > 0.0f; /* `to_eye` comes from the eye: only squares hide that */
    return is_mark ? end_on && looks_away == turned : !end_on;
}

/* Shares of a segment with its overhang: one below 0, `overhang` pixels before the start, and one
 * above 1, as far behind the end. A segment that reaches behind the eye has no overhang. */
static float2 with_overhang(const float4 p, const float4 q, const float2 viewport,
                            const float overhang) {
    const float2 whole = float2(0.0f, 1.0f);
    if (!(p.w > 0.0f && q.w > 0.0f)) return whole;
    const float2 way = (xy(q) / q.w - xy(p) / p.w) * viewport * 0.5f;
    const float length_px = sqrt(way.x * way.x + way.y * way.y);
    if (!(length_px > 0.0f)) return whole;
    /* Shares of the line in the picture become shares of the segment. Beyond the horizon there are
     * none. */
    const float before = -overhang / length_px, behind = 1.0f - before;
    const float w_before = q.w - before * (q.w - p.w), w_behind = q.w - behind * (q.w - p.w);
    return float2(w_before > 0.0f ? before * p.w / w_before : 0.0f,
                  w_behind > 0.0f ? behind * p.w / w_behind : 1.0f);
}

/* counts[i]: sample count l (eq. 1); 0 for a segment that is not drawn in this frame. arcs[i]:
 * clipped window length in 1/256 pixels. Segments that the pyramid shows hidden have one too,
 * because the texture of a path must not depend on what hides the path. Segments of hidden batches
 * have none; batches are hidden only if nobody asks for lengths. clipped[i] is written if arcs[i]
 * is not 0, except for lone segments that are hidden and dropped. */
KERNEL(project_clip, ProjectClipParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    counts[i] = 0;
    arcs[i] = 0;
    if (i < args.batched) {
        const uint b = i / LA_BATCH, in_batch = i % LA_BATCH;
        const uint state = states[b];
        if (state == LA_BATCH_OUTSIDE) return;
        const bool hangs_over = (segments[i].tag & LA_TAG_KIND_MASK) == LA_KIND_CENTRE;
        /* If the path goes on in another batch, the segment there needs this one as its neighbour.
         */
        if (state == LA_BATCH_HIDDEN && !hangs_over &&
            (batches[b].joined[in_batch / 32u] >> in_batch % 32u & 1u) == 0)
            return;
    }
    const uint tag = segments[i].tag;
    const uint kind = tag & LA_TAG_KIND_MASK;
    if ((args.kind_mask & (1u << kind)) == 0) return;
    const uint face_a = segments[i].face_a;
    const uint face_b = segments[i].face_b;
    const bool contour = (tag & LA_TAG_CONTOUR) != 0; /* then the segment is a silhouette in this
                                                         frame */
    if (kind == LA_KIND_SILHOUETTE && !contour && !is_silhouette(face_a, face_b, front)) return;

    const float3 from = vload3(segments[i].p, vertices), to = vload3(segments[i].q, vertices);
    if (from.x == to.x && from.y == to.y && from.z == to.z) return; /* the object is hidden */
    const Matrix clip_from_world = to_matrix(args.clip_from_world);
    const Matrix world_from_clip = to_matrix(args.world_from_clip);
    if (kind == LA_KIND_RIDGE &&
        is_grazing(segments, i, vertices, triangles, (from + to) * 0.5f, world_from_clip))
        return;
    if (kind == LA_KIND_CENTRE && !is_centre_of_view(face_a, (face_b & LA_FACE_FLIPPED) != 0, from,
                                                     to, vertices, triangles, world_from_clip))
        return;
    const float2 viewport = to_float2(args.viewport);
    float4 p = transform_point(clip_from_world, from);
    float4 q = transform_point(clip_from_world, to);
    const float2 whole =
        kind == LA_KIND_CENTRE ? with_overhang(p, q, viewport, args.overhang) : float2(0.0f, 1.0f);
    if (kind == LA_KIND_CENTRE) {
        const float4 all = q - p;
        q = p + all * whole.y;
        p = p + all * whole.x;
    }
    const float2 range = clip_to_frustum(p, q);
    const float t0 = range.x, t1 = range.y;
    if (!(t0 < t1)) return;
    const float4 way = q - p;
    const float4 cp = p + way * t0;
    const float4 cq = t1 < 1.0f ? p + way * t1 : q;

    const float3 scale = float3(viewport.x * 0.5f, viewport.y * 0.5f, 0.5f);
    const float3 window_p = (xyz(cp) / cp.w + 1.0f) * scale;
    const float3 d = (xyz(cq) / cq.w + 1.0f) * scale - window_p;
    const float length_px = sqrt(d.x * d.x + d.y * d.y);
    uint l = (uint)ceil(length_px / args.step);
    if (l <= 1) {
        if ((tag & LA_TAG_LONE) != 0) return;
        l = 1; /* a path must not look broken (§4.1) */
    }
    const float2 across = float2(-d.y, d.x) / length_px;
    const bool within = contour || (1u << kind & LA_KINDS_WITHIN) != 0;
    const uint p_index = segments[i].p, q_index = segments[i].q;
    const uint own_a = own_face(face_a, within, p_index, q_index, cp, cq, across, length_px,
                                vertices, triangles, clip_from_world, world_from_clip, viewport);
    const uint own_b = own_face(face_b, within, p_index, q_index, cp, cq, across, length_px,
                                vertices, triangles, clip_from_world, world_from_clip, viewport);
    arcs[i] = max((uint)(length_px * LA_ARC_UNITS_PER_PIXEL), 1u);
    const bool buried = (tag & LA_TAG_BURIED) != 0;
    if (args.hidden != LA_HIDDEN_SAMPLED &&
        (buried || is_hidden(tiles, window_p, d, fmin(cp.w, cq.w), own_a, own_b, args.depth_scale,
                             args.tolerance, to_int2(args.tile_count)))) {
        /* Neighbours of its path still need to know where it runs. */
        const bool alone = (segments[i].from_start | segments[i].to_end) == 0;
        if (alone && args.hidden == LA_HIDDEN_DROPPED) return;
        l = 0;
    }
    counts[i] = l;
    const float outside = outside_of_fold(own_a, own_b);
    const uint number_a =
        args.numbered != 0 && face_a != LA_NO_FACE ? numbers[face_a & LA_FACE_INDEX] : LA_NO_NUMBER;
    const uint number_b =
        args.numbered != 0 && face_b != LA_NO_FACE ? numbers[face_b & LA_FACE_INDEX] : LA_NO_NUMBER;
    vstore4(cp, 0, clipped[i].p);
    vstore4(cq, 0, clipped[i].q);
    clipped[i].t0 = whole.x + (whole.y - whole.x) * t0;
    clipped[i].t1 = whole.x + (whole.y - whole.x) * t1;
    const uint told_a = args.numbered != 0 ? numbered_face(number_a, outside > 0.0f) : own_a;
    const uint told_b = args.numbered != 0 ? numbered_face(number_b, outside < 0.0f) : own_b;
    clipped[i].own_a = buried ? LA_OWN_BURIED : told_a;
    clipped[i].own_b = buried ? LA_OWN_BURIED : told_b;
}
