#include "model_truth.hpp"

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

#include "core/patches.hpp"
#include "fine_mesh.hpp"

namespace lineatlas {
namespace {

/// The scene for rays. Patches end at lines of every kind, drawn or not, but not where a surface
/// goes on smoothly.
RayScene scene_of(const Mesh& mesh, const LineSet& lines, LineOptions options) {
    const bool has_all = (options.lines & usual_line_kinds) == usual_line_kinds;
    if (has_all && !options.smooth_edges) return RayScene{lines};
    options.lines = usual_line_kinds;
    options.smooth_edges = false;
    return {lines, smooth_patches(extract_lines(mesh, options))};
}

} // namespace

struct ModelTruth::Fine {
    Fine(const Mesh& mesh, std::uint32_t parts, const LineOptions& options)
        : Fine(fine_mesh(mesh, parts), options) {}
    Fine(const Mesh& mesh, const LineOptions& options)
        : lines(extract_lines(mesh, options)), scene(scene_of(mesh, lines, options)) {}

    LineSet lines;
    RayScene scene;
};

ModelTruth::ModelTruth(const Mesh& mesh, const LineSet& lines, const LineOptions& options)
    : scene_(scene_of(mesh, lines, options)) {
    const std::uint32_t parts = fine_parts(mesh);
    if (mesh.known_edges.empty()) circles_.emplace(lines);
    if (parts > 1) fine_ = std::make_unique<Fine>(mesh, parts, options);
}

ModelTruth::~ModelTruth() = default;

EdgeTruth ModelTruth::look(const RayScene& scene, const Camera& camera) const {
    return {scene,
            camera,
            {.threads = std::max(1U, std::thread::hardware_concurrency()),
             .circles = circles_ ? &*circles_ : nullptr}};
}

EdgeTruth ModelTruth::seen(const Camera& camera) const {
    return look(fine_ ? fine_->scene : scene_, camera);
}

Certificate ModelTruth::certify(const EdgeTruth& truth, const Camera& camera,
                                const DrawnLines& drawn) const {
    Certificate certificate = compare_lines(truth, drawn);
    if (drawn.pieces.empty()) return certificate;
    // Pieces name edges of the drawn triangles.
    certificate.strict = fine_ ? compare_strictly(look(scene_, camera), drawn.pieces)
                               : compare_strictly(truth, drawn.pieces);
    return certificate;
}

} // namespace lineatlas
