#include "commands.hpp"

#include <exception>
#include <optional>
#include <utility>

#include <CLI/App.hpp>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "certifier.hpp"
#include "command_line/session_file.hpp"
#include "command_line/values.hpp"
#include "compute/kernels.hpp"
#include "core/line_pens.hpp"
#include "core/progress.hpp"
#include "core/style_lengths.hpp"
#include "description.hpp"
#include "draw_sheet.hpp"
#include "draw_stats.hpp"
#include "empty_frames.hpp"
#include "glpasses/headless_context.hpp"
#include "io/extension.hpp"
#include "io/image_writer.hpp"
#include "io/model_types.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/compute_device.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/fills.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "lineatlas/style_files.hpp"
#include "lineatlas/visibility.hpp"
#include "notes.hpp"
#include "output/picture_output.hpp"
#include "output/vector_output.hpp"
#include "output_pattern.hpp"
#include "output_places.hpp"
#include "progress.hpp"
#include "subject.hpp"
#include "vector/sheet.hpp"

namespace lineatlas::apps {
namespace {

/// The command line's settings of frames.
FrameSettings frame_settings_of(const DrawArguments& arguments) {
    FrameSettings settings;
    arguments.frame.apply(settings);
    return settings;
}

FrameOptions frame_options(const DrawArguments& arguments, const FrameSettings& settings,
                           glm::ivec2 size) {
    if (is_path_file(arguments.output)) return settings.for_paths(size);
    if (arguments.sequence.given(arguments.output)) return settings.for_sequence();
    return settings.for_pixels();
}

void check_range(std::string_view option, float value, float least, float most) {
    if (value >= least && value <= most) return; // false for NaN
    throw UsageError(fmt::format("{} must be from {} to {}, not {}", option, least, most, value));
}

/// Finds everything that is wrong on the command line alone, before any work starts.
void check_arguments(const DrawArguments& arguments, const FrameSettings& settings) {
    if (arguments.models.empty() == arguments.scene.empty()) {
        throw UsageError("name either a MODEL file or a --scene");
    }
    arguments.explode.explosion();
    if (!arguments.scene.empty() && arguments.parts.given())
        throw UsageError("--only and --hide need a MODEL file; `lineatlas scene` writes one");
    if (arguments.repeat < 1) throw UsageError("--repeat must be at least 1");
    crease_angle(arguments);
    silhouettes(arguments);
    check_range("--at", arguments.at, 0, 1);
    if (!(arguments.deflection >= 0 && arguments.deflection <= 1e15))
        throw UsageError("--deflection must be a distance above 0");
    const bool sequence = arguments.sequence.given(arguments.output);
    if (sequence && arguments.stats) {
        throw UsageError("--stats measures one picture; leave out --turntable or --camera-path");
    }
    arguments.view.check();
    arguments.sections.check(arguments.sheet.has_sections(arguments.view));
    arguments.profile.check();
    arguments.kernels.check();
    if (arguments.kernels.given() && (sequence || !arguments.device.compare_with.empty()))
        throw UsageError("--kernels measures one picture by one device; leave out --turntable, "
                         "--camera-path and --compare-with");
    arguments.read.check();
    arguments.sheet.check(arguments.view, arguments.output);
    if (arguments.view.is_sheet()) {
        arguments.paths.check_sheet(arguments.output, settings.method.value_or(Method::exact));
        if (is_path_file(arguments.output)) return;
        check_image_path(arguments.output);
        return arguments.picture.check(arguments.output);
    }
    arguments.paths.check(arguments.output, settings.method.value_or(Method::exact));
    if (is_path_file(arguments.output)) return;
    check_image_path(sequence ? OutputPattern{arguments.output}.path(0)
                              : std::filesystem::path{arguments.output});
    arguments.picture.check(arguments.output);
}

constexpr std::string_view output_option = "--output";

/// All files but the frames of a sequence.
OutputPlaces output_places(const DrawArguments& arguments,
                           const std::map<std::string, Image>& pen_images) {
    OutputPlaces places;
    places.reads(arguments.session);
    for (const std::filesystem::path& model : arguments.models) places.reads(model);
    places.reads(arguments.style.name());
    places.reads(arguments.sequence.camera_path());
    for (const auto& [file, image] : pen_images) places.reads(file);
    if (!arguments.sequence.given(arguments.output)) places.writes(output_option, arguments.output);
    arguments.profile.add_to(places);
    arguments.kernels.add_to(places);
    return places;
}

/// Everything that `draw` draws.
struct Drawing {
    const DrawArguments& arguments;
    std::string description;
    const Subject& subject;
    glm::ivec2 size;
    const FrameOptions& options;
    const std::optional<std::vector<SequenceFrame>>& frames; ///< nothing: a single frame
};

/// How frames are measured: the renderer that draws them, and its options for --stats.
struct Measuring {
    Renderer& renderer;
    std::function<FrameStats(const Camera&, const FrameOptions&)> draw;
};

/// `stage`: says that a single picture is being drawn; nullptr: nothing does.
void draw_frames(const Drawing& drawing, FrameOutput& to, const Measuring* measuring = nullptr,
                 StageLine* stage = nullptr) {
    const DrawArguments& arguments = drawing.arguments;
    EmptyFrames output{to, drawing.subject.lines,
                       drawn_kinds(drawing.options.lines, drawing.options.style)};
    const auto say_if_empty = [&] {
        if (const std::string report = output.report(); !report.empty())
            print_error(fmt::format("lineatlas: {}\n", report));
        if (const std::string note = to.note(); !note.empty()) print_notes({note});
    };
    if (drawing.frames) {
        if (measuring == nullptr) {
            draw_sequence(*drawing.frames, output, arguments.sequence.resume());
            return say_if_empty();
        }
        ProfiledOutput profiled{output, measuring->renderer};
        draw_sequence(*drawing.frames, profiled, arguments.sequence.resume());
        say_if_empty();
        return arguments.profile.write(profiled.take(), measuring->renderer.description(), {});
    }
    const Subject& subject = drawing.subject;
    const Camera camera = make_camera(subject.view, drawing.size, subject.lines.bounds);
    output.draw(camera, arguments.output);
    output.finish();
    if (stage != nullptr) stage->clear();
    say_if_empty();
    if (measuring == nullptr) return;
    Renderer& renderer = measuring->renderer;
    std::vector<FrameProfile> profiles;
    if (arguments.profiled()) {
        FrameOptions options = drawing.options;
        options.profile = true;
        // The frame of the picture has already built kernels and made tables grow.
        for (int i = 0; i < arguments.repeat; ++i) {
            measuring->draw(camera, options);
            glFinish(); // so that the next frame does not wait for the strokes of this one
        }
        profiles = renderer.take_profiles();
    }
    const std::string description = renderer.description();
    if (arguments.stats) {
        measure_and_print(
            {.name = subject.name,
             .lines = subject.lines,
             .options = drawing.options,
             .repeat = arguments.repeat,
             .draw = [&](const FrameOptions& wanted) { return measuring->draw(camera, wanted); }},
            renderer);
    }
    KernelReport report;
    std::exception_ptr failure;
    if (arguments.kernels.given()) {
        const auto draw = [&](const StageForms& forms) {
            FrameOptions options = drawing.options;
            options.forms = forms;
            measuring->draw(camera, options);
        };
        try {
            report = KernelOptions::measure(profiles, drawing.options.forms, renderer, draw);
        } catch (...) {
            failure = std::current_exception(); // the profile does without
        }
    }
    arguments.profile.write(profiles, description, report.kernels);
    if (failure) std::rethrow_exception(failure);
    arguments.kernels.write(report);
}

void draw_pictures(const Drawing& drawing, Renderer& renderer, ImageWriter& writer) {
    const PictureOptions& picture = drawing.arguments.picture;
    ImageSettings settings = picture.settings();
    settings.description = drawing.description;
    PictureOutput output{
        {.size = drawing.size,
         .options = drawing.options,
         .settings = settings,
         .transparent = picture.transparent(),
         .tile_size = picture.tile_size(),
         .note =
             [](const std::string& note) { print_error(fmt::format("lineatlas: {}\n", note)); }},
        renderer,
        writer};
    const Measuring measuring{renderer, [&](const Camera& camera, const FrameOptions& wanted) {
                                  return output.draw(camera, wanted);
                              }};
    draw_frames(drawing, output, &measuring);
}

/// Draws paths from the intervals that `find` returns. `stage`: that of draw_frames().
void draw_paths(const Drawing& drawing, const FindLines& find, const Measuring* measuring,
                StageLine* stage = nullptr) {
    const PathOptions& paths = drawing.arguments.paths;
    const Subject& subject = drawing.subject;
    SvgOptions svg = paths.svg();
    svg.title = std::filesystem::path{subject.name}.stem().string();
    svg.background = !drawing.arguments.picture.transparent();
    std::optional<Certifier> certifier;
    if (paths.certify()) certifier.emplace(subject.mesh, subject.lines, subject.line_options);
    VectorFrame frame{.style = drawing.options.style,
                      .paths = {.mesh = &subject.mesh, .plotter = paths.plotter()},
                      .svg = svg,
                      .json = {.tags = paths.tags(), .description = {}, .origin = subject.origin},
                      .description = drawing.description};
    if (certifier) {
        frame.certify = [&](const auto& drawn, const auto& camera, const auto& path) {
            return certifier->check(drawn, camera, path);
        };
    }
    VectorOutput output{std::move(frame), subject.lines, find};
    draw_frames(drawing, output, measuring, stage);
}

/// Under the lines; a plotter draws none.
std::vector<VectorFill> fills_of(const Drawing& drawing, const Camera& camera) {
    if (drawing.arguments.paths.plotter()) return {};
    DeviceOptions device = drawing.arguments.device;
    device.interop.clear();
    return find_fills(drawing.subject.lines, camera, drawing.options.style.fill, device);
}

void draw_paths(const Drawing& drawing, Renderer& renderer) {
    const auto draw = [&](const Camera& camera, const FrameOptions& wanted) {
        FrameOptions options = wanted;
        options.intervals = KeptIntervals::all;
        options.draw = false;
        return renderer.draw(camera, options, 0);
    };
    const auto find = [&](const Camera& camera) -> SeenLines {
        draw(camera, drawing.options);
        return {renderer.read_intervals(), renderer.read_outlines(), fills_of(drawing, camera)};
    };
    const Measuring measuring{renderer, [&](const Camera& camera, const FrameOptions& wanted) {
                                  const FrameStats stats = draw(camera, wanted);
                                  renderer.read_intervals();
                                  return stats;
                              }};
    draw_paths(drawing, find, &measuring);
}

/// Whether GL is not needed. It is not for exact paths, unless they are measured or compared or
/// share buffers.
bool needs_no_gl(const DrawArguments& arguments, const FrameOptions& options) {
    return is_path_file(arguments.output) && options.method == Method::exact && !arguments.stats &&
           !arguments.profiled() && arguments.device.interop.empty() &&
           arguments.device.compare_with.empty();
}

void say(const std::string& note) {
    if (!note.empty()) print_error(fmt::format("lineatlas: {}\n", note));
}

/// The share of finding what is visible in the drawing of a picture; the rest makes paths of it.
constexpr float share_of_finding = 0.6F;

void draw_without_gl(const Drawing& drawing) {
    std::optional<StageLine> stage;
    if (!drawing.frames) stage.emplace("drawing");
    const lineatlas::Progress progress = stage ? stage->progress() : lineatlas::Progress{};
    DeviceOptions device = drawing.arguments.device;
    device.one_picture = !drawing.frames;
    LineVisibility visibility{drawing.subject.lines, device};
    VisibilityOptions wanted{.lines = drawn_kinds(drawing.options.lines, drawing.options.style),
                             .hidden = true,
                             .step = drawing.options.step,
                             .outlines = tells_outlines(drawing.options.style)};
    const auto find = [&](const Camera& camera) -> SeenLines {
        wanted.outline_depth = outline_depth(drawing.options.style, camera.size);
        wanted.centre_overhang = centre_overhang(drawing.options.style, camera.size);
        std::vector<Interval> intervals =
            visibility.find(camera, wanted, part_of(progress, 0, share_of_finding));
        return {std::move(intervals), visibility.outlines(), fills_of(drawing, camera)};
    };
    draw_paths(drawing, find, nullptr, stage ? &*stage : nullptr);
}

/// Takes settings of a session that the command line does not give. Throws Error.
void take_session(DrawArguments& arguments, CLI::App& app) {
    arguments.session = arguments.model;
    const SessionFile session = read_session(arguments.session);
    const auto give = [&](const std::string& key, const std::vector<std::string>& values) {
        CLI::Option* option = app.get_option("--" + key);
        if (option->count() > 0) return;
        for (const std::string& value : values) option->add_result(value);
        option->run_callback();
    };
    arguments.models = session.models;
    if (arguments.scene.empty()) arguments.scene = session.scene;
    arguments.style.set_usual(session.style);
    for (const SessionFile::Option& option : session.options) give(option.key, option.values);
    if (session.views.empty() || arguments.view.says_direction()) return;
    const SessionFile::NamedView& view = session.views.front();
    const auto vector = [](glm::dvec3 v) {
        return fmt::format("{},{},{}", shortest(v.x), shortest(v.y), shortest(v.z));
    };
    give("eye", {vector(view.eye)});
    give("target", {vector(view.target)});
    give("up", {vector(view.up)});
    give("projection", {std::string{name_of(view.projection)}});
    if (!arguments.view.to_scale()) give("fov", {fmt::format("{}", view.fov)});
}

/// Frees the mesh, if no paths name the parts of it that they show.
void forget_sources(Subject& subject) {
    subject.mesh = {};
    subject.framed = std::vector<glm::vec3>{};
    subject.lines.sources = std::vector<LineSource>{};
    for (auto* sources : {&subject.lines.vertex_sources, &subject.lines.triangle_sources})
        *sources = std::vector<std::uint32_t>{};
}

void draw(const DrawArguments& arguments, const CLI::App& app) {
    const FrameSettings settings = frame_settings_of(arguments);
    check_arguments(arguments, settings);
    if (arguments.view.is_sheet()) return draw_sheet(arguments, app);
    const glm::ivec2 size = picture_size(arguments);
    const bool by_paths = is_path_file(arguments.output);
    const Style given = arguments.style.style();
    const Style style = by_paths ? arguments.paths.on_paper(given, size) : given;
    FrameOptions options = frame_options(arguments, settings, size);
    // Paths need no writer and none of its libraries.
    std::optional<ImageWriter> writer;
    if (!by_paths) writer.emplace(arguments.output); // made before anything starts a thread
    const std::map<std::string, Image> pen_images = arguments.read.pen_images(style);
    const OutputPlaces places = output_places(arguments, pen_images);

    auto [subject, frames] = find_pictures(arguments, drawn_kinds(options.lines, style), size);
    options.style = about_origin(style, subject.origin);
    print_notes(subject.notes);
    if (!style.pens.empty()) print_notes(idle_rules(line_classes(subject.lines), style));
    if (!by_paths) forget_sources(subject);
    const bool measured = arguments.stats || arguments.profiled();
    // Frames of a sequence must not depend on the frames before, and a single frame has none
    // before.
    options.steady = !frames && measured;
    if (frames) {
        for (const SequenceFrame& frame : *frames) places.check(output_option, frame.path);
        options.profile = arguments.profile.given();
    }

    const Drawing drawing{
        arguments,
        describe_drawing(app, arguments.session.empty() ? arguments.model : arguments.session,
                         subject.sections, subject.deflection,
                         drawn_kinds(options.lines, options.style)),
        subject,
        size,
        options,
        frames};
    if (needs_no_gl(arguments, options)) return draw_without_gl(drawing);
    const gl::HeadlessContext context;
    DeviceOptions device = arguments.device;
    device.one_picture = !frames && !measured;
    Renderer renderer{device};
    const std::string note = renderer.note();
    say(note);
    for (const auto& [mark, image] : pen_images) renderer.set_pen_image(mark, image);
    renderer.set_lines(subject.lines);
    if (by_paths)
        draw_paths(drawing, renderer);
    else
        draw_pictures(drawing, renderer, *writer);
    if (renderer.note() != note)
        say(renderer.note()); // another device took over, because one did
                              // not build a kernel
    if (!arguments.device.compare_with.empty()) {
        const Renderer::Comparison equal = renderer.comparison();
        print_output(fmt::format("{}: equal in {} kernels, {} elements\n", renderer.description(),
                                 equal.kernels, equal.elements));
    }
}

} // namespace

Command setup_draw(CLI::App& app) {
    auto arguments = std::make_shared<DrawArguments>();
    DrawArguments& a = *arguments;
    app.add_option("MODEL", a.model,
                   model_type_names() + " file, or a session of the viewer (TOML), whose values "
                                        "options here override");
    app.add_option(
           "-o,--output", a.output,
           "Picture to write: PNG, JPEG, TIFF, EXR, ... or, as paths, SVG, PDF, DXF or JSON")
        ->required();

    const std::string model = "What to draw";
    app.add_option(
           "--scene", a.scene,
           fmt::format("A built-in scene in place of MODEL: {}", fmt::join(scene_names(), ", ")))
        ->group(model);
    app.add_option("--crease", a.crease,
                   "Edges bent by more degrees than this are creases; auto: by more than 28.8, "
                   "except noise of scanned or sculpted surfaces, and seams")
        ->capture_default_str()
        ->group(model);
    app.add_option("--silhouettes", a.silhouettes,
                   "smooth: through triangles, where normals between their corners are at a right "
                   "angle to the view, by the methods exact and atlas; mesh: along edges; auto: "
                   "smooth on scanned and sculpted surfaces and on those of STEP, IGES and BREP "
                   "files, else along edges; default auto")
        ->group(model);
    a.sections.declare(app, model);

    app.add_option(
           "--deflection", a.deflection,
           "How far chords may be off the curved faces of STEP, IGES and BREP files, in mm; by "
           "default a quarter of a pixel")
        ->group(model);
    app.add_flag("--smooth-edges", a.smooth_edges,
                 "With STEP, IGES and BREP files also draw edges where faces meet smoothly")
        ->group(model);
    a.parts.declare(app, model);
    a.explode.declare(app, model);

    const std::string camera = "Camera (by default it frames the whole model)";
    app.add_option(
           "--size", a.size,
           "Picture size in pixels; unless it is given, paths to scale on paper larger than A4 "
           "have a multiple of the default")
        ->capture_default_str()
        ->group(camera);
    a.view.declare(app, camera);
    app.add_option("--at", a.at, "Position along a scene's camera path, 0 to 1")
        ->capture_default_str()
        ->group(camera);

    a.frame.declare(app, frame_settings(), FrameSettings{}, "Lines and visibility");
    a.style.declare(app);
    a.sequence.declare(app);
    a.picture.declare(app);
    a.paths.declare(app);
    a.sheet.declare(app);
    a.read.declare(app);

    const std::string device = "Device";
    declare_device(app, a.device, device);
    app.add_option("--compare-with", a.device.compare_with,
                   "Run every compute stage on this backend or device too (cpp, "
                   "opencl:...) and report the first that differs; slow")
        ->group(device);
    app.add_option("--compare-until", a.device.compare_until,
                   fmt::format("The last stage to compare, of {}; default all",
                               fmt::join(compute::stage_names(), ", ")))
        ->group(device);

    const std::string measuring = "Measuring";
    app.add_flag("--stats", a.stats, "Print counts, memory and a time per stage")->group(measuring);
    a.profile.declare(app, measuring);
    a.kernels.declare(app, measuring);
    for (const char* form : {"--atlas", "--depth", "--strokes"})
        app.get_option(form)->group(measuring);
    app.add_option(
           "--repeat", a.repeat,
           "Frames to measure for --stats, --profile and --kernels; medians are printed. With "
           "--stats every other frame is drawn whole, the others with a wait after each stage")
        ->capture_default_str()
        ->group(measuring);

    app.footer("Examples:\n"
               "  lineatlas draw chair.obj -o chair.png\n"
               "  lineatlas draw part.stl -o part.png --up z --style pencil --width 3\n"
               "  lineatlas draw house.obj -o door.png --eye 12,1.7,9 --target 0,1.5,0 --fov 60\n"
               "  lineatlas draw chair.obj -o chair.svg --page a4 --margin 10mm --plotter\n"
               "  lineatlas draw bracket.stl -o front.dxf --view front --scale 1:2 --page a4\n"
               "  lineatlas draw part.step -o sheet.pdf --views front,top,right,isometric\n"
               "  lineatlas draw chair.obj --turntable 120 -o chair.%04d.png\n"
               "  lineatlas draw --scene office --at 0.6 -o office.png --stats --repeat 20\n"
               "  lineatlas draw --scene ship -o ship.png --profile trace.json --profile -");
    return [arguments, &app] {
        if (arguments->view.is_sheet()) arguments->style.set_usual(load_style(sheet_style));
        if (lower_extension(arguments->model) == ".toml")
            take_session(*arguments, app);
        else if (!arguments->model.empty())
            arguments->models = {arguments->model};
        draw(*arguments, app);
    };
}

} // namespace lineatlas::apps
