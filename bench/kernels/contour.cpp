// contour: n triangles between n corners with random normals. Three triangles of four are crossed
// by the contour. Bytes per corner: the corner (16), its position (12) and its facing (4). Bytes
// per triangle: its corners (12), their facing (12) and whether it is crossed (4). Bytes per
// crossed triangle: its index (4), its corners (12), their facing (12), their records (48) and
// positions (36), its edges (24), the numbers of two neighbours (8), two places (24) and the
// crossing (20).

#include <algorithm>
#include <iterator>

#include <glm/geometric.hpp>

#include "common.hpp"
#include "compute/stages/silhouette_chains.hpp"
#include "terrain.hpp"

namespace lineatlas::bench {
namespace {

Job prepare_contour(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    Random random{9};
    const auto component = [&] { return static_cast<float>(random.below(2001)) * 1e-3F - 1; };
    std::vector<ContourCorner> corners(n);
    std::vector<compute::ContourEdge> edges(n);
    std::vector<compute::ContourFace> faces(n);
    std::vector<glm::uvec3> face_corners(n);
    std::vector<glm::vec3> vertices(5 * std::size_t{n});
    for (std::uint32_t i = 0; i < n; ++i) {
        const glm::vec3 normal = glm::normalize(glm::vec3{component(), component(), 1.5F});
        corners[i] = {.vertex = i, .normal = {normal.x, normal.y, component()}};
        edges[i] = {i, (i + 1) % n};
        face_corners[i] = {i, (i + 1) % n, (i + 2) % n};
        faces[i] = {{i, (i + 1) % n | LA_CONTOUR_TURNED, (i + 2) % n | LA_CONTOUR_TURNED},
                    {(i + 1) % n, (i + 2) % n, (i + 3) % n}};
        vertices[i] = {component(), component(), component()};
    }
    const SharedBuffer corner_table = to_device(device, corners),
                       edge_table = to_device(device, edges), face_table = to_device(device, faces),
                       places = to_device(device, vertices),
                       corners_of = to_device(device, face_corners),
                       front = to_device(device, std::vector<std::uint8_t>(n, 1));
    const auto crossed = std::make_shared<compute::ChainTables>(compute::ChainTables{&device});
    crossed->numbers.fit(n * sizeof(std::uint32_t));
    // Made of what a job owns: the tables themselves own nothing.
    const auto table = [=] {
        const compute::ContourTables contours{.corners = corner_table.get(),
                                              .edges = edge_table.get(),
                                              .face_corners = corners_of.get(),
                                              .faces = face_table.get(),
                                              .edge_count = n,
                                              .face_count = n,
                                              .replaced = 0,
                                              .vertex_count = n};
        return compute::SegmentTable{*places, *corners_of, *places,
                                     n,       n,           {.count = n, .contours = contours}};
    };
    const glm::vec4 eye{0, 0, 1, 0};
    const auto cross = [=, &stages] { stages.contour(table(), eye, *crossed); };
    cross();
    std::vector<std::uint32_t> is_crossed(n), number_values{0}, chosen_values;
    device.download(*crossed->numbers, std::as_writable_bytes(std::span{is_crossed}));
    for (std::uint32_t i = 0; i < n; ++i) {
        if (is_crossed[i] != 0) chosen_values.push_back(i);
        number_values.push_back(static_cast<std::uint32_t>(chosen_values.size()));
    }
    const auto count = static_cast<std::uint32_t>(chosen_values.size());
    const auto made = std::make_shared<compute::ChainTables>(compute::ChainTables{&device});
    made->numbers.upload(std::span<const std::uint32_t>{number_values});
    made->chosen.upload(std::span<const std::uint32_t>{chosen_values});
    const SharedBuffer crossings = device.allocate(count * sizeof(compute::ContourCrossing));
    const auto run = [=, &stages] {
        cross();
        stages.contour_places({.table = table(),
                               .view = {eye, true},
                               .lifted = true,
                               .count = count,
                               .tables = *made,
                               .crossings = crossings.get()},
                              *front);
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = 60.0 * n + 188.0 * count, .result = [&device, crossings, count] {
                return read_back<std::uint8_t>(device, *crossings,
                                               count * sizeof(compute::ContourCrossing));
            }};
}

/// contour_turn: n corners of 500 objects. Bytes per corner: the corner read and written (32) and
/// its object (4).
Job prepare_turn(compute::Stages& stages, std::uint32_t n) {
    constexpr std::uint32_t object_count = 500;
    compute::Device& device = stages.device();
    std::vector<ContourCorner> values(n);
    std::vector<std::uint32_t> object_values(n);
    std::vector<float> turn_values(9 * std::size_t{object_count});
    for (std::uint32_t i = 0; i < n; ++i) {
        values[i] = {.vertex = i, .normal = {0.6F, 0, 0.8F}};
        object_values[i] = static_cast<std::uint32_t>(std::uint64_t{i} * object_count / n);
    }
    for (std::size_t i = 0; i < turn_values.size(); ++i)
        turn_values[i] = i % 4 == 0 ? 2.0F : 0.1F; // any matrix takes as long
    const SharedBuffer rest = to_device(device, values), corners = to_device(device, values),
                       objects = to_device(device, object_values),
                       turns = to_device(device, turn_values);
    const auto run = [=, &stages] {
        stages.launch_each<compute::kernels::contour_turn>(
            n, {.rest = *rest, .objects = *objects, .turns = *turns, .corners = *corners});
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = 36.0 * n, .result = [&device, corners, n] {
                return read_back<std::uint8_t>(device, *corners, n * sizeof(ContourCorner));
            }};
}

/// contour_normals: n corners of a terrain of n triangles, with two triangles at each corner. Bytes
/// per corner: its normal (12), its offset (4), and for each of its triangles the place in the list
/// (4) and the vertices (12).
Job prepare_normals(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Terrain terrain = make_terrain(n, 0);
    std::vector<std::uint32_t> offset_values(std::size_t{n} + 1), place_values(2 * std::size_t{n});
    for (std::uint32_t i = 0; i <= n; ++i) offset_values[i] = 2 * i;
    for (std::uint32_t i = 0; i < n; ++i) {
        place_values[2 * i] = 3 * i;
        place_values[2 * i + 1] = 3 * i + 1;
    }
    const SharedBuffer vertices = to_device(device, terrain.vertices),
                       triangles = to_device(device, terrain.triangles),
                       offsets = to_device(device, offset_values),
                       places = to_device(device, place_values),
                       corners = to_device(device, std::vector<ContourCorner>(n));
    const auto run = [=, &stages] {
        stages.launch_each<compute::kernels::contour_normals>(n, {.vertices = *vertices,
                                                                  .triangles = *triangles,
                                                                  .offsets = *offsets,
                                                                  .places = *places,
                                                                  .corners = *corners});
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = 48.0 * n, .result = [&device, corners, n] {
                return read_back<std::uint8_t>(device, *corners, n * sizeof(ContourCorner));
            }};
}

} // namespace

Rows contour_rows(const Devices& devices) {
    Rows rows = own_rows(devices, "contour", prepare_contour);
    std::ranges::move(own_rows(devices, "contour_turn", prepare_turn), std::back_inserter(rows));
    std::ranges::move(own_rows(devices, "contour_normals", prepare_normals),
                      std::back_inserter(rows));
    return rows;
}

} // namespace lineatlas::bench
