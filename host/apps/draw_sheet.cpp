#include "draw_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "core/empty_drawing.hpp"
#include "core/line_pens.hpp"
#include "description.hpp"
#include "flags.h"
#include "io/standard_streams.hpp"
#include "lineatlas/fills.hpp"
#include "lineatlas/section.hpp"
#include "lineatlas/visibility.hpp"
#include "notes.hpp"
#include "output/sheet_output.hpp"
#include "output/vector_output.hpp"
#include "output_places.hpp"
#include "subject.hpp"

namespace lineatlas::apps {
namespace {

using Json = nlohmann::ordered_json;

/// Coordinates to a thousandth of a millimetre.
Json list(glm::dvec2 v) {
    const auto thousandths = [](double value) { return std::round(1000 * value) / 1000; };
    return {thousandths(v.x), thousandths(v.y)};
}

/// The resolution of a picture if none is given. Thin lines are a pixel and a half wide.
constexpr float usual_dpi = 150;

/// Finds the lines of a model that cameras see, with one device for all.
class Finder {
  public:
    Finder(const DeviceOptions& device, const LineSet& lines, const VisibilityOptions& wanted,
           const Style& style)
        : lines_(lines), device_(device), visibility_(lines, device_), wanted_(wanted),
          style_(style) {}

    SeenLines find(const SheetView& view) {
        const Camera& camera = view.camera;
        const Style style = style_of_view(style_, view);
        wanted_.outline_depth = outline_depth(style, camera.size);
        wanted_.centre_overhang = centre_overhang(style, camera.size);
        std::vector<Interval> intervals = visibility_.find(camera, wanted_);
        return {std::move(intervals), visibility_.outlines(),
                find_fills(lines_, camera, style.fill, device_)};
    }

  private:
    const LineSet& lines_;
    DeviceOptions device_;
    LineVisibility visibility_;
    VisibilityOptions wanted_;
    Style style_;
};

/// The rest of a model that a section's plane cuts.
struct CutModel {
    std::string name; ///< of the plane
    Section section;
    LineSet lines;
    Finder finder;

    CutModel(const DrawArguments& arguments, const Subject& subject, const SectionPlane& plane,
             const VisibilityOptions& wanted, const Style& style)
        : name(plane.name), section(cut_mesh(subject.mesh, {{plane}}, arguments.sections.hatching(),
                                             arguments.sections.uncut())),
          lines(extract_lines(section.mesh, subject.line_options)),
          finder(arguments.device, lines, wanted, style) {
        print_notes(section.notes);
    }
};

VectorSheet find_views(const DrawArguments& arguments, const SheetSubject& sheet,
                       const FrameOptions& options) {
    const Subject& subject = sheet.subject;
    const Style& style = options.style;
    const VisibilityOptions wanted{.lines = drawn_kinds(options.lines, options.style),
                                   .hidden = true,
                                   .step = options.step,
                                   .outlines = tells_outlines(style)};
    Finder whole{arguments.device, subject.lines, wanted, style};
    std::optional<CutModel> cut; // of the last section; its details follow it
    const auto find = [&](const SheetView& view) -> SeenLines {
        if (!view.cut) return whole.find(view);
        if (!cut || cut->name != view.cut->name)
            cut.emplace(arguments, subject, *view.cut, wanted, style);
        SeenLines seen = cut->finder.find(view);
        seen.lines = &cut->lines;
        seen.mesh = &cut->section.mesh;
        return seen;
    };
    return make_vector_sheet(subject.lines, sheet.layout, find, options.style,
                             {.mesh = &subject.mesh});
}

/// Prints a note if no view shows a line.
void say_if_empty(const VectorSheet& sheet, const Subject& subject, LineKindMask kinds) {
    const auto is_empty = [](const VectorDrawing& drawing) { return drawing.paths.empty(); };
    if (!std::ranges::all_of(sheet.drawings, is_empty)) return;
    const Camera& camera = sheet.layout.views.front().camera;
    print_notes({"no line is drawn: " + why_no_line(subject.lines, kinds, camera)});
}

void say_what_is_thinned(const VectorSheet& sheet) {
    double most = 0;
    for (const VectorDrawing& drawing : sheet.drawings)
        most = std::max(most, drawing.thinned_share);
    if (const std::string note = note_of_thinned(most); !note.empty()) print_notes({note});
}

OutputPlaces output_places(const DrawArguments& arguments) {
    OutputPlaces places;
    places.reads(arguments.session);
    for (const std::filesystem::path& model : arguments.models) places.reads(model);
    places.reads(arguments.style.name());
    if (SheetArguments::is_file(arguments.view)) places.reads(arguments.view.views());
    places.writes("--output", arguments.output);
    return places;
}

/// The command that draws the sheet again. Unlike that of a picture it has the options that place
/// cameras.
std::string description_of(const DrawArguments& arguments, const CLI::App& app,
                           const Subject& subject) {
    const std::string& model = arguments.session.empty() ? arguments.model : arguments.session;
    std::string text = describe_drawing(app, model, subject.sections, subject.deflection,
                                        subject.line_options.lines);
    for (const char* option : {"--up", "--projection", "--unit"})
        if (app.count(option) > 0)
            text += fmt::format(" {}={}", option, app[option]->as<std::string>());
    return text;
}

SheetWriting writing_of(const DrawArguments& arguments, const CLI::App& app,
                        const Subject& subject) {
    const SvgOptions svg = arguments.paths.svg();
    return {.background = !arguments.picture.transparent(),
            .tags = svg.tags,
            .curves = svg.curves,
            .fit_arcs = svg.fit_arcs,
            .description = description_of(arguments, app, subject)};
}

/// The middle of the longest straight piece of a visible line of a part.
struct BalloonPlace {
    double length = 0;
    glm::dvec2 at{0}; ///< pixels of the view
};

void take_longer(const VectorPath& path, const std::vector<std::uint32_t>& items,
                 std::map<std::uint32_t, BalloonPlace>& places) {
    for (const VectorPiece& piece : path.pieces) {
        if (piece.source.triangle >= items.size()) continue;
        const glm::dvec2 from = path.points[piece.point].at, to = path.points[piece.point + 1].at;
        const double share = static_cast<double>(piece.to) - static_cast<double>(piece.from);
        const double middle =
            0.5 * (static_cast<double>(piece.from) + static_cast<double>(piece.to));
        BalloonPlace& best = places[items[piece.source.triangle]];
        const double length = share * glm::distance(from, to);
        if (length > best.length) best = {length, glm::mix(from, to, middle)};
    }
}

/// Where a leader to each part may end, on its visible lines, by the numbers of the parts list.
Json balloons_of(const VectorDrawing& drawing, const SheetView& view,
                 const std::vector<std::uint32_t>& items) {
    constexpr LineKindMask beside = LA_KINDS_BESIDE;
    std::map<std::uint32_t, BalloonPlace> places;
    for (const VectorPath& path : drawing.paths)
        if (path.visible && (mask_of(path.kind) & beside) == 0) take_longer(path, items, places);
    Json balloons = Json::array();
    for (const auto& [item, place] : places)
        balloons.push_back({{"item", item}, {"at", list(view.corner + view.scale * place.at)}});
    return balloons;
}

/// A summary of the model, and of the place of each view on the page in millimetres.
Json summary_of(const Subject& subject, const VectorSheet& sheet) {
    const SheetLayout& layout = sheet.layout;
    Json views = Json::array();
    for (std::size_t i = 0; i < layout.views.size(); ++i) {
        const SheetView& view = layout.views[i];
        views.push_back({{"name", view.name},
                         {"low", list(view.low)},
                         {"high", list(view.high)},
                         {"balloons", balloons_of(sheet.drawings[i], view, subject.items)}});
    }
    Json summary = subject.summary;
    summary["size_mm"] = {sheet.model_size.x, sheet.model_size.y, sheet.model_size.z};
    Json& notes = summary["notes"];
    for (const std::string& note : subject.notes)
        if (std::ranges::find(notes, Json(note)) == notes.end()) notes.push_back(note);
    summary["sheet"] = {{"size", list(layout.size)}, {"scale", layout.scale}, {"views", views}};
    return summary;
}

} // namespace

void draw_sheet(const DrawArguments& arguments, const CLI::App& app) {
    FrameSettings settings;
    arguments.frame.apply(settings);
    FrameOptions options = settings.for_paths({1, 1});
    options.style = arguments.style.style();
    output_places(arguments);

    const LineKindMask kinds = drawn_kinds(options.lines, options.style);
    const SheetSubject sheet = find_sheet(arguments, kinds);
    const Subject& subject = sheet.subject;
    print_notes(subject.notes);
    if (!options.style.pens.empty())
        print_notes(idle_rules(line_classes(subject.lines), options.style));
    const VectorSheet drawn = find_views(arguments, sheet, options);
    say_if_empty(drawn, subject, kinds);
    say_what_is_thinned(drawn);
    ImageSettings picture = arguments.picture.settings();
    if (picture.dpi == 0) picture.dpi = usual_dpi;
    const SheetWriting writing = writing_of(arguments, app, subject);
    picture.description = writing.description;
    write_sheet(arguments.output, drawn, writing, picture);
    if (!SheetArguments::wants_summary(arguments.view)) return;
    // Names come from the file and need not be UTF-8.
    constexpr auto replace = Json::error_handler_t::replace;
    print_output(summary_of(subject, drawn).dump(2, ' ', false, replace) + '\n');
}

} // namespace lineatlas::apps
