#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "base/numbers.hpp"
#include "command_line/part_filter.hpp"
#include "command_line/read_options.hpp"
#include "command_line/values.hpp"
#include "commands.hpp"
#include "explode_options.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "section_options.hpp"
#include "style/frame_settings.hpp"
#include "truth/drawing_file.hpp"
#include "truth/model_truth.hpp"

namespace lineatlas::apps {
namespace {

constexpr float radians_per_degree = std::numbers::pi_v<float> / 180;
constexpr int picture_scale = 2;

struct CheckArguments {
    std::string drawing, model, picture;
    std::size_t worst = 5;
    std::optional<double> at_most;
    std::optional<std::size_t> paths;
    ReadOptions read;
};

/// How a drawing was made.
struct Making {
    View view;
    LineOptions lines;
    SectionOptions sections;
};

float parse_degrees(const std::string& text) {
    const std::optional<float> value = number_from<float>(text);
    if (!value) throw UsageError("\"" + text + "\" is no angle");
    return *value * radians_per_degree;
}

/// The options with which the model's file is read.
LoadOptions load_options(const DrawingFile& drawing) {
    LoadOptions options;
    if (const auto deflection = described(drawing.description, "--deflection"))
        options.deflection = number_from(*deflection).value_or(options.deflection);
    return options;
}

/// Returns the result of `use`, which parses values of the drawing. Throws FileError if a value is
/// none that an option takes.
template <typename Use>
auto said_by(const std::string& path, const Use& use) {
    try {
        return use();
    } catch (const UsageError& error) {
        throw FileError("cannot check \"" + path + "\": " + error.what() +
                        "; draw it again by `lineatlas draw`");
    }
}

/// `origin`: that of the model, in its file's coordinates. Throws FileError if the drawing does not
/// say how it was made.
Making making_of(const DrawingFile& drawing, const std::string& path, glm::dvec3 origin) {
    const auto given = [&](const char* option) {
        const auto value = described(drawing.description, option);
        if (!value) throw UsageError(std::string{"it does not say "} + option);
        return *value;
    };
    return said_by(path, [&] {
        Making making{.view = {.eye = parse_point("--eye", given("--eye")) - origin,
                               .target = parse_point("--target", given("--target")) - origin,
                               .up = parse_up("--up", given("--up")),
                               .fov_y = parse_degrees(given("--fov"))},
                      .lines = {.lines = usual_line_kinds},
                      .sections = {}};
        if (const auto projection = described(drawing.description, "--projection"))
            making.view.projection = parse_projection(*projection);
        if (const auto crease = described(drawing.description, "--crease"))
            making.lines.crease = parse_crease("--crease", *crease);
        if (const auto kinds = described(drawing.description, "--lines")) {
            const std::optional<LineKindMask> known = line_kinds_from(*kinds);
            if (!known) throw UsageError("--lines \"" + *kinds + "\" is unknown");
            making.lines.lines = *known;
        }
        if (const auto silhouettes = described(drawing.description, "--silhouettes"))
            making.lines.silhouettes = parse_silhouettes("--silhouettes", *silhouettes);
        making.lines.smooth_edges = described(drawing.description, "--smooth-edges") == "true";
        making.sections = {all_described(drawing.description, "--section"),
                           described(drawing.description, "--hatching").value_or(""),
                           all_described(drawing.description, "--uncut")};
        return making;
    });
}

/// Throws Error with everything in which a drawing is worse than --at-most and --paths allow.
void hold_to(const CheckArguments& arguments, const Certificate& certificate) {
    std::vector<std::string> faults;
    const DrawingErrors& errors = certificate.narrow;
    for (const auto& [what, share] :
         {std::pair{"missed", errors.missed_share()}, std::pair{"false", errors.false_share()}}) {
        if (arguments.at_most && 100 * share > *arguments.at_most)
            faults.push_back(
                fmt::format("{:.4f} % is {} within {:g} pixels, more than --at-most {:g}",
                            100 * share, what, errors.reach, *arguments.at_most));
    }
    if (arguments.paths && *arguments.paths != certificate.paths)
        faults.push_back(fmt::format("it has {} visible paths, not the {} of --paths",
                                     certificate.paths, *arguments.paths));
    if (!faults.empty())
        throw Error(fmt::format("\"{}\": {}", arguments.drawing, fmt::join(faults, "; ")));
}

void check(const CheckArguments& arguments) {
    arguments.read.check();
    if (!arguments.picture.empty()) check_image_path(arguments.picture);
    check_ray_module();
    const DrawingFile drawing = read_drawing(arguments.drawing);
    LoadedMesh loaded =
        load_mesh_isolated(arguments.model, arguments.read.limits(), load_options(drawing));
    // In the order of `draw`: parts, then cuts, then lines.
    said_by(arguments.drawing, [&] {
        const PartFilter parts{all_described(drawing.description, "--only"),
                               all_described(drawing.description, "--hide")};
        parts.apply(loaded);
        ExplodeOptions{all_described(drawing.description, "--explode")}.apply(loaded);
    });
    Mesh& mesh = loaded.mesh;
    const Making making = making_of(drawing, arguments.drawing, loaded.origin);
    if (making.sections.given()) {
        mesh = said_by(arguments.drawing, [&] {
            return std::move(making.sections.cut(mesh, loaded.origin, making.view).mesh);
        });
    }
    const LineSet lines = extract_lines(mesh, making.lines);
    const Camera camera = make_camera(making.view, drawing.size, lines.bounds);

    const ModelTruth model{mesh, lines, making.lines};
    const EdgeTruth truth = model.seen(camera);
    const DrawnLines drawn = find_segments(drawing, lines);
    const Certificate certificate = model.certify(truth, camera, drawn);
    print_output(certificate_table(certificate, arguments.worst));
    if (!arguments.picture.empty())
        write_image(arguments.picture,
                    error_picture(truth, drawn.legs, certificate.narrow, picture_scale));
    std::fflush(stdout); // messages about the result come after it
    hold_to(arguments, certificate);
}

} // namespace

Command setup_check(CLI::App& app) {
    auto arguments = std::make_shared<CheckArguments>();
    CheckArguments& a = *arguments;
    app.add_option("DRAWING", a.drawing, "What `lineatlas draw` wrote: SVG or JSON")->required();
    app.add_option("MODEL", a.model, "The model that it was drawn of")->required();
    app.add_option("-o,--output", a.picture,
                   "Picture of the errors to write: false lines red, missed ones blue");
    app.add_option("--worst", a.worst, "Places of each kind of error to list")
        ->capture_default_str();
    app.add_option(
           "--at-most", a.at_most,
           "Fail (exit code 1) where more than this is missed or false within 0.5 pixels, in "
           "% of what is visible")
        ->check(CLI::Range(0.0, 100.0));
    app.add_option(
           "--paths", a.paths,
           "Fail (exit code 1) unless the drawing has so many visible paths, a number known by "
           "hand: a sphere has one")
        ->check(CLI::Range(0, 1'000'000'000));
    a.read.declare(app);
    app.footer("Rays are cast from the eye to every quarter of a pixel of every line of the model, "
               "and the\ndrawing is compared with what they say. Camera and lines are those that "
               "the drawing names.\nHalos, overshoot and short lines left out count as errors.\n"
               "Example:\n"
               "  lineatlas check drawing.svg model.obj -o errors.png");
    return [arguments] { check(*arguments); };
}

} // namespace lineatlas::apps
