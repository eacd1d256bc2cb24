#include <array>
#include <numbers>

#include <fmt/format.h>

#include "core/line_pens.hpp"
#include "style/frame_settings.hpp"
#include "viewer/kind_pens.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

/// In the order of line_kind_names.
constexpr std::array<const char*, line_kind_names.size()> labels{
    "Creases",       "Boundaries",   "Materials", "Silhouettes", "Lines of the file",
    "Intersections", "Sections",     "Hatching",  "Ridges",      "Valleys",
    "Tangent edges", "Centre lines", "Trails"};

constexpr auto what = std::to_array<const char*>({
    "Edges where faces bend",
    "Edges with a face on one side alone",
    "Edges between two materials",
    "Where the surface turns away from the eye",
    "Lines that the file has",
    "Where parts go through each other",
    "Borders of cuts",
    "Lines on the faces of cuts",
    "Where scans and sculptures bulge most",
    "Where scans and sculptures are hollow most",
    "Edges where a face goes over into another without a bend",
    "Axes of what is round",
    "Ways of parts that are moved apart",
});
static_assert(what.size() == line_kind_names.size());

/// A row with width and colour of a kind.
bool pen_row(Ui& ui, std::string_view kind) {
    Style& style = ui.session.settings.style;
    const Pen pen = pen_of_kind(style, kind);
    const std::string id = fmt::format("lines.{}", kind);
    float width = pen.width;
    glm::vec3 color = pen.color;
    column(ui, 142);
    const float swatch_and_gap = ui.points(32);
    const float room = (ImGui::GetContentRegionAvail().x - swatch_and_gap) / ui.scale;
    const bool wider = slider_with_number(ui, id + ".width", width, 0.3F, 12.0F, "%.1f", room, 32);
    tip(ui, "Width in pixels");
    ImGui::SameLine(0, ui.points(8));
    const bool other = swatch(ui, (id + ".color").c_str(), color, "Colour");
    if (wider) set_width_of_kind(style, kind, width);
    if (other) set_color_of_kind(style, kind, color);
    return wider || other;
}

void crease_row(Ui& ui) {
    const std::optional<float> now = ui.session.settings.shown.crease;
    float degrees = now.value_or(0);
    if (slider(ui, "crease", "Creases from", degrees, 0.0F, 120.0F, now ? "%.0f°" : "auto",
               "Every edge bent by more is a crease; at the left end noise and seams are left out"))
        ui.session.set_crease(degrees > 0 ? std::optional{std::round(degrees)} : std::nullopt);
}

void silhouettes_row(Ui& ui) {
    const Model* model = ui.session.model();
    if (model == nullptr) return;
    struct Choice {
        Silhouettes silhouettes;
        const char* label;
        const char* what;
    };
    constexpr std::array<Choice, 3> choices{
        {{Silhouettes::mesh, "Mesh", "Along edges of the mesh"},
         {Silhouettes::automatic, "Auto", "Smooth where the surface is, else along edges"},
         {Silhouettes::smooth, "Smooth", "Where the surface itself turns away"}}};
    const Silhouettes now =
        ui.session.settings.shown.silhouettes.value_or(LineOptions{}.silhouettes);
    label(ui, "They follow");
    for (const Choice& choice : choices) {
        if (choice.silhouettes != Silhouettes::mesh) ImGui::SameLine(0, ui.points(4));
        const std::string id = "silhouettes." + word_of(choice.silhouettes);
        if (toggle(ui, id.c_str(), choice.label, now == choice.silhouettes))
            ui.session.set_silhouettes(choice.silhouettes);
        tip(ui, choice.what);
    }
}

} // namespace

void draw_lines_section(Ui& ui) {
    if (!section(ui, "lines", "Lines")) return;
    Settings& settings = ui.session.settings;
    const LineKindMask lines = drawn_kinds(settings.lines, settings.style);
    bool changed = false;
    for (std::size_t kind = 0; kind < labels.size(); ++kind) {
        bool on = (lines >> kind & 1U) != 0;
        const std::string id = fmt::format("lines.{}", line_kind_names.at(kind));
        if (checkbox(ui, id.c_str(), labels.at(kind), on)) {
            settings.lines = lines ^ 1U << kind;
            changed = true;
        }
        tip(ui, what.at(kind));
        changed |= pen_row(ui, line_kind_names.at(kind));
        if (kind == static_cast<std::size_t>(LineKind::silhouette)) silhouettes_row(ui);
    }
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Outline");
    ui.spots.note("lines.outline");
    tip(ui, "What has the model on one side and the background on the other");
    changed |= pen_row(ui, outline_name);
    if (changed) ui.session.changed();
    crease_row(ui);
}

} // namespace lineatlas::viewer
