#include "stages.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace lineatlas::compute::reference {
namespace {

glm::vec3 load3(std::span<const float> values, std::uint32_t index) {
    return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

/// Not normalised: only its direction counts.
glm::vec3 triangle_normal(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const glm::vec3 ab = b - a;
    const glm::vec3 ac = c - a;
    return {ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
}

glm::vec4 transform_point(const glm::mat4& m, glm::vec3 v) {
    return (m[0] * v.x + m[1] * v.y) + (m[2] * v.z + m[3]);
}

struct ClipRange {
    float t0 = 0;
    float t1 = 1;

    /// Liang-Barsky against one plane, given the signed distances of both ends (>= 0: inside).
    bool clip(float dp, float dq) {
        if (dp < 0 && dq < 0) return false;
        if (dp < 0) t0 = std::max(t0, dp / (dp - dq));
        if (dq < 0) t1 = std::min(t1, dp / (dp - dq));
        return true;
    }
};

bool clip_to_frustum(glm::vec4 p, glm::vec4 q, ClipRange& range) {
    return range.clip(p.w + p.z, q.w + q.z) && range.clip(p.w - p.z, q.w - q.z) &&
           range.clip(p.w + p.x, q.w + q.x) && range.clip(p.w - p.x, q.w - q.x) &&
           range.clip(p.w + p.y, q.w + q.y) && range.clip(p.w - p.y, q.w - q.y) &&
           range.t0 < range.t1;
}

/// A line on the screen, as its faces need to know it.
struct ScreenLine {
    std::uint32_t vertex_p, vertex_q;
    glm::vec4 p, q; ///< clipped ends in clip space
    glm::vec2 across;
    float length_px;
};

/// fmax and fmin, not clamp: a NaN (a plane without a direction) becomes a limit.
float limited(float value, float limit) {
    return std::fmin(std::fmax(value, -limit), limit);
}

/// See own_face in project_clip.cl.
std::uint32_t own_face(const ProjectClipInput& in, std::uint32_t face, const ScreenLine& line) {
    if (face == LA_NO_FACE) return 0;
    const std::uint32_t i = face & LA_FACE_INDEX;
    const std::array corners{in.triangles[3 * i], in.triangles[3 * i + 1], in.triangles[3 * i + 2]};
    const glm::vec3 v = load3(in.vertices, corners[0]);
    const glm::vec3 n =
        triangle_normal(v, load3(in.vertices, corners[1]), load3(in.vertices, corners[2]));
    const float nw = -((n.x * v.x + n.y * v.y) + n.z * v.z);
    const auto plane = [&](int column) {
        const glm::vec4& c = in.world_from_clip[column];
        return (n.x * c.x + n.y * c.y) + (n.z * c.z + nw * c.w);
    };
    const glm::vec2 viewport = in.viewport;
    const float slope =
        -(plane(0) / viewport.x * line.across.x + plane(1) / viewport.y * line.across.y) / plane(2);

    const auto is_third = [&](std::uint32_t corner) {
        return corner != line.vertex_p && corner != line.vertex_q;
    };
    const std::uint32_t third = is_third(corners[0])   ? corners[0]
                                : is_third(corners[1]) ? corners[1]
                                                       : corners[2];
    const glm::vec4 r = transform_point(in.clip_from_world, load3(in.vertices, third));
    const glm::vec4& p = line.p;
    const glm::vec4& q = line.q;
    const float det = ((p.y * q.w - p.w * q.y) * r.x + (p.w * q.x - p.x * q.w) * r.y) +
                      (p.x * q.y - p.y * q.x) * r.w;
    const float area = det / (p.w * q.w) * (viewport.x * viewport.y * 0.25F);
    const float height = r.w > 0 ? area / (r.w * line.length_px) : area * LA_HEIGHT_LIMIT;
    return std::bit_cast<std::uint32_t>(limited(slope, LA_SLOPE_LIMIT)) >> 16U |
           (std::bit_cast<std::uint32_t>(limited(height, LA_HEIGHT_LIMIT)) & 0xFFFF0000U);
}

bool is_silhouette(const Segment& segment, std::span<const std::uint8_t> front) {
    const bool flipped = (segment.face_b & LA_FACE_FLIPPED) != 0;
    return (front[segment.face_a] != 0) !=
           ((front[segment.face_b & LA_FACE_INDEX] != 0) != flipped);
}

/// See own_depth in project_clip.cl.
float own_depth(std::uint32_t packed, float reach, float before) {
    const float slope = std::fabs(std::bit_cast<float>(packed << 16U));
    const float height = std::fabs(std::bit_cast<float>(packed & 0xFFFF0000U));
    const float within = slope * std::fmin(height + LA_OWN_FACE_SNAP, reach);
    return std::fmin(slope * reach, std::fmax(within, LA_OWN_FACE_REACH * before));
}

/// See is_hidden in project_clip.cl.
bool is_hidden(glm::vec3 p, glm::vec3 d, float length_texels, float reach, float depth_margin,
               std::span<const float> tiles, glm::ivec2 tile_count) {
    const int pieces = static_cast<int>(length_texels * (1.0F / LA_TILE)) + 1;
    if (pieces > LA_MOST_TILES_TESTED) return false;
    const float per_piece = 1.0F / static_cast<float>(pieces);
    const auto tile = [&](glm::vec2 texel) {
        const glm::vec2 place = texel * (1.0F / LA_TILE);
        return glm::clamp(glm::ivec2{std::floor(place.x), std::floor(place.y)}, glm::ivec2{0},
                          tile_count - 1);
    };
    for (int i = 0; i < pieces; ++i) {
        const glm::vec3 a = p + d * (static_cast<float>(i) * per_piece);
        const glm::vec3 b = p + d * (static_cast<float>(i + 1) * per_piece);
        const float nearest = std::fmin(a.z, b.z) - depth_margin;
        const glm::ivec2 first = tile(glm::min(glm::vec2{a}, glm::vec2{b}) - reach);
        const glm::ivec2 last = tile(glm::max(glm::vec2{a}, glm::vec2{b}) + reach);
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                const auto index = static_cast<std::size_t>(y) * tile_count.x + x;
                if (tiles[index] >= nearest) return false;
            }
        }
    }
    return true;
}

/// Whether the pyramid shows the whole segment hidden.
bool is_hidden(const ProjectClipInput& in, const ScreenLine& line, glm::vec3 window_p, glm::vec3 d,
               std::uint32_t own_a, std::uint32_t own_b) {
    const float before = in.tolerance / std::fmin(line.p.w, line.q.w) + LA_DEPTH_ROUNDING;
    const float reach_texels = LA_PROBE_REACH(in.depth_scale);
    const float reach = reach_texels / in.depth_scale;
    const float own = std::fmax(own_depth(own_a, reach, before), own_depth(own_b, reach, before));
    const float along = line.length_px > 0 ? std::fabs(d.z) / line.length_px * reach : 0;
    const float margin = before + own + along + 2 * LA_DEPTH_ROUNDING;
    const glm::vec3 texels{in.depth_scale, in.depth_scale, 1};
    return is_hidden(window_p * texels, d * texels, line.length_px * in.depth_scale, reach_texels,
                     margin, in.tiles, in.tile_count);
}

} // namespace

void facing(std::span<const float> vertices, std::span<const std::uint32_t> triangles,
            glm::vec4 eye, std::span<std::uint8_t> front) {
    for (std::size_t i = 0; i < triangles.size() / 3; ++i) {
        const glm::vec3 a = load3(vertices, triangles[3 * i]);
        const glm::vec3 n = triangle_normal(a, load3(vertices, triangles[3 * i + 1]),
                                            load3(vertices, triangles[3 * i + 2]));
        const glm::vec3 to_eye = glm::vec3{eye} - a * eye.w;
        front[i] = (n.x * to_eye.x + n.y * to_eye.y) + n.z * to_eye.z > 0 ? 1 : 0;
    }
}

void project_clip(const ProjectClipInput& in, std::span<ClippedSegment> clipped,
                  std::span<std::uint32_t> counts, std::span<std::uint32_t> arcs) {
    for (std::size_t i = 0; i < in.segments.size(); ++i) {
        counts[i] = 0;
        arcs[i] = 0;
        const Segment& segment = in.segments[i];
        const std::uint32_t kind = segment.tag & LA_TAG_KIND_MASK;
        if ((in.kind_mask & (1U << kind)) == 0) continue;
        if (kind == LA_KIND_SILHOUETTE && !is_silhouette(segment, in.front)) continue;

        const glm::vec4 p = transform_point(in.clip_from_world, load3(in.vertices, segment.p));
        const glm::vec4 q = transform_point(in.clip_from_world, load3(in.vertices, segment.q));
        ClipRange range;
        if (!clip_to_frustum(p, q, range)) continue;
        const glm::vec4 way = q - p;
        const glm::vec4 cp = p + way * range.t0;
        const glm::vec4 cq = range.t1 < 1 ? p + way * range.t1 : q;

        const glm::vec3 scale{in.viewport * 0.5F, 0.5F};
        const glm::vec3 window_p = (glm::vec3{cp} / cp.w + 1.0F) * scale;
        const glm::vec3 d = (glm::vec3{cq} / cq.w + 1.0F) * scale - window_p;
        const float length_px = std::sqrt(d.x * d.x + d.y * d.y);
        auto l = static_cast<std::uint32_t>(std::ceil(length_px / in.step)); // eq. 1
        if (l <= 1) {
            if ((segment.tag & LA_TAG_LONE) != 0) continue;
            l = 1;
        }
        const ScreenLine line{.vertex_p = segment.p,
                              .vertex_q = segment.q,
                              .p = cp,
                              .q = cq,
                              .across = glm::vec2{-d.y, d.x} / length_px,
                              .length_px = length_px};
        const std::uint32_t own_a = own_face(in, segment.face_a, line);
        const std::uint32_t own_b = own_face(in, segment.face_b, line);
        arcs[i] = std::max(static_cast<std::uint32_t>(length_px * LA_ARC_UNITS_PER_PIXEL), 1U);
        if (!in.tiles.empty() && is_hidden(in, line, window_p, d, own_a, own_b)) {
            const bool alone = segment.from_start == 0 && segment.to_end == 0;
            if (alone && !in.keep_clipped) continue;
            l = 0;
        }
        counts[i] = l;
        clipped[i] = {.p = {cp.x, cp.y, cp.z, cp.w},
                      .q = {cq.x, cq.y, cq.z, cq.w},
                      .t0 = range.t0,
                      .t1 = range.t1,
                      .own_a = own_a,
                      .own_b = own_b};
    }
}

} // namespace lineatlas::compute::reference
