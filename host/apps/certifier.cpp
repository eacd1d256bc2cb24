#include "certifier.hpp"

#include <algorithm>
#include <thread>

#include <fmt/core.h>

#include "core/patches.hpp"
#include "io/standard_streams.hpp"
#include "truth/certificate.hpp"

namespace lineatlas::apps {

Certifier::Certifier(const Mesh& mesh, const LineSet& lines, std::optional<float> crease_angle)
    // Patches end at lines of every kind, drawn or not.
    : scene_(std::make_unique<RayScene>(
          lines, smooth_patches(extract_lines(mesh, {.crease = crease_angle})))) {}

Certifier::~Certifier() = default;

std::string Certifier::check(const VectorDrawing& drawing, const Camera& camera,
                             const std::filesystem::path& path) const {
    const EdgeTruth truth{
        *scene_, camera, {.threads = std::max(1U, std::thread::hardware_concurrency())}};
    std::string found = certificate_line(certify(truth, drawn_lines(drawing)));
    print_output(fmt::format("{}: {}\n", path.string(), found));
    return found;
}

} // namespace lineatlas::apps
