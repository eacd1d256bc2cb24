#include "certifier.hpp"

#include <fmt/core.h>

#include "io/standard_streams.hpp"
#include "truth/model_truth.hpp"

namespace lineatlas::apps {

Certifier::Certifier(const Mesh& mesh, const LineSet& lines, const LineOptions& options)
    : truth_(std::make_unique<ModelTruth>(mesh, lines, options)) {}

Certifier::~Certifier() = default;

std::string Certifier::check(const VectorDrawing& drawing, const Camera& camera,
                             const std::filesystem::path& path) const {
    const EdgeTruth truth = truth_->seen(camera);
    std::string found = certificate_line(truth_->certify(truth, camera, drawn_lines(drawing)));
    print_output(fmt::format("{}: {}\n", path.string(), found));
    return found;
}

} // namespace lineatlas::apps
