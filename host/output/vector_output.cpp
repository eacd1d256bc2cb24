#include "vector_output.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "describe_camera.hpp"
#include "io/atomic_file.hpp"

namespace lineatlas {

std::string note_of_thinned(double share) {
    constexpr double least = 0.001;
    if (share < least) return {};
    return fmt::format("lines are dense: {:.1f} % of their length is not shown, but in layers of "
                       "its own where the file has layers (crease-thinned); --density 0 and "
                       "--hidden-density 0 show all",
                       100 * share);
}

VectorOutput::VectorOutput(VectorFrame frame, const LineSet& lines, FindLines find)
    : frame_(std::move(frame)), lines_(lines), find_(std::move(find)) {}

bool VectorOutput::draw(const Camera& camera, const std::filesystem::path& path) {
    AtomicFile file{path}; // what cannot be written is said before the work
    SeenLines seen = find_(camera);
    VectorOptions options = frame_.paths;
    options.outlines = seen.outlines;
    VectorDrawing drawing =
        make_vector_drawing(lines_, camera, seen.intervals, frame_.style, options);
    drawing.fills = std::move(seen.fills);
    thinned_share_ = std::max(thinned_share_, drawing.thinned_share);
    const std::string description =
        frame_.description + " " + describe_camera(camera, frame_.json.origin);
    const std::string certificate = frame_.certify ? frame_.certify(drawing, camera, path) : "";
    const std::string text = path_file_text(path_file_type(path).value(), drawing,
                                            {.svg = frame_.svg,
                                             .json = frame_.json,
                                             .description = description,
                                             .certificate = certificate});
    file.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    return !drawing.paths.empty();
}

bool VectorOutput::is_whole(const std::filesystem::path& path, glm::ivec2) {
    return is_whole_path_file(path_file_type(path).value(), path);
}

} // namespace lineatlas
