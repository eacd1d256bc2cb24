// Prints the visible parts of a model's edges. It draws no picture.
#include <cstdlib>
#include <iostream>

#include <lineatlas/error.hpp>
#include <lineatlas/headless.hpp>
#include <lineatlas/renderer.hpp>

using namespace lineatlas;

namespace {

/// Two boxes, the second one behind the first.
Mesh make_boxes() {
    static constexpr std::uint32_t faces[]{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                           2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
    for (const float z : {0.0F, -3.0F}) {
        for (const std::uint32_t face : faces)
            indices.push_back(face + static_cast<std::uint32_t>(positions.size() / 3));
        for (unsigned corner = 0; corner < 8; ++corner)
            for (const float value :
                 {(corner & 1) != 0 ? 1.0F : -1.0F, (corner & 2) != 0 ? 1.0F : -1.0F,
                  (corner & 4) != 0 ? z + 1 : z - 1})
                positions.push_back(value);
    }
    return make_mesh({.positions = positions, .indices = indices});
}

void print_intervals() {
    const LineSet lines = extract_lines(make_boxes());
    HeadlessContext context; // or your own: any GL 4.5 core context that is current
    Renderer renderer;
    if (!renderer.note().empty()) std::cerr << renderer.note() << '\n';
    renderer.set_lines(lines);
    const Camera camera =
        make_camera({.eye = {4, 5, 8}, .target = {0, 0, -1.5F}}, {800, 600}, lines.bounds);
    renderer.draw(camera, {.intervals = KeptIntervals::all, .draw = false}, 0);

    for (const Interval& interval : renderer.read_intervals()) {
        const LineSource& source = lines.sources[interval.segment];
        const auto& [x, y, z] = interval.start_world;
        const auto& [to_x, to_y, to_z] = interval.end_world;
        std::cout << "edge " << source.from << '-' << source.to << ": "
                  << ((interval.flags & LA_INTERVAL_VISIBLE) != 0 ? "visible" : "hidden") //
                  << " from " << x << ' ' << y << ' ' << z                                //
                  << " to " << to_x << ' ' << to_y << ' ' << to_z << '\n';
    }
}

} // namespace

int main() {
    try {
        print_intervals();
    } catch (const Error& error) {
        std::cerr << "intervals: " << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
