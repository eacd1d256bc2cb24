#include "subject.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "command_line/joined_models.hpp"
#include "command_line/values.hpp"
#include "core/far_part.hpp"
#include "core/up_axis.hpp"
#include "curve_fineness.hpp"
#include "io/model_types.hpp"
#include "io/odd_triangles.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/scenes.hpp"
#include "model_info.hpp"
#include "output/vector_output.hpp"
#include "progress.hpp"
#include "style/frame_settings.hpp"
#include "vector/sheet.hpp"

namespace lineatlas::apps {

Silhouettes silhouettes(const DrawArguments& arguments) {
    return arguments.silhouettes.empty()
               ? LineOptions{}.silhouettes
               : parse_silhouettes("--silhouettes", arguments.silhouettes);
}

std::optional<float> crease_angle(const DrawArguments& arguments) {
    return parse_crease("--crease", arguments.crease);
}

double millimetres_per_pixel(const DrawArguments& arguments, glm::ivec2 size) {
    if (is_path_file(arguments.output)) {
        const SvgOptions svg = arguments.paths.svg();
        return length_in({lay_out(size, svg).scale, svg.units}, Unit::mm);
    }
    const auto dpi = static_cast<double>(arguments.picture.settings().dpi);
    if (dpi == 0) throw UsageError("--scale: a picture of pixels needs --dpi");
    return length_in({1 / dpi, Unit::in}, Unit::mm);
}

glm::ivec2 picture_size(const DrawArguments& arguments) {
    const glm::ivec2 size = parse_size("--size", arguments.size);
    if (arguments.size != DrawArguments{}.size || !arguments.view.to_scale() ||
        !is_path_file(arguments.output))
        return size;
    constexpr double coarsest = 0.3; // millimetres to a pixel; A4 has 0.27
    constexpr double most_times = 16;
    const double times = std::ceil(millimetres_per_pixel(arguments, size) / coarsest);
    return size * static_cast<int>(std::clamp(times, 1.0, most_times));
}

namespace {

Axis vertical_axis(const Subject& subject, glm::vec3 up) {
    return {.point = 0.5F * (subject.lines.bounds.min + subject.lines.bounds.max),
            .direction = glm::normalize(up)};
}

/// The upward axis: that of the options, that of the file, or a guess from the shape. A note says
/// so if the guess is not y.
glm::vec3 up_of(const DrawArguments& arguments, const Mesh& mesh, std::optional<glm::vec3> of_file,
                std::vector<std::string>& notes) {
    if (arguments.view.says_up()) return arguments.view.up({});
    if (of_file) return *of_file;
    const glm::vec3 up = guess_up(mesh, usual_up(arguments.models.front()));
    const bool matters = !arguments.view.places_eye() && arguments.sequence.camera_path().empty();
    if (up.z > 0 && matters) notes.push_back("z is taken as upwards; --up y takes y");
    return up;
}

/// Cuts the model as --section says. Returns the planes.
std::vector<std::string> cut(const DrawArguments& arguments, Mesh& mesh, glm::dvec3 origin,
                             View view, std::vector<std::string>& notes) {
    if (!arguments.sections.given()) return {};
    arguments.view.apply(view, origin, false);
    std::vector<std::string> planes = arguments.sections.with_sides(mesh, origin, view);
    Section section = arguments.sections.cut(mesh, origin, view);
    mesh = std::move(section.mesh);
    std::ranges::move(section.notes, std::back_inserter(notes));
    return planes;
}

std::string framing_note(const FarPart& far, glm::dvec3 origin) {
    if (is_left_out(far)) return note_of(far);
    const glm::dvec3 middle = 0.5 * (glm::dvec3{far.rest.min} + glm::dvec3{far.rest.max}) + origin;
    return fmt::format("{}; --eye and --target show the others, about {:.7g},{:.7g},{:.7g}",
                       note_of(far), middle.x, middle.y, middle.z);
}

/// About the pixels that the model's diagonal takes. In perspective near things are drawn larger;
/// compact parts that fill the picture took 1.8 to 2.2 times its shorter side. A guess that is too
/// small costs a second reading. So there is room for a model that is drawn a tenth larger, which
/// costs a twentieth more chords.
double pixels_of_diagonal(const ViewOptions& view, glm::ivec2 size) {
    constexpr double nearest = 2.25, room = 1.1;
    const double whole = glm::length(glm::dvec2{size});
    if (view.projection() == Projection::orthographic) return room * whole;
    return room * std::max(whole, nearest * std::min(size.x, size.y));
}

LineSet find_lines(const Mesh& mesh, const LineOptions& options) {
    StageLine line{"finding lines"};
    return extract_lines(mesh, options, line.progress());
}

/// `deflection`: that of exact surfaces; 0: by the size of the picture.
LoadedMesh read_models(const DrawArguments& arguments, glm::ivec2 size, double deflection) {
    const StageLine line{"reading " + arguments.models.front().filename().string()};
    return load_models_isolated(
        arguments.models, arguments.read.limits(),
        {.deflection = deflection, .pixels = pixels_of_diagonal(arguments.view, size)});
}

/// `deflection`: as in read_models().
Subject load_subject(const DrawArguments& arguments, LineKindMask kinds, glm::ivec2 size,
                     double deflection) {
    const LineOptions options{.lines = kinds,
                              .crease = crease_angle(arguments),
                              .smooth_edges = arguments.smooth_edges,
                              .silhouettes = silhouettes(arguments)};
    if (!arguments.scene.empty()) {
        Scene scene = make_scene(arguments.scene);
        LoadedMesh apart{.mesh = std::move(scene.mesh), .notes = {}};
        arguments.explode.apply(apart);
        scene.mesh = std::move(apart.mesh);
        std::vector<std::string> notes;
        const View whole =
            arguments.view.says_direction()
                ? arguments.view.framed(scene.mesh.positions, size, arguments.view.up({0, 1, 0}))
                : scene.view(arguments.at);
        std::vector<std::string> sections = cut(arguments, scene.mesh, {}, whole, notes);
        LineSet lines = find_lines(scene.mesh, options);
        const bool framed = arguments.view.says_direction() || arguments.view.to_scale();
        const glm::vec3 up = arguments.view.up({0, 1, 0});
        const View view =
            framed ? arguments.view.framed(lines.vertices, size, up) : scene.view(arguments.at);
        std::vector<glm::vec3> points = lines.vertices;
        nlohmann::ordered_json summary;
        std::vector<std::uint32_t> items;
        if (arguments.sheet.wants_summary(arguments.view)) {
            const LoadedMesh loaded{
                .mesh = scene.mesh, .notes = notes, .format = "scene", .up = up};
            summary = describe_model(scene.name, loaded, lines);
            items = item_numbers(loaded);
        }
        return {.name = scene.name,
                .mesh = std::move(scene.mesh),
                .lines = std::move(lines),
                .line_options = options,
                .framed = std::move(points),
                .view = view,
                .up = up,
                .sections = std::move(sections),
                .notes = std::move(notes),
                .summary = std::move(summary),
                .items = std::move(items)};
    }
    LoadedMesh loaded = read_models(arguments, size, deflection);
    arguments.parts.apply(loaded);
    const glm::vec3 up = up_of(arguments, loaded.mesh, loaded.up, loaded.notes);
    arguments.explode.apply(loaded);
    std::vector<std::string> sections =
        cut(arguments, loaded.mesh, loaded.origin,
            arguments.view.framed(loaded.mesh.positions, size, up), loaded.notes);
    LineSet lines = find_lines(loaded.mesh, options);
    nlohmann::ordered_json summary;
    std::vector<std::uint32_t> items;
    if (arguments.sheet.wants_summary(arguments.view)) {
        summary = describe_model(arguments.models.front().string(), loaded, lines);
        items = item_numbers(loaded);
    }
    Subject subject{.name = arguments.models.front().string(),
                    .mesh = std::move(loaded.mesh),
                    .lines = std::move(lines),
                    .line_options = options,
                    .framed = {},
                    .view = {},
                    .up = up,
                    .origin = loaded.origin,
                    .unit = loaded.unit,
                    .sections = std::move(sections),
                    .deflection = loaded.deflection,
                    .summary = std::move(summary),
                    .items = std::move(items)};
    add_notes(subject.lines.odd, loaded.notes);
    const std::optional<FarPart> far = find_far_part(subject.lines);
    const bool frames = !arguments.view.places_eye() && arguments.sequence.camera_path().empty();
    if (far && frames) loaded.notes.push_back(framing_note(*far, loaded.origin));
    subject.notes = std::move(loaded.notes);
    subject.framed = points_to_frame(subject.lines, far);
    const std::vector<glm::vec3>& points = subject.framed;
    subject.view =
        arguments.view.framed(arguments.sequence.turns() ? swept(points, vertical_axis(subject, up))
                                                         : std::span<const glm::vec3>{points},
                              size, up);
    return subject;
}

void apply_camera(const DrawArguments& arguments, Subject& subject, glm::ivec2 size) {
    const bool up_is_guessed =
        arguments.scene.empty() && !arguments.view.says_up() && !arguments.sequence.turns();
    arguments.view.apply(subject.view, subject.origin, up_is_guessed);
    if (!arguments.view.to_scale()) return;
    subject.view = arguments.view.scaled(subject.view, millimetres_per_pixel(arguments, size), size,
                                         subject.framed, subject.unit);
}

/// The frames of a sequence, if one is wanted. A turntable goes around the target if a target is
/// given.
std::optional<std::vector<SequenceFrame>> sequence_frames(const DrawArguments& arguments,
                                                          const Subject& subject, glm::ivec2 size) {
    if (!arguments.sequence.given(arguments.output)) return std::nullopt;
    Axis axis = vertical_axis(subject, subject.view.up);
    if (arguments.view.says_target()) axis.point = subject.view.target;
    return arguments.sequence.frames(arguments.output, subject.view, axis, size,
                                     subject.lines.bounds, subject.origin);
}

Pictures find_pictures_at(const DrawArguments& arguments, LineKindMask kinds, glm::ivec2 size,
                          double deflection) {
    Pictures pictures{load_subject(arguments, kinds, size, deflection), {}};
    apply_camera(arguments, pictures.subject, size);
    pictures.frames = sequence_frames(arguments, pictures.subject, size);
    return pictures;
}

SheetLayout sheet_of(const DrawArguments& arguments, const Subject& subject) {
    return lay_out_sheet(subject.framed,
                         arguments.sheet.options(arguments.view, arguments.paths.svg().page,
                                                 subject.name, subject.unit, subject.up,
                                                 subject.origin));
}

/// About the pixels that the largest view of a sheet takes.
glm::ivec2 pixels_of_view(const DrawArguments& arguments) {
    constexpr double share_of_page = 0.5, pixels_per_millimetre = 10;
    const Page page = arguments.paths.svg().page.value_or(SheetOptions{}.page);
    return glm::ivec2{
        share_of_page * pixels_per_millimetre *
        glm::dvec2{length_in(page.width, Unit::mm), length_in(page.height, Unit::mm)}};
}

SheetSubject find_sheet_at(const DrawArguments& arguments, LineKindMask kinds, double deflection) {
    Subject subject = load_subject(arguments, kinds, pixels_of_view(arguments), deflection);
    SheetLayout layout = sheet_of(arguments, subject);
    return {std::move(subject), std::move(layout)};
}

/// Reads the model again if its curved faces are too coarse for these pictures. `read` reads it
/// with a deflection.
template <class Found, class Read>
Found fine_enough(const DrawArguments& arguments, Found found, std::span<const Camera> cameras,
                  const Read& read) {
    const Subject& subject = found.subject;
    if (arguments.deflection > 0 || subject.deflection == 0) return found;
    std::string note;
    const std::optional<double> finer =
        finer_deflection(subject.mesh, cameras, subject.deflection, note);
    if (finer) found = read(*finer);
    if (!note.empty()) found.subject.notes.push_back(note);
    return found;
}

} // namespace

Pictures find_pictures(const DrawArguments& arguments, LineKindMask kinds, glm::ivec2 size) {
    const auto read = [&](double deflection) {
        return find_pictures_at(arguments, kinds, size, deflection);
    };
    Pictures pictures = read(arguments.deflection);
    const Subject& subject = pictures.subject;
    std::vector<Camera> cameras;
    if (pictures.frames) {
        for (const SequenceFrame& frame : *pictures.frames) cameras.push_back(frame.camera);
    } else {
        cameras.push_back(make_camera(subject.view, size, subject.lines.bounds));
    }
    return fine_enough(arguments, std::move(pictures), cameras, read);
}

SheetSubject find_sheet(const DrawArguments& arguments, LineKindMask kinds) {
    const auto read = [&](double deflection) {
        return find_sheet_at(arguments, kinds, deflection);
    };
    SheetSubject sheet = read(arguments.deflection);
    std::vector<Camera> cameras;
    for (const SheetView& view : sheet.layout.views) cameras.push_back(view.camera);
    return fine_enough(arguments, std::move(sheet), cameras, read);
}

} // namespace lineatlas::apps
