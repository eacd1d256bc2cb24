// Prints a hash of every step's result for the built-in scenes. With another compiler, standard
// library or processor it must print the same (./run libcxx).
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/lines.hpp"
#include "lineatlas/scenes.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"

namespace {

using namespace lineatlas;

/// FNV-1a with 64 bits.
std::uint64_t hash_of(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    return hash;
}

/// The hash of a table without padding.
template <class T>
std::uint64_t hash_of(std::span<const T> table) {
    return hash_of({reinterpret_cast<const char*>(table.data()), table.size_bytes()});
}

void print(const std::string& scene, const char* step, std::size_t count, std::uint64_t hash) {
    std::printf("%-8s%-11s%8zu  %016llx\n", scene.c_str(), step, count,
                static_cast<unsigned long long>(hash));
}

void print_hashes(std::string_view name) {
    const Scene scene = make_scene(name);
    const LineSet lines = extract_lines(scene.mesh);
    print(scene.name, "vertices", lines.vertices.size(),
          hash_of(std::span<const glm::vec3>{lines.vertices}));
    print(scene.name, "segments", lines.segments.size(),
          hash_of(std::span<const Segment>{lines.segments}));
    LineVisibility visibility{lines, {.device = "cpp"}};
    for (const float along : {0.1F, 0.6F}) {
        const Camera camera = make_camera(scene.view(along), {1200, 900}, lines.bounds);
        const std::vector<Interval> intervals = visibility.find(camera, {.hidden = true});
        print(scene.name, "intervals", intervals.size(),
              hash_of(std::span<const Interval>{intervals}));
        const VectorDrawing drawing =
            make_vector_drawing(lines, camera, intervals, {}, {.mesh = &scene.mesh});
        const std::string svg = to_svg(drawing);
        print(scene.name, "SVG", drawing.paths.size(), hash_of(svg));
    }
}

} // namespace

int main() {
    for (const std::string_view name : scene_names()) print_hashes(name);
}
