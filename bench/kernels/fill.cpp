// fill: n pixels of four texels each, which show a lit terrain of n / 8 triangles.
// Bytes: per pixel its texels (16) and its colour (4); per triangle its corners (3), its colour
// read and its shade written (8); every vertex (12) once.

#include "terrain_meshlets.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::uint32_t width = 1024; // pixels

/// Each triangle fills 16 texels of a row, with texels of the next triangle mixed in at the border.
std::vector<std::uint32_t> make_numbers(std::uint32_t pixels, std::uint32_t triangles) {
    Random random{1};
    std::vector<std::uint32_t> numbers(std::size_t{4} * pixels);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t x = i % (std::size_t{2} * width), y = i / (std::size_t{2} * width);
        const std::size_t piece = y / 2 * (2 * width / 16) + (x + random.below(4)) / 16;
        numbers[i] = static_cast<std::uint32_t>(piece % triangles);
    }
    return numbers;
}

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const std::uint32_t triangles = n / 8;
    const TerrainMeshlets model{device, make_terrain_mesh(triangles)};
    const SharedBuffer seen = to_device(device, std::vector(model.count, 1U));
    const SharedBuffer colors =
        to_device(device, std::vector<std::uint32_t>(triangles, 0xFF80C0FFU));
    const SharedBuffer numbers = to_device(device, make_numbers(n, triangles));
    const SharedBuffer shaded = device.allocate(triangles * sizeof(std::uint32_t));
    const SharedBuffer pixels = device.allocate(n * sizeof(std::uint32_t));
    const glm::ivec2 size{width, n / width};
    const auto run = [=, &stages] {
        stages.fill({.model = model.tables(),
                     .vertices = *model.vertices,
                     .seen = *seen,
                     .colors = colors.get(),
                     .fill = {.mode = FillMode::lambert},
                     .eye_from_world = glm::mat4{1},
                     .eye = {0, 0, 1, 0},
                     .shaded = *shaded,
                     .numbers = *numbers,
                     .row = 2 * size.x,
                     .origin = {0, 0},
                     .scale = 2,
                     .size = size,
                     .part = {{0, 0}, size},
                     .pixels = *pixels});
        stages.device().finish();
    };
    run();
    const auto result = [&device, pixels, n] {
        const auto bytes = read_back<std::uint8_t>(device, *pixels, std::size_t{4} * n);
        return std::vector<float>(bytes.begin(), bytes.end());
    };
    const std::vector<float> channels = result();
    bool opaque = true;
    for (std::size_t i = 3; i < channels.size(); i += 4) opaque = opaque && channels[i] == 255;
    require(opaque, "fill");
    const double vertices = static_cast<double>(model.vertices->size());
    return {.run = run, .bytes = 20.0 * n + 11.0 * triangles + vertices, .result = result};
}

} // namespace

Rows fill_rows(const Devices& devices) {
    return own_rows(devices, "fill", prepare);
}

} // namespace lineatlas::bench
