// Runs every kernel in every form that a device may get, on small inputs. It runs them twice with
// different bytes in new buffers: if results differ, they depend on memory that nobody had written.
// scripts/check_kernels.sh also runs this under Oclgrind, which checks accesses and races.
//
//   kernel_check [cpu|gpu PROBES_PER_AXIS]     all forms, or that one

#include <cstring>
#include <iostream>

#include "compare.hpp"
#include "compute/opencl/opencl_backend.hpp"
#include "compute/stages/carried_coordinates.hpp"
#include "compute/stages/silhouette_chains.hpp"
#include "core/clusters.hpp"
#include "core/contact.hpp"
#include "core/corner_normals.hpp"
#include "core/meshlets.hpp"
#include "core/surface_view.hpp"
#include "depth_model.hpp"
#include "devices.hpp"
#include "exact_support.hpp"
#include "lineatlas/error.hpp"
#include "moved_tables.hpp"
#include "poison.hpp"
#include "stages.hpp"
#include "test_meshes.hpp"
#include "visibility/exact_lines.hpp"
#include "visibility/line_tables.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{40, 30};
constexpr StageSettings small{
    .depth_scale = 1, .probes = 1, .run_capacity = 256, .tile_pixels = 20};

/// The depth of a wall on the left and nothing on the right.
std::vector<float> make_depth() {
    const glm::ivec2 texels = size * small.depth_scale;
    std::vector<float> depth;
    for (int y = 0; y < texels.y; ++y) {
        for (int x = 0; x < texels.x; ++x) depth.push_back(3 * x < texels.x ? 0.1F : 1.0F);
    }
    return depth;
}

Camera look_at_it(float aside, const Bounds& bounds) {
    const View view{.eye = {2 + aside, 3, 4}, .target = {0.5F, 0, 0}, .near = 0.1F, .far = 20};
    return make_camera(view, size, bounds);
}

template <class T>
void append(std::vector<std::byte>& bytes, const std::vector<T>& values) {
    const auto more = std::as_bytes(std::span{values});
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// The coordinates of runs, one of each silhouette from `first` on, in the second of two frames.
void append_carried(std::vector<std::byte>& result, compute::Stages& stages,
                    const compute::SegmentTable& table, std::uint32_t first, compute::Buffer& front,
                    const Camera& camera) {
    compute::Device& device = stages.device();
    const std::uint32_t n = table.segment_count, count = n - first;
    const glm::mat4 clip_from_world = camera.clip_from_world();
    const auto clipped = device.allocate(n * sizeof(ClippedSegment));
    const auto offsets = device.allocate((n + 1) * sizeof(la_uint));
    const auto arcs = device.allocate((n + 1) * sizeof(la_uint));
    stages.project_clip({.table = table,
                         .front = front,
                         .clip_from_world = clip_from_world,
                         .viewport = glm::vec2{camera.size},
                         .step = 2,
                         .kind_mask = all_line_kinds,
                         .occlusion = nullptr,
                         .out = {*clipped, *offsets, *arcs}});
    stages.scan(*arcs, n, compute::ScanKind::wrap);
    std::vector<Run> runs(count);
    for (std::uint32_t i = 0; i < count; ++i) runs[i].segment = first + i;
    FrameRecord record{};
    record.points[0] = record.run_total = count;
    const auto on_device = to_device(device, runs);
    const auto totals = to_device(device, std::vector{record});
    compute::CarriedCoordinates carried{stages};
    for (int frame = 0; frame < 2; ++frame)
        carried.find(table, first, {*clipped, *offsets, *arcs}, glm::vec2{camera.size}, 0.4F);
    carried.apply({*on_device, *totals, count});
    append(result, read_back<Run>(device, *on_device, count));
}

/// Scans of more values than one work-group scans alone: its sums fit one group, or they do not.
void append_scans(std::vector<std::byte>& result, compute::Stages& stages) {
    for (const std::uint32_t n : {600U, 2200U}) {
        const auto values = to_device(stages.device(), std::vector(n + 1, 3U));
        stages.scan(*values, n, compute::ScanKind::wrap);
        append(result, read_back<la_uint>(stages.device(), *values, n + 1));
    }
}

/// The silhouettes that a camera sees, in chains; `result` gets the segments and where they came
/// from.
void append_chains(std::vector<std::byte>& result, compute::Stages& stages, const LineSet& lines,
                   const Camera& camera) {
    const LineTables tables = upload_lines(stages.device(), lines);
    const auto triangles = static_cast<std::uint32_t>(lines.triangles.size());
    const LineTables::Chunk& chunk = tables.chunks[0];
    const compute::SegmentTable table{*tables.vertices, *tables.triangles, *chunk.segments,
                                      triangles,        chunk.range.count, chunk.candidates()};
    compute::SilhouetteChains chains{stages, compute::SilhouetteChains::Contours::lifted};
    const compute::SegmentTable found = chains.table_of(
        table, true, {camera.eye(), true}, [](const char*, const auto& run) { run(); });
    const std::vector<std::uint32_t> origins = chains.read_origins();
    if (origins.empty()) throw Error("there are no silhouettes: the check would prove nothing");
    append(result, origins);
    append(result, read_back<Segment>(stages.device(), found.segments, found.segment_count));
    append_carried(result, stages, found, chains.first(), chains.front(), camera);
}

/// Normals of a smooth body that has been bent and turned.
void append_normals(std::vector<std::byte>& result, compute::Stages& stages, const LineSet& lines) {
    const LineTables tables = upload_lines(stages.device(), lines);
    const LineTables::Chunk& chunk = tables.chunks[0];
    const CornerPlaces found = find_corner_places(lines.contours, lines.segments);
    const auto offsets = to_device(stages.device(), found.offsets);
    const auto places = to_device(stages.device(), found.places);
    const auto objects =
        to_device(stages.device(), std::vector<std::uint32_t>(lines.vertices.size(), 0));
    const auto turns = to_device(stages.device(), std::vector<float>{0, -1, 0, 2, 0, 0, 0, 0, 1});
    const auto turned = stages.device().allocate(chunk.corners->size());
    stages.launch_each<compute::kernels::contour_normals>(chunk.corner_count(),
                                                          {.vertices = *tables.vertices,
                                                           .triangles = *tables.triangles,
                                                           .offsets = *offsets,
                                                           .places = *places,
                                                           .corners = *chunk.corners});
    stages.launch_each<compute::kernels::contour_turn>(
        chunk.corner_count(),
        {.rest = *chunk.corners, .objects = *objects, .turns = *turns, .corners = *turned});
    append(result, read_back<ContourCorner>(stages.device(), *turned, chunk.corner_count()));
}

/// Appends the parts of the lines that the exact method finds to be outlines.
void append_outline(std::vector<std::byte>& result, compute::Stages& stages, const LineSet& lines,
                    const Camera& camera) {
    const LineTables tables = upload_lines(stages.device(), lines);
    const auto triangles = static_cast<std::uint32_t>(lines.triangles.size());
    const LineTables::Chunk& chunk = tables.chunks[0];
    const compute::SegmentTable table{*tables.vertices, *tables.triangles, *chunk.segments,
                                      triangles,        chunk.range.count, chunk.candidates()};
    ExactLines exact{stages};
    exact.make_tables(chunk.range.count);
    const LineView view{.camera = camera,
                        .bounds = lines.bounds,
                        .contact = contact_of(lines),
                        .lines = all_line_kinds,
                        .step = 2};
    const auto find = [&] {
        exact.find(
            view, 1, ProgressPart::none(), [&](std::size_t) { return table; },
            [](const char*, const auto& run) { run(); },
            [&](std::size_t, const compute::SegmentTable& found, const compute::SpanTable&) {
                const compute::OutlineTable outline = exact.outline(2);
                append(result, read_back<la_uint>(stages.device(), outline.part_offsets,
                                                  found.segment_count + 1));
            });
    };
    find();
    find(); // by batches; their boxes are made when the model stands still
}

/// Appends the nearness of the planes of all triangles.
void append_planes(std::vector<std::byte>& result, compute::Stages& stages, const LineSet& lines,
                   const Camera& camera) {
    compute::Device& device = stages.device();
    const TriangleClusters parts = build_clusters(lines.vertices, lines.triangles, 4);
    const Meshlets built = build_meshlets(parts.triangles, parts.clusters, lines.vertices.size());
    const auto clusters = to_device(device, parts.clusters);
    const auto meshlets = to_device(device, built.meshlets);
    const auto vertex_list = to_device(device, built.vertices);
    const auto corners = to_device(device, built.corners);
    const auto vertices = to_device(device, lines.vertices);
    const auto planes = device.allocate(lines.triangles.size() * sizeof(glm::vec4));
    const compute::MeshletTables model{*clusters, *meshlets, *vertex_list, *corners,
                                       static_cast<std::uint32_t>(parts.clusters.size())};
    stages.launch<compute::kernels::planes>(
        model.count,
        {.count = model.count,
         .world_from_screen = surface_view(camera).world_from_screen,
         .contact = 0.001F,
         .only_seen = 0},
        {.vertices = vertices.get(), .seen = nullptr, .planes = planes.get()}, model);
    append(result, read_back<glm::vec4>(device, *planes, lines.triangles.size()));
}

/// Appends the colours of a part of a picture whose texels show triangles or nothing.
void append_fill(std::vector<std::byte>& result, compute::Stages& stages, const LineSet& lines,
                 const Camera& camera) {
    compute::Device& device = stages.device();
    const TriangleClusters parts = build_clusters(lines.vertices, lines.triangles, 4);
    const Meshlets built = build_meshlets(parts.triangles, parts.clusters, lines.vertices.size());
    constexpr glm::ivec2 size{23, 9};
    constexpr int scale = 3, row = size.x * scale + 2;
    const auto triangles = static_cast<std::uint32_t>(lines.triangles.size());
    std::vector<std::uint32_t> texels(static_cast<std::size_t>(row * size.y * scale));
    for (std::uint32_t i = 0; i < texels.size(); ++i)
        texels[i] = i % 7 == 0 ? LA_NO_FACE : i / 5 % triangles;
    const auto clusters = to_device(device, parts.clusters);
    const auto meshlets = to_device(device, built.meshlets);
    const auto vertex_list = to_device(device, built.vertices);
    const auto corners = to_device(device, built.corners);
    const auto vertices = to_device(device, lines.vertices);
    const auto seen = to_device(device, std::vector(parts.clusters.size(), 1U));
    const auto numbers = to_device(device, texels);
    const auto shaded = device.allocate(triangles * sizeof(la_uint));
    const auto pixels =
        to_device(device, std::vector<std::uint32_t>(static_cast<std::size_t>(size.x * size.y), 5));
    stages.fill({.model = {*clusters, *meshlets, *vertex_list, *corners,
                           static_cast<std::uint32_t>(parts.clusters.size())},
                 .vertices = *vertices,
                 .seen = *seen,
                 .colors = nullptr,
                 .fill = {.mode = FillMode::toon},
                 .eye_from_world = camera.view,
                 .eye = camera.eye(),
                 .shaded = *shaded,
                 .numbers = *numbers,
                 .row = row,
                 .origin = {2, 0},
                 .scale = scale,
                 .size = size,
                 .part = {{1, 2}, size},
                 .pixels = *pixels});
    append(result, read_back<la_uint>(device, *pixels, static_cast<std::size_t>(size.x * size.y)));
}

/// The filtered state of a frame whose atlas has to grow.
FrameState filter_with_a_small_atlas(FrameStages& stages, const Camera& camera, FrameState state) {
    stages.compact(camera, state);
    if (state.runs.empty()) return state; // all visible parts lie beyond the room
    stages.filter(camera, state);
    stages.density(camera, state);
    return state;
}

/// Runs a frame up to its runs. It makes the atlas by tiles, then as a whole.
FrameState run_frame(FrameStages& stages, const LineSet& lines, const Camera& camera,
                     const std::vector<float>& depth) {
    FrameState before;
    stages.pyramid(camera, depth, before);
    stages.project(look_at_it(0.01F, lines.bounds), true, before);
    stages.scan(before);
    stages.atlas(camera, depth, before);

    FrameState state = before;
    stages.project(camera, false, state);
    stages.scan(state);
    stages.tiled_atlas(camera, depth, state);
    stages.atlas(camera, depth, state);
    stages.temporal(before, state);
    stages.compact(camera, state);
    if (state.runs.empty()) throw Error("nothing is visible: the check would prove nothing");
    return state;
}

/// All stages in the order of a frame, then those of styles and of the readback. Returns all that
/// they computed.
std::vector<std::byte> run_all(FrameStages& stages, const LineSet& lines, bool whole) {
    const std::vector<float> depth = make_depth();
    const Camera camera = look_at_it(0, lines.bounds);
    std::vector<std::byte> result;
    FrameState state = run_frame(stages, lines, camera, depth);
    const FrameState sampled = state;
    append(result, state.runs);
    append(result, state.alpha);
    if (!whole) return result;

    compute::Stages on_device{stages.device()};
    const MovedTables moved =
        moved_on(on_device, lines,
                 std::vector(lines.objects.size(),
                             glm::mat4{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {3, 2, 1, 1}}));
    DepthModel model{stages.device(), lines.vertices, lines.triangles, 4};
    constexpr glm::ivec2 depth_size{70, 37};
    const DrawnDepth drawn = model.draw(on_device, camera.clip_from_world(), depth_size);
    const DrawnDepth numbered = model.draw(on_device, {.clip_from_world = camera.clip_from_world(),
                                                       .whole_size = depth_size,
                                                       .part = {{0, 0}, depth_size},
                                                       .numbered = true});
    const auto visible =
        stages.cull(camera, build_clusters(lines.vertices, lines.triangles, 4).clusters);
    stages.intervals(camera, depth, true, state);
    stages.halo(camera, state);
    stages.filter(camera, state);
    stages.density(camera, state);

    const ExactResult exact = find_exactly(stages.device(), lines, camera, all_line_kinds);
    const LineSet round =
        extract_lines(sphere(1), {.lines = mask_of(LineKind::silhouette), .crease = 3});
    append(result, stages.pens(camera, depth, sampled));
    append_planes(result, on_device, lines, camera);
    append_fill(result, on_device, lines, camera);
    append_outline(result, on_device, lines, camera);
    append_chains(result, on_device, round, look_at_it(0, round.bounds));
    const LineSet smooth = extract_lines(
        sphere(1),
        {.lines = mask_of(LineKind::silhouette), .crease = 3, .silhouettes = Silhouettes::smooth});
    append_chains(result, on_device, smooth, look_at_it(0, smooth.bounds));
    append_outline(result, on_device, smooth, look_at_it(0, smooth.bounds));
    append_normals(result, on_device, smooth);
    append_scans(result, on_device);
    append(result, drawn.texels);
    append(result, drawn.tiles);
    append(result, drawn.seen);
    append(result, numbered.numbers);
    append(result, exact.spans);
    append(result, exact.intervals);
    append(result, exact.runs);
    append(result, moved.vertices);
    append(result, moved.drawn);
    append(result, moved.clusters);
    append(result, moved.bounds);
    append(result, moved.ranges);
    append(result, visible);
    append(result, state.tiles);
    append(result, state.front);
    // Segments without samples have no record.
    for (std::size_t i = 0; i < state.clipped.size(); ++i) {
        if (state.lengths[i] == 0) state.clipped[i] = {};
    }
    append(result, state.clipped);
    append(result, state.offsets);
    append(result, state.arcs);
    append(result, state.alpha);
    append(result, state.intervals);
    append(result, state.runs);
    append(result, state.cuts);
    append(result, state.flags);
    append(result, state.weights);
    append(result, stages.strokes(camera, state));
    for (std::uint32_t missing = 1; missing < 5;
         ++missing) { // missing room comes last, because Oclgrind fails at growing tables
        FrameState cut = sampled;
        cut.alpha.resize(sampled.offsets.back() - missing);
        append(result, filter_with_a_small_atlas(stages, camera, cut).alpha);
    }
    return result;
}

struct Form {
    bool cpu;
    std::uint32_t probes; ///< per axis
    bool whole = true;    ///< all stages; else those of a frame up to its runs
};

/// ran: gets the names of the commands that the device has run.
void check(const compute::OpenClDevice& device, const Form& form, const LineSet& lines,
           std::set<std::string>& ran) {
    compute::OpenClDevice shaped = device;
    shaped.is_cpu = form.cpu;
    StageSettings settings = small;
    settings.probes = form.probes;
    std::string name;
    const auto result_with = [&](std::uint8_t poison) {
        poison_new_buffers(poison);
        compute::Tuning tuning = compute::tuning_for(shaped);
        tuning.depth_tile = 32; // because Oclgrind is slow for every texel
        tuning.scan_tile = 16;  // and every value
        FrameStages stages{compute::make_opencl_backend(device, {}, tuning), lines, settings};
        name = stages.device().description();
        const auto log = stages.device().begin_log();
        std::vector<std::byte> result = run_all(stages, lines, form.whole);
        for (const compute::CommandTime& command : log->read()) ran.emplace(command.name);
        stages.device().end_log();
        return result;
    };
    if (result_with(0x3D) != result_with(0xC2)) {
        throw Error("a result depends on memory that nobody has written");
    }
    std::cout << "checked: " << (form.cpu ? "cpu " : "gpu ") << form.probes << " on " << name
              << std::endl;
}

std::vector<Form> forms(int count, char** arguments) {
    if (count == 3) {
        return {{std::strcmp(arguments[1], "cpu") == 0,
                 static_cast<std::uint32_t>(std::stoul(arguments[2]))}};
    }
    std::vector<Form> all;
    for (const bool cpu : {true, false}) {
        // The number of probes changes no stage but `atlas`.
        for (std::uint32_t probes = 1; probes <= 4; ++probes) {
            all.push_back({cpu, probes, probes == 1});
        }
    }
    return all;
}

void run(int count, char** arguments) {
    const auto devices = compute::list_opencl_devices();
    if (devices.empty()) throw Error("there is no OpenCL device");
    const LineSet lines = extract_lines(cylinder(7, true), {.separate_objects = true});
    std::set<std::string> ran;
    for (const Form& form : forms(count, arguments)) check(devices[0], form, lines, ran);
    for (const std::string& name : ran) std::cout << "ran " << name << '\n';
}

} // namespace
} // namespace lineatlas::test

int main(int count, char** arguments) {
    try {
        lineatlas::test::run(count, arguments);
    } catch (const std::exception& error) {
        std::cerr << "kernel_check: " << error.what() << '\n';
        return 1;
    }
}
