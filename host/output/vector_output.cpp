#include "vector_output.hpp"

#include <fstream>
#include <span>
#include <utility>

#include "describe_camera.hpp"
#include "io/atomic_file.hpp"
#include "io/extension.hpp"

namespace lineatlas {

bool is_json_file(const std::filesystem::path& path) {
    return lower_extension(path) == ".json";
}

bool is_path_file(const std::filesystem::path& path) {
    return lower_extension(path) == ".svg" || is_json_file(path);
}

VectorOutput::VectorOutput(VectorFrame frame, const LineSet& lines, FindIntervals find)
    : frame_(std::move(frame)), lines_(lines), find_(std::move(find)) {}

bool VectorOutput::draw(const Camera& camera, const std::filesystem::path& path) {
    AtomicFile file{path}; // what cannot be written is said before the work
    const VectorDrawing drawing =
        make_vector_drawing(lines_, camera, find_(camera), frame_.style, frame_.paths);
    const std::string description =
        frame_.description + " " + describe_camera(camera, frame_.json.origin);
    const std::string certificate = frame_.certify ? frame_.certify(drawing, camera, path) : "";
    std::string text;
    if (is_json_file(path)) {
        JsonOptions options = frame_.json;
        options.description = description;
        options.certificate = certificate;
        text = to_json(drawing, options);
    } else {
        SvgOptions options = frame_.svg;
        options.description = description;
        options.certificate = certificate;
        text = to_svg(drawing, options);
    }
    file.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    return !drawing.paths.empty();
}

bool VectorOutput::is_whole(const std::filesystem::path& path, glm::ivec2) {
    // Files appear whole or not at all; this tells ours from what others left there.
    std::ifstream file{path, std::ios::binary | std::ios::ate};
    const std::string end = is_json_file(path) ? "}\n" : "</svg>\n";
    const auto size = static_cast<std::streamoff>(end.size());
    if (!file || file.tellg() < size) return false;
    file.seekg(-size, std::ios::end);
    std::string last(end.size(), ' ');
    file.read(last.data(), size);
    return last == end;
}

} // namespace lineatlas
