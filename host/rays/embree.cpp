#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#if LINEATLAS_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#include "truth/rays_module.hpp"

namespace lineatlas::rays {

class Scene {
  public:
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Scene() = default;
    ~Scene() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
};

namespace {

/// Embree's threads. The thread sanitizer does not see how Embree synchronizes them, so there is
/// one under it.
#ifdef __SANITIZE_THREAD__
constexpr const char* threads_to_build = "threads=1";
#else
constexpr const char* threads_to_build = nullptr; // Embree chooses
#endif

constexpr std::size_t packet = 8;

/// How far a ray goes beyond its end, so that rounding cannot lose a triangle at the end. The judge
/// knows more exactly where it is.
constexpr float beyond = 1e-5F;

#if LINEATLAS_EMBREE == 3
using Context = RTCIntersectContext;

void find_occluded(const int* valid, RTCScene scene, Context* context, RTCRay8* rays) {
    rtcInitIntersectContext(context);
    context->flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded8(valid, scene, context, rays);
}
#else
using Context = RTCRayQueryContext;

void find_occluded(const int* valid, RTCScene scene, Context* context, RTCRay8* rays) {
    rtcInitRayQueryContext(context);
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    arguments.context = context;
    rtcOccluded8(valid, scene, rays, &arguments);
}
#endif

/// The data for the filter of a packet.
struct PacketContext {
    Context base{};
    const Judge* judge;
    std::uint32_t first; ///< ray of the packet
};

void ask_judge(const RTCFilterFunctionNArguments* args) {
    const auto& context = *reinterpret_cast<const PacketContext*>(args->context);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        const std::uint32_t ray = context.first + RTCRayN_id(args->ray, args->N, i);
        if (!context.judge->stops(context.judge->data, ray, RTCHitN_primID(args->hit, args->N, i)))
            args->valid[i] = 0;
    }
}

template <class T>
void copy_to(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
             std::span<const T> values) {
    // Data is copied, because Embree reads a few bytes beyond the end of shared buffers.
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), values.size());
    if (buffer == nullptr) throw std::runtime_error("Embree has not enough memory");
    std::ranges::copy(values, static_cast<T*>(buffer));
}

Scene* build(std::span<const glm::vec3> vertices, std::span<const glm::uvec3> triangles) {
    auto result = std::make_unique<Scene>();
    result->device = rtcNewDevice(threads_to_build);
    if (result->device == nullptr) throw std::runtime_error("Embree offers no device");
    result->scene = rtcNewScene(result->device);
    rtcSetSceneFlags(result->scene, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(result->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    copy_to(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, vertices);
    copy_to(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles);
    rtcSetGeometryOccludedFilterFunction(geometry, ask_judge);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(result->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(result->scene);
    const RTCError error = rtcGetDeviceError(result->device);
    if (error != RTC_ERROR_NONE)
        throw std::runtime_error("Embree could not sort the triangles, error " +
                                 std::to_string(error));
    return result.release();
}

void cast(const Scene& scene, std::span<const Ray> rays, const Judge& judge,
          std::span<std::uint8_t> stopped) {
    for (std::size_t first = 0; first < rays.size(); first += packet) {
        PacketContext context;
        context.judge = &judge;
        context.first = static_cast<std::uint32_t>(first);
        const std::size_t count = std::min(packet, rays.size() - first);
        alignas(32) std::array<int, packet> valid{};
        alignas(32) RTCRay8 packed{};
        for (std::size_t i = 0; i < count; ++i) {
            const Ray& ray = rays[first + i];
            valid[i] = -1;
            packed.org_x[i] = ray.origin.x;
            packed.org_y[i] = ray.origin.y;
            packed.org_z[i] = ray.origin.z;
            packed.dir_x[i] = ray.way.x;
            packed.dir_y[i] = ray.way.y;
            packed.dir_z[i] = ray.way.z;
            packed.tfar[i] = 1 + beyond;
            packed.mask[i] = ~0U;
            packed.id[i] = static_cast<unsigned>(i);
        }
        find_occluded(valid.data(), scene.scene, &context.base, &packed);
        for (std::size_t i = 0; i < count; ++i) stopped[first + i] = packed.tfar[i] < 0 ? 1 : 0;
    }
}

} // namespace
} // namespace lineatlas::rays

extern "C" const lineatlas::rays::Module lineatlas_rays_1{
    .build = lineatlas::rays::build,
    .destroy = [](lineatlas::rays::Scene* scene) { delete scene; },
    .cast = lineatlas::rays::cast};
