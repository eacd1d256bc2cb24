#include "truth.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <thread>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::uint32_t packet = 8;

/// What the filter of a ray has to know: whose line it is for.
struct RayContext {
    RTCIntersectContext base{};
    const glm::uvec3* triangles;
    std::uint32_t p, q; ///< ends of the segment

    RayContext(const LineSet& lines, const Segment& segment)
        : triangles(lines.triangles.data()), p(segment.p), q(segment.q) {
        rtcInitIntersectContext(&base);
        base.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    }

    /// Triangles that hold the line: its two faces, or more at a non-manifold edge.
    bool holds_line(std::uint32_t triangle) const {
        const glm::uvec3 t = triangles[triangle];
        return (t.x == p || t.y == p || t.z == p) && (t.x == q || t.y == q || t.z == q);
    }
};

/// Lets rays pass through the faces of their own line.
void pass_own_faces(const RTCFilterFunctionNArguments* args) {
    const auto& context = *reinterpret_cast<const RayContext*>(args->context);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        if (context.holds_line(RTCHitN_primID(args->hit, args->N, i))) args->valid[i] = 0;
    }
}

/// 32 well mixed bits (the finaliser of MurmurHash3, twice).
std::uint32_t mix(std::uint32_t a, std::uint32_t b) {
    std::uint32_t h = a * 0x9E3779B9U + b;
    for (int round = 0; round < 2; ++round) {
        h ^= h >> 16U;
        h *= 0x85EBCA6BU;
        h ^= h >> 13U;
        h *= 0xC2B2AE35U;
        h ^= h >> 16U;
    }
    return h;
}

double unit(std::uint32_t bits) {
    return (bits + 0.5) / 4294967296.0;
}

/// The camera in double precision: a depth that went through a float is too coarse to start from.
struct Projection {
    glm::dmat4 clip_from_world, world_from_clip;
    glm::dvec2 viewport;
    glm::dvec4 eye;                 ///< w is 0 for a parallel projection
    double pixel_rate;              ///< world size of a pixel per clip-space w
    double farthest_toward_eye = 0; ///< of the bounds, for a parallel projection

    Projection(const Camera& camera, const Bounds& bounds)
        : clip_from_world(glm::dmat4{camera.projection} * glm::dmat4{camera.view}),
          world_from_clip(glm::inverse(clip_from_world)), viewport(camera.size), eye(camera.eye()),
          pixel_rate(2 / (camera.projection[1][1] * viewport.y)) {
        if (eye.w == 0) {
            const glm::dvec3 toward = glm::normalize(glm::dvec3{eye});
            const glm::dvec3 corner{toward.x > 0 ? bounds.max.x : bounds.min.x,
                                    toward.y > 0 ? bounds.max.y : bounds.min.y,
                                    toward.z > 0 ? bounds.max.z : bounds.min.z};
            const double extent = glm::length(glm::dvec3{bounds.max - bounds.min});
            farthest_toward_eye = glm::dot(corner, toward) + extent;
        }
    }
};

/// A ray from the eye to a point.
struct Sight {
    glm::dvec3 origin, direction; ///< direction: unit length, away from the eye
    double distance;              ///< of the point
    double pixel;                 ///< world size of a pixel there
};

/// A segment of which samples are taken.
class Quad {
  public:
    Quad(const Projection& projection, const LineSet& lines, const Segment& segment,
         const ClippedSegment& clipped)
        : projection_(projection) {
        const glm::dvec4 whole_p =
            projection.clip_from_world * glm::dvec4{lines.vertices[segment.p], 1};
        const glm::dvec4 whole_q =
            projection.clip_from_world * glm::dvec4{lines.vertices[segment.q], 1};
        p_ = whole_p + (whole_q - whole_p) * double{clipped.t0};
        q_ = whole_p + (whole_q - whole_p) * double{clipped.t1};
        const glm::dvec2 span =
            (glm::dvec2{q_} / q_.w - glm::dvec2{p_} / p_.w) * projection.viewport * 0.5;
        const double length = glm::length(span);
        // A segment seen end on has no direction; any will do.
        const glm::dvec2 left =
            length > 0 ? glm::dvec2{-span.y, span.x} / length : glm::dvec2{0, 1};
        left_ = left * 2.0 / projection.viewport;
    }

    /// To the point at share `u` of the segment in the window and `across` pixels to its left.
    Sight sight(double u, double across) const {
        // Linear in the window means hyperbolic in clip space.
        const double v = u * p_.w / (u * p_.w + (1 - u) * q_.w);
        glm::dvec4 clip = p_ + (q_ - p_) * v;
        const glm::dvec2 offset = left_ * (across * clip.w);
        clip.x += offset.x;
        clip.y += offset.y;
        const glm::dvec4 world = projection_.world_from_clip * clip;
        const glm::dvec3 point = glm::dvec3{world} / world.w;
        Sight sight{};
        sight.pixel = projection_.pixel_rate * clip.w;
        if (projection_.eye.w != 0) {
            sight.origin = glm::dvec3{projection_.eye};
            sight.distance = glm::length(point - sight.origin);
            sight.direction = (point - sight.origin) / sight.distance;
        } else {
            const glm::dvec3 toward = glm::normalize(glm::dvec3{projection_.eye});
            sight.distance = projection_.farthest_toward_eye - glm::dot(point, toward);
            sight.origin = point + toward * sight.distance;
            sight.direction = -toward;
        }
        return sight;
    }

  private:
    const Projection& projection_;
    glm::dvec4 p_, q_;
    glm::dvec2 left_; ///< a pixel to the left, in normalised device coordinates
};

/// Places in a sample's quad, stratified in a square of strata.
glm::dvec2 jittered(std::uint32_t ray, std::uint32_t strata, std::uint32_t seed) {
    const std::uint32_t bits = mix(seed, ray);
    return glm::dvec2{ray % strata + unit(bits), ray / strata + unit(mix(bits, 1))} /
           double(strata);
}

[[noreturn]] void throw_error(const char* what) {
    throw DeviceError(std::string{"Embree: "} + what);
}

} // namespace

struct Oracle::Scene {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    explicit Scene(const LineSet& lines) {
        device = rtcNewDevice(nullptr);
        if (device == nullptr) throw_error("no device");
        scene = rtcNewScene(device);
        // Robust: no ray slips between two triangles that share an edge.
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        // Copied: Embree reads a few bytes beyond the end of shared buffers.
        void* vertices =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    sizeof(glm::vec3), lines.vertices.size());
        std::ranges::copy(lines.vertices, static_cast<glm::vec3*>(vertices));
        void* triangles =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    sizeof(glm::uvec3), lines.triangles.size());
        std::ranges::copy(lines.triangles, static_cast<glm::uvec3*>(triangles));
        rtcSetGeometryIntersectFilterFunction(geometry, pass_own_faces);
        rtcSetGeometryOccludedFilterFunction(geometry, pass_own_faces);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw_error("could not build the scene");
    }
    ~Scene() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    float visible_share(const Quad& quad, RayContext& context, std::uint32_t j, std::uint32_t l,
                        std::uint32_t seed, const TruthOptions& options) const;
};

float Oracle::Scene::visible_share(const Quad& quad, RayContext& context, std::uint32_t j,
                                   std::uint32_t l, std::uint32_t seed,
                                   const TruthOptions& options) const {
    const auto strata = static_cast<std::uint32_t>(std::ceil(std::sqrt(options.rays)));
    const std::uint32_t rays = strata * strata;
    std::uint32_t blocked = 0;
    for (std::uint32_t first = 0; first < rays; first += packet) {
        alignas(32) std::array<int, packet> valid{};
        alignas(32) RTCRay8 ray{};
        for (std::uint32_t i = 0; i < packet && first + i < rays; ++i) {
            const glm::dvec2 place = jittered(first + i, strata, seed);
            const Sight sight = quad.sight((j + place.x) / l, (place.y - 0.5) * options.width);
            valid[i] = -1;
            ray.org_x[i] = static_cast<float>(sight.origin.x);
            ray.org_y[i] = static_cast<float>(sight.origin.y);
            ray.org_z[i] = static_cast<float>(sight.origin.z);
            ray.dir_x[i] = static_cast<float>(sight.direction.x);
            ray.dir_y[i] = static_cast<float>(sight.direction.y);
            ray.dir_z[i] = static_cast<float>(sight.direction.z);
            ray.tfar[i] = static_cast<float>(sight.distance - options.neighbourhood * sight.pixel);
            ray.mask[i] = ~0U;
            if (!(ray.tfar[i] > 0)) valid[i] = 0;
        }
        rtcOccluded8(valid.data(), scene, &context.base, &ray);
        for (std::uint32_t i = 0; i < packet; ++i) {
            if (valid[i] != 0 && ray.tfar[i] < 0) ++blocked;
        }
    }
    return 1 - static_cast<float>(blocked) / static_cast<float>(rays);
}

Oracle::Oracle(const LineSet& lines) : lines_(lines), scene_(std::make_unique<Scene>(lines)) {}
Oracle::~Oracle() = default;

std::vector<float> Oracle::visibility(const ClippedLines& clipped, const Camera& camera,
                                      const TruthOptions& options) const {
    std::vector<float> result(clipped.offsets.back());
    const Projection projection{camera, lines_.bounds};
    constexpr std::size_t block = 64;
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t begin; (begin = next.fetch_add(block)) < lines_.segments.size();) {
            const std::size_t end = std::min(begin + block, lines_.segments.size());
            for (std::size_t i = begin; i < end; ++i) {
                const std::uint32_t l = clipped.samples(i);
                if (l == 0) continue;
                const Segment& segment = lines_.segments[i];
                const Quad quad{projection, lines_, segment, clipped.clipped[i]};
                RayContext context{lines_, segment};
                for (std::uint32_t j = 0; j < l; ++j) {
                    const std::uint32_t seed = mix(static_cast<std::uint32_t>(i), j);
                    result[clipped.offsets[i] + j] =
                        scene_->visible_share(quad, context, j, l, seed, options);
                }
            }
        }
    };
    {
        std::vector<std::jthread> threads;
        for (unsigned i = 1; i < options.threads; ++i) threads.emplace_back(work);
        work();
    }
    return result;
}

std::optional<Blocker> Oracle::nearest_blocker(const ClippedLines& clipped, const Camera& camera,
                                               std::uint32_t segment, std::uint32_t sample) const {
    const Projection projection{camera, lines_.bounds};
    const Quad quad{projection, lines_, lines_.segments[segment], clipped.clipped[segment]};
    RayContext context{lines_, lines_.segments[segment]};
    std::optional<Blocker> nearest;
    constexpr std::uint32_t strata = 8;
    for (std::uint32_t i = 0; i < strata * strata; ++i) {
        const glm::dvec2 place = jittered(i, strata, sample);
        const Sight sight =
            quad.sight((sample + place.x) / clipped.samples(segment), place.y - 0.5);
        // Backwards, so that the first hit is the one nearest to the line.
        const glm::vec3 origin{sight.origin + sight.direction * sight.distance};
        const glm::vec3 direction{-sight.direction};
        RTCRayHit ray{};
        ray.ray.org_x = origin.x;
        ray.ray.org_y = origin.y;
        ray.ray.org_z = origin.z;
        ray.ray.dir_x = direction.x;
        ray.ray.dir_y = direction.y;
        ray.ray.dir_z = direction.z;
        ray.ray.tfar = static_cast<float>(sight.distance);
        ray.ray.mask = ~0U;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_->scene, &context.base, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
        const double distance = ray.ray.tfar / sight.pixel;
        if (!nearest || distance < nearest->distance) nearest = {distance, ray.hit.primID};
    }
    return nearest;
}

} // namespace lineatlas::bench
