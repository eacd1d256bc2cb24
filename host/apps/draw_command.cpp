#include "commands.hpp"

#include <map>
#include <numbers>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "compute/backends.hpp"
#include "description.hpp"
#include "draw_stats.hpp"
#include "glpasses/headless_context.hpp"
#include "io/image_writer.hpp"
#include "io/isolated.hpp"
#include "io/odd_triangles.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "output_pattern.hpp"
#include "path_options.hpp"
#include "picture_options.hpp"
#include "picture_output.hpp"
#include "profile_output.hpp"
#include "read_options.hpp"
#include "sequence_options.hpp"
#include "style_options.hpp"
#include "values.hpp"
#include "vector_output.hpp"

namespace lineatlas::apps {
namespace {

constexpr float radians_per_degree = std::numbers::pi_v<float> / 180;

/// The command line of `draw` as written; what is empty was not given.
struct DrawArguments {
    std::string model, scene, output;
    std::string size = "1024x768";
    std::string eye, target, up;
    float fov = 40;
    float at = 0;
    std::string lines = "crease,boundary,material,silhouette,file";
    float crease = 30;
    std::string method = "atlas";
    std::string quality = "high";
    std::uint32_t probes = 0;
    int depth_scale = 0;
    float step = 2;
    std::string atlas = "auto";
    std::string atlas_layout = "wrap";
    std::string stroke_shader = "geometry";
    StyleOptions style;
    ReadOptions read;
    SequenceOptions sequence;
    PictureOptions picture;
    PathOptions paths;
    DeviceOptions device;
    bool stats = false;
    ProfileOptions profile;
    int repeat = 1;
};

template <class T>
T choose(std::string_view option, const std::string& value, const std::map<std::string, T>& known) {
    const auto found = known.find(value);
    if (found != known.end()) return found->second;
    std::string names;
    for (const auto& [name, _] : known) names += (names.empty() ? "" : ", ") + name;
    throw UsageError(fmt::format("{} \"{}\" is unknown; there is {}", option, value, names));
}

/// Depth texels per pixel that --quality stands for. Paths end where the depth buffer has it, so
/// they get a finer one where no GL's limit is in its way.
int usual_depth_scale(const DrawArguments& arguments, bool high, glm::ivec2 size) {
    constexpr int largest = 4096;
    const bool finer = is_path_file(arguments.output) && size.x <= largest && size.y <= largest;
    return !high ? 1 : finer ? 4 : 2;
}

FrameOptions frame_options(const DrawArguments& arguments, const Style& style, glm::ivec2 size) {
    const Method method = choose<Method>("--method", arguments.method,
                                         {{"atlas", Method::atlas},
                                          {"spine", Method::spine},
                                          {"itembuffer", Method::item_buffer},
                                          {"opengl", Method::opengl}});
    const bool high =
        choose<bool>("--quality", arguments.quality, {{"low", false}, {"high", true}});
    FrameOptions options;
    options.method = method;
    options.probes = high ? 9 : 1;
    options.depth_scale = usual_depth_scale(arguments, high, size);
    if (arguments.probes != 0) options.probes = arguments.probes;
    if (arguments.depth_scale != 0) options.depth_scale = arguments.depth_scale;
    options.step = arguments.step;
    options.lines = parse_lines("--lines", arguments.lines);
    options.atlas = choose<AtlasForm>("--atlas", arguments.atlas,
                                      {{"auto", AtlasForm::automatic},
                                       {"raster", AtlasForm::raster},
                                       {"compute", AtlasForm::compute}});
    options.atlas_layout = choose<AtlasLayoutChoice>(
        "--atlas-layout", arguments.atlas_layout,
        {{"wrap", AtlasLayoutChoice::wrap}, {"gutter", AtlasLayoutChoice::gutter}});
    options.stroke_shader = choose<StrokeShader>(
        "--stroke-shader", arguments.stroke_shader,
        {{"geometry", StrokeShader::geometry}, {"vertex", StrokeShader::vertex}});
    options.style = style;
    return options;
}

/// What is drawn, and the view on it unless the command line says another.
struct Subject {
    std::string name;
    Mesh mesh;
    LineSet lines;
    View view;
    glm::dvec3 origin{0}; ///< of the mesh and the view, in the file's coordinates
};

Axis vertical_axis(const Subject& subject, glm::vec3 up) {
    return {.point = 0.5F * (subject.lines.bounds.min + subject.lines.bounds.max),
            .direction = glm::normalize(up)};
}

Subject load_subject(const DrawArguments& arguments, glm::ivec2 size) {
    const LineOptions line_options{.kinds = parse_lines("--lines", arguments.lines),
                                   .crease_angle = arguments.crease * radians_per_degree};
    const float fov = arguments.fov * radians_per_degree;
    if (!arguments.scene.empty()) {
        Scene scene = make_scene(arguments.scene);
        LineSet lines = extract_lines(scene.mesh, line_options);
        const View view = scene.view(arguments.at);
        return {scene.name, std::move(scene.mesh), std::move(lines), view, {}};
    }
    LoadedMesh loaded = load_mesh_isolated(arguments.model, arguments.read.limits());
    Subject subject{arguments.model, std::move(loaded.mesh), {}, {}, loaded.origin};
    subject.lines = extract_lines(subject.mesh, line_options);
    add_notes(subject.lines.odd, loaded.notes);
    if (!loaded.notes.empty()) fmt::print(stderr, "lineatlas: {}\n", fmt::join(loaded.notes, "; "));
    const glm::vec3 up = arguments.up.empty() ? glm::vec3{0, 1, 0} : parse_up("--up", arguments.up);
    const std::vector<glm::vec3>& points = subject.lines.vertices;
    subject.view = arguments.sequence.turns()
                       ? frame_points(swept(points, vertical_axis(subject, up)), size, up, fov)
                       : frame_points(points, size, up, fov);
    return subject;
}

void apply_camera(const DrawArguments& arguments, const CLI::App& app, Subject& subject) {
    View& view = subject.view;
    // A camera placed by hand sees planes fitted to it.
    if (!arguments.eye.empty()) {
        view.eye = parse_point("--eye", arguments.eye) - subject.origin;
        view.near = view.far = 0;
    }
    if (!arguments.target.empty())
        view.target = parse_point("--target", arguments.target) - subject.origin;
    if (!arguments.up.empty()) view.up = parse_up("--up", arguments.up);
    if (app.count("--fov") > 0) view.fov_y = arguments.fov * radians_per_degree;
}

/// The frames of a sequence, if one is wanted. A turntable goes around the target if one is given.
std::optional<std::vector<SequenceFrame>> sequence_frames(const DrawArguments& arguments,
                                                          const Subject& subject, glm::ivec2 size) {
    if (!arguments.sequence.given(arguments.output)) return std::nullopt;
    Axis axis = vertical_axis(subject, subject.view.up);
    if (!arguments.target.empty()) axis.point = subject.view.target;
    return arguments.sequence.frames(arguments.output, subject.view, axis, size,
                                     subject.lines.bounds, subject.origin);
}

/// Everything that can be wrong on the command line alone is found before any work starts.
void check_arguments(const DrawArguments& arguments) {
    if (arguments.model.empty() == arguments.scene.empty()) {
        throw UsageError("name either a MODEL file or a --scene");
    }
    if (arguments.repeat < 1) throw UsageError("--repeat must be at least 1");
    const bool sequence = arguments.sequence.given(arguments.output);
    if (sequence && arguments.stats) {
        throw UsageError("--stats measures one picture; leave out --turntable or --camera-path");
    }
    arguments.profile.check();
    arguments.read.check();
    arguments.paths.check(arguments.output);
    if (is_path_file(arguments.output)) return;
    check_image_path(sequence ? OutputPattern{arguments.output}.path(0)
                              : std::filesystem::path{arguments.output});
    arguments.picture.check(arguments.output);
}

/// All that `draw` draws.
struct Drawing {
    const DrawArguments& arguments;
    std::string description;
    const Subject& subject;
    glm::ivec2 size;
    const FrameOptions& options;
    const std::optional<std::vector<SequenceFrame>>& frames; ///< nothing: a single one
};

/// `draw`: how --stats draws a frame.
void draw_frames(const Drawing& drawing, FrameOutput& output, Renderer& renderer,
                 const std::function<FrameStats(const Camera&, const FrameOptions&)>& draw) {
    const DrawArguments& arguments = drawing.arguments;
    if (drawing.frames) {
        ProfiledOutput profiled{output, renderer};
        draw_sequence(*drawing.frames, profiled, arguments.sequence.resume());
        return arguments.profile.write(profiled.take(), renderer.description());
    }
    const Subject& subject = drawing.subject;
    const Camera camera = make_camera(subject.view, drawing.size, subject.lines.bounds);
    output.draw(camera, arguments.output);
    output.finish();
    if (arguments.profile.given()) {
        FrameOptions options = drawing.options;
        options.profile = true;
        // The picture's own frame has built kernels and made tables grow.
        for (int i = 0; i < arguments.repeat; ++i) {
            draw(camera, options);
            glFinish(); // a frame does not begin with a wait for the strokes of the last one
        }
        arguments.profile.write(renderer.take_profiles(), renderer.description());
    }
    if (!arguments.stats) return;
    measure_and_print({.name = subject.name,
                       .options = drawing.options,
                       .repeat = arguments.repeat,
                       .draw = [&](const FrameOptions& wanted) { return draw(camera, wanted); }},
                      renderer);
}

void draw_pictures(const Drawing& drawing, Renderer& renderer, ImageWriter& writer) {
    const PictureOptions& picture = drawing.arguments.picture;
    ImageSettings settings = picture.settings();
    settings.description = drawing.description;
    PictureOutput output{{.size = drawing.size,
                          .options = drawing.options,
                          .settings = settings,
                          .transparent = picture.transparent(),
                          .tile_size = picture.tile_size()},
                         renderer,
                         writer};
    draw_frames(drawing, output, renderer, [&](const Camera& camera, const FrameOptions& wanted) {
        return output.draw(camera, wanted);
    });
}

void draw_paths(const Drawing& drawing, Renderer& renderer) {
    const PathOptions& paths = drawing.arguments.paths;
    const Subject& subject = drawing.subject;
    SvgOptions svg = paths.svg();
    svg.title = std::filesystem::path{subject.name}.stem().string();
    svg.background = !drawing.arguments.picture.transparent();
    VectorOutput output{
        {.options = drawing.options,
         .paths = {.mesh = paths.tags() ? &subject.mesh : nullptr, .plotter = paths.plotter()},
         .svg = svg,
         .json = {.tags = paths.tags(), .description = {}, .origin = subject.origin},
         .description = drawing.description},
        subject.lines,
        renderer};
    draw_frames(drawing, output, renderer, [&](const Camera& camera, const FrameOptions& wanted) {
        return output.find(camera, wanted);
    });
}

void draw(const DrawArguments& arguments, const CLI::App& app) {
    check_arguments(arguments);
    const glm::ivec2 size = parse_size("--size", arguments.size);
    const Style style = arguments.style.style();
    FrameOptions options = frame_options(arguments, style, size);
    ImageWriter writer; // before anything starts a thread
    const std::map<std::string, Image> pen_images = arguments.read.pen_images(style);

    Subject subject = load_subject(arguments, size);
    apply_camera(arguments, app, subject);
    const std::optional<std::vector<SequenceFrame>> frames =
        sequence_frames(arguments, subject, size);
    // A frame of a sequence is the same whatever was drawn before it.
    if (frames) {
        options.steady = false;
        options.profile = arguments.profile.given();
    }

    const gl::HeadlessContext context;
    Renderer renderer{arguments.device};
    for (const auto& [mark, image] : pen_images) renderer.set_pen_image(mark, image);
    renderer.set_lines(subject.lines);
    const Drawing drawing{arguments, describe_drawing(app, arguments.model), subject, size, options,
                          frames};
    if (is_path_file(arguments.output))
        draw_paths(drawing, renderer);
    else
        draw_pictures(drawing, renderer, writer);
    if (!arguments.device.compare_with.empty()) {
        const Renderer::Comparison equal = renderer.comparison();
        fmt::print("{}: equal in {} stages, {} elements\n", renderer.description(), equal.stages,
                   equal.elements);
    }
}

} // namespace

Command setup_draw(CLI::App& app) {
    auto arguments = std::make_shared<DrawArguments>();
    DrawArguments& a = *arguments;
    app.add_option("MODEL", a.model, "OBJ, PLY, STL, OFF or OM file");
    app.add_option("-o,--output", a.output,
                   "Picture to write: PNG, JPEG, TIFF, EXR, ... or, as paths, SVG or JSON")
        ->required();

    const std::string model = "What to draw";
    app.add_option("--scene", a.scene,
                   "A built-in scene in place of MODEL: clevis, house, ship, office")
        ->group(model);
    app.add_option("--lines", a.lines,
                   "Kinds of line, separated by commas: crease, boundary, material, silhouette, "
                   "file; default all")
        ->group(model);
    app.add_option("--crease", a.crease, "Edges bent by more than this are creases, in degrees")
        ->capture_default_str()
        ->group(model);

    const std::string camera = "Camera (by default it frames the whole model)";
    app.add_option("--size", a.size, "Picture size in pixels")
        ->capture_default_str()
        ->group(camera);
    app.add_option("--eye", a.eye, "Position of the eye: X,Y,Z")->group(camera);
    app.add_option("--target", a.target, "The point looked at: X,Y,Z")->group(camera);
    app.add_option("--up", a.up, "Upward axis of the model: x, y, z or X,Y,Z; default y")
        ->group(camera);
    app.add_option("--fov", a.fov, "Vertical field of view in degrees")
        ->capture_default_str()
        ->group(camera);
    app.add_option("--at", a.at, "Position along a scene's camera path, 0 to 1")
        ->capture_default_str()
        ->group(camera);

    const std::string visibility = "Visibility";
    app.add_option("--method", a.method,
                   "How visibility is computed: atlas, spine, itembuffer or opengl")
        ->capture_default_str()
        ->group(visibility);
    app.add_option("--quality", a.quality,
                   "low: 1 probe, 1x depth; high: 9 probes, 2x depth (4x for paths)")
        ->capture_default_str()
        ->group(visibility);
    app.add_option("--probes", a.probes, "Depth probes per sample: 1, 4, 9 or 16")
        ->group(visibility);
    app.add_option("--depth-scale", a.depth_scale, "Depth texels per pixel and axis: 1 to 4")
        ->group(visibility);
    app.add_option("--step", a.step, "Pixels between visibility samples")
        ->capture_default_str()
        ->group(visibility);
    app.add_option("--atlas", a.atlas, "Where samples are computed: raster, compute or auto")
        ->capture_default_str()
        ->group(visibility);
    app.add_option("--atlas-layout", a.atlas_layout, "How rows of the atlas end: wrap or gutter")
        ->capture_default_str()
        ->group(visibility);

    app.add_option("--stroke-shader", a.stroke_shader,
                   "How strokes are widened: geometry or vertex; one picture")
        ->capture_default_str()
        ->group(visibility);

    a.style.declare(app);
    a.sequence.declare(app);
    a.picture.declare(app);
    a.paths.declare(app);
    a.read.declare(app);

    const std::string device = "Device";
    app.add_option("--compute", a.device.compute, "Backend: " + compute::backend_names())
        ->capture_default_str()
        ->group(device);
    app.add_option("--device", a.device.device,
                   "OpenCL device: opencl:<platform>[:<device>], any part of the names; see "
                   "`lineatlas devices`")
        ->group(device);
    app.add_option("--interop", a.device.interop,
                   "How buffers are shared with GL: gl-sharing, host-pointer or copy")
        ->group(device);

    app.add_option("--compare-with", a.device.compare_with,
                   "Run every compute stage on this backend or device too (reference, "
                   "opencl:...) and report the first that differs; slow")
        ->group(device);
    app.add_option("--compare-until", a.device.compare_until,
                   "The last stage to compare: pyramid, cull, facing, project_clip, scan, atlas, "
                   "temporal, intervals, compact, halo, filter or density; default all")
        ->group(device);

    const std::string measuring = "Measuring";
    app.add_flag("--stats", a.stats, "Print counts, memory and a time per stage")->group(measuring);
    a.profile.declare(app, measuring);
    app.add_option("--repeat", a.repeat,
                   "Frames to measure for --stats and --profile; medians are printed")
        ->capture_default_str()
        ->group(measuring);

    app.footer("Examples:\n"
               "  lineatlas draw chair.obj -o chair.png\n"
               "  lineatlas draw part.stl -o part.png --up z --style pencil --width 3\n"
               "  lineatlas draw house.obj -o door.png --eye 12,1.7,9 --target 0,1.5,0 --fov 60\n"
               "  lineatlas draw chair.obj -o chair.svg --page a4 --margin 10mm --plotter\n"
               "  lineatlas draw chair.obj --turntable 120 -o chair.%04d.png\n"
               "  lineatlas draw --scene office --at 0.6 -o office.png --stats --repeat 20\n"
               "  lineatlas draw --scene ship -o ship.png --profile trace.json --profile -");
    return [arguments, &app] { draw(*arguments, app); };
}

} // namespace lineatlas::apps
