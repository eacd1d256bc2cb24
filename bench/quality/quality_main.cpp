// lineatlas-bench-quality: how right a visibility method is, measured against ray casting
// (truth.hpp).

#include <chrono>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "report.hpp"
#include "truth_cache.hpp"

namespace lineatlas::bench {
namespace {

struct Arguments {
    std::string scene, model;
    std::string up = "y";
    std::vector<float> at;
    int frames = 0;
    std::vector<float> distances{1};
    std::vector<int> size{1024, 768};
    std::string quality = "high";
    std::uint32_t probes = 0;
    int depth_scale = 0;
    float step = 2;
    TruthOptions truth;
    bool no_cache = false;
    std::size_t worst = 10;
    std::string picture;
    int picture_scale = 3;
    std::string json;
    DeviceOptions device;
};

CLI::App& set_up(CLI::App& app, Arguments& a) {
    auto* scene = app.add_option("--scene", a.scene, "clevis, house, ship or office");
    app.add_option("--model", a.model, "A model file")->excludes(scene);
    app.add_option("--up", a.up, "The model's upward axis: y or z")
        ->check(CLI::IsMember({"y", "z"}))
        ->capture_default_str();
    auto* at = app.add_option("--at", a.at, "Positions on the scene's camera path, 0 to 1")
                   ->delimiter(',')
                   ->needs(scene);
    app.add_option("--frames", a.frames, "This many positions, evenly along the path")
        ->check(CLI::PositiveNumber)
        ->needs(scene)
        ->excludes(at);
    app.add_option("--distance", a.distances,
                   "Times the eye's distance from its target, e.g. 0.5,1,2")
        ->delimiter(',')
        ->check(CLI::PositiveNumber);
    app.add_option("--size", a.size, "WIDTHxHEIGHT")->delimiter('x')->expected(2);
    app.add_option("--quality", a.quality, "low: 1 probe, 1x depth; high: 9 probes, 2x depth")
        ->check(CLI::IsMember({"low", "high"}))
        ->capture_default_str();
    app.add_option("--probes", a.probes, "Depth probes per sample: 1, 4, 9 or 16");
    app.add_option("--depth-scale", a.depth_scale, "Depth texels per pixel and axis: 1 to 4");
    app.add_option("--step", a.step, "Pixels between samples")->capture_default_str();
    app.add_option("--rays", a.truth.rays, "Rays per sample")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    app.add_option("--neighbourhood", a.truth.neighbourhood,
                   "Pixel widths before a line in which nothing hides it")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_flag("--no-cache", a.no_cache, "Compute the truth even if it is known");
    app.add_option("--worst", a.worst, "Segments to list per view")->capture_default_str();
    app.add_option("--picture", a.picture, "Error picture to write; numbered if there are several");
    app.add_option("--picture-scale", a.picture_scale, "Its pixels per pixel")
        ->check(CLI::Range(1, 16))
        ->capture_default_str();
    app.add_option("--json", a.json, "Figures to write");
    app.add_option("--compute", a.device.compute, "Backend: opencl or reference")
        ->capture_default_str();
    return app;
}

FrameOptions frame_options(const Arguments& a) {
    const bool high = a.quality == "high";
    FrameOptions options;
    options.probes = a.probes != 0 ? a.probes : high ? 9 : 1;
    options.depth_scale = a.depth_scale != 0 ? a.depth_scale : high ? 2 : 1;
    options.step = a.step;
    options.cull_hidden = false; // every sample is compared
    return options;
}

struct NamedView {
    std::string name;
    View view;
};

struct Subject {
    std::string name;
    LineSet lines;
    std::vector<NamedView> views;
};

void add_distances(const Arguments& a, const std::string& name, const View& view,
                   std::vector<NamedView>& views) {
    for (const float factor : a.distances) {
        NamedView moved{name, view};
        if (factor != 1) {
            moved.name += fmt::format(" x{:g}", factor);
            moved.view.eye = view.target + (view.eye - view.target) * factor;
            moved.view.near = moved.view.far = 0;
        }
        views.push_back(moved);
    }
}

Subject load_subject(const Arguments& a) {
    if (a.scene.empty() == a.model.empty()) {
        throw UsageError("name either a --scene or a --model");
    }
    if (!a.model.empty()) {
        Subject subject{a.model, extract_lines(load_mesh(a.model).mesh), {}};
        const glm::vec3 up = a.up == "z" ? glm::vec3{0, 0, 1} : glm::vec3{0, 1, 0};
        const View view = frame_points(subject.lines.vertices, {a.size[0], a.size[1]}, up);
        add_distances(a, "framed", view, subject.views);
        return subject;
    }
    const Scene scene = make_scene(a.scene);
    Subject subject{a.scene, extract_lines(scene.mesh), {}};
    std::vector<float> positions = a.at;
    for (int i = 0; i < a.frames; ++i) {
        positions.push_back(static_cast<float>(i) / static_cast<float>(a.frames));
    }
    if (positions.empty()) positions.push_back(0);
    for (const float t : positions) {
        add_distances(a, fmt::format("at {:.3f}", t), scene.view(t), subject.views);
    }
    return subject;
}

std::filesystem::path picture_path(const Arguments& a, std::size_t index, std::size_t count) {
    std::filesystem::path path = a.picture;
    if (count == 1) return path;
    const std::string stem = path.stem().string();
    return path.replace_filename(fmt::format("{}-{}{}", stem, index, path.extension().string()));
}

void measure(const Arguments& a) {
    const FrameOptions options = frame_options(a);
    if (!a.picture.empty()) check_image_path(a.picture);
    const Subject subject = load_subject(a);
    const glm::ivec2 size{a.size[0], a.size[1]};

    const gl::HeadlessContext context;
    gl::Canvas canvas{size};
    Renderer renderer{a.device};
    renderer.set_lines(subject.lines);
    const Oracle oracle{subject.lines};

    fmt::print("{}: {} triangles, {} segments; {} probes, {}x depth\n", subject.name,
               subject.lines.triangles.size(), subject.lines.segments.size(), options.probes,
               options.depth_scale);
    print_header();
    std::vector<ViewReport> reports;
    KindFigures total;
    for (std::size_t i = 0; i < subject.views.size(); ++i) {
        const Camera camera = make_camera(subject.views[i].view, size, subject.lines.bounds);
        canvas.clear(glm::vec4{1});
        renderer.draw(camera, options, canvas.framebuffer());
        const Renderer::Samples samples = renderer.read_samples();
        const ClippedLines clipped = clip_lines(subject.lines, camera, options.step, options.lines);
        if (clipped.offsets != samples.offsets) {
            throw DeviceError("the renderer's samples are not those of the reference");
        }
        const auto start = std::chrono::steady_clock::now();
        const std::vector<float> truth =
            a.no_cache ? oracle.visibility(clipped, camera, a.truth)
                       : cached_visibility(oracle, clipped, camera, a.truth, truth_cache_folder());
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        if (a.no_cache) {
            const double rays = static_cast<double>(truth.size()) * a.truth.rays;
            fmt::print("truth: {:.2f} s, {:.1f} million rays/s\n", elapsed.count(),
                       rays / elapsed.count() * 1e-6);
        }

        const ViewSamples view{subject.lines, clipped, samples.alpha, truth};
        reports.push_back({subject.views[i].name, compare(view)});
        total.add(reports.back().figures);
        print_figures(reports.back().name, reports.back().figures);
        print_worst(oracle, view, camera, a.worst);
        if (!a.picture.empty()) {
            write_image(picture_path(a, i, subject.views.size()),
                        error_picture(view, size, a.picture_scale));
        }
    }
    if (reports.size() > 1) print_figures("total", total);
    if (!a.json.empty()) write_json(a.json, subject.name, reports, total);
}

} // namespace
} // namespace lineatlas::bench

int main(int argc, char** argv) {
    CLI::App app{"Measures line visibility against ray casting", "lineatlas-bench-quality"};
    lineatlas::bench::Arguments arguments;
    lineatlas::bench::set_up(app, arguments);
    try {
        app.parse(argc, argv);
        lineatlas::bench::measure(arguments);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    } catch (const lineatlas::UsageError& error) {
        fmt::print(stderr, "lineatlas-bench-quality: {}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "lineatlas-bench-quality: {}\n", error.what());
        return 1;
    }
    return 0;
}
