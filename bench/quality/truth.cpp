#include "truth.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>

#include "truth/projection.hpp"

namespace lineatlas::bench {
namespace {

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

/// A point of a sample's quad: ray `ray` of strata * strata stratified ones.
glm::dvec2 jittered(std::uint32_t ray, std::uint32_t strata, std::uint32_t seed) {
    const std::uint32_t bits = mix(seed, ray);
    return glm::dvec2{ray % strata + unit(bits), ray / strata + unit(mix(bits, 1))} /
           double(strata);
}

/// The samples of one segment.
class SampledSegment {
  public:
    SampledSegment(const RayScene& scene, const PreciseCamera& projection,
                   const TruthOptions& options, const ClippedLines& clipped, std::uint32_t index)
        : scene_(scene), options_(options), samples_(clipped.samples(index)), index_(index),
          line_(seen(scene.lines(), projection, clipped.clipped[index], index)),
          blocking_(scene, projection, options.rule, index) {}

    float visible_share(std::uint32_t sample) const {
        const std::vector<Sight> sights = sights_of(sample);
        std::vector<std::uint8_t> blocked(sights.size());
        scene_.cast(
            sights,
            [&](std::uint32_t sight, std::uint32_t triangle) {
                return blocking_.before(sights[sight], triangle).has_value();
            },
            blocked);
        const auto count = std::ranges::count(blocked, std::uint8_t{1});
        return 1 - static_cast<float>(count) / static_cast<float>(blocked.size());
    }

    std::optional<Blocker> nearest_blocker(std::uint32_t sample) const {
        const std::vector<Sight> sights = sights_of(sample);
        std::vector<std::uint8_t> blocked(sights.size());
        std::optional<Blocker> nearest;
        scene_.cast(
            sights,
            [&](std::uint32_t sight, std::uint32_t triangle) {
                const auto before = blocking_.before(sights[sight], triangle);
                if (!before) return false;
                const double distance = *before / sights[sight].pixel;
                if (!nearest || distance < nearest->distance) nearest = {distance, triangle};
                return false; // goes on to the next triangle
            },
            blocked);
        return nearest;
    }

  private:
    static SeenLine seen(const LineSet& lines, const PreciseCamera& projection,
                         const ClippedSegment& clipped, std::uint32_t index) {
        const Segment& segment = lines.segments[index];
        return {projection, glm::dvec3{lines.vertices[segment.p]},
                glm::dvec3{lines.vertices[segment.q]}, double{clipped.t0}, double{clipped.t1}};
    }

    std::vector<Sight> sights_of(std::uint32_t sample) const {
        const auto strata = static_cast<std::uint32_t>(std::ceil(std::sqrt(options_.rays)));
        const std::uint32_t seed = mix(index_, sample);
        std::vector<Sight> sights;
        sights.reserve(std::size_t{strata} * strata);
        for (std::uint32_t ray = 0; ray < strata * strata; ++ray) {
            const glm::dvec2 place = jittered(ray, strata, seed);
            sights.push_back(line_.sight((sample + place.x) / samples_,
                                         (place.y - 0.5) * double{options_.width}));
        }
        return sights;
    }

    const RayScene& scene_;
    const TruthOptions& options_;
    std::uint32_t samples_, index_;
    SeenLine line_;
    Blocking blocking_;
};

} // namespace

std::vector<float> Oracle::visibility(const ClippedLines& clipped, const Camera& camera,
                                      const TruthOptions& options) const {
    std::vector<float> result(clipped.offsets.back());
    const PreciseCamera projection{camera, lines().bounds};
    const auto segments = static_cast<std::uint32_t>(lines().segments.size());
    constexpr std::uint32_t block = 64;
    std::atomic<std::uint32_t> next{0};
    const auto work = [&] {
        for (std::uint32_t begin; (begin = next.fetch_add(block)) < segments;) {
            for (std::uint32_t i = begin; i < std::min(begin + block, segments); ++i) {
                if (clipped.samples(i) == 0) continue;
                const SampledSegment segment{scene_, projection, options, clipped, i};
                for (std::uint32_t j = 0; j < clipped.samples(i); ++j)
                    result[clipped.offsets[i] + j] = segment.visible_share(j);
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
                                               std::uint32_t segment, std::uint32_t sample,
                                               const TruthOptions& options) const {
    const PreciseCamera projection{camera, lines().bounds};
    return SampledSegment{scene_, projection, options, clipped, segment}.nearest_blocker(sample);
}

} // namespace lineatlas::bench
