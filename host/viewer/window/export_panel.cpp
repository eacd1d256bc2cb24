// How a drawing leaves the viewer: what it is for, on which page, under which name.
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "lineatlas/error.hpp"
#include "viewer/saving.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

constexpr std::array<const char*, 10> pages{"a0", "a1", "a2",     "a3",    "a4",
                                            "a5", "a6", "letter", "legal", "tabloid"};
/// Scales of ISO 5455; the empty one fills the page.
constexpr std::array<const char*, 17> scales{"",      "50:1",  "20:1",  "10:1",   "5:1",   "2:1",
                                             "1:1",   "1:2",   "1:5",   "1:10",   "1:20",  "1:50",
                                             "1:100", "1:200", "1:500", "1:1000", "1:2000"};
constexpr std::array<const char*, 7> sides{"front", "top",    "right",    "left",
                                           "back",  "bottom", "isometric"};

std::string in_capitals(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char letter) { return std::toupper(letter); });
    return text;
}

std::string name_of_page(const std::string& page) {
    std::string name = page;
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    return name;
}

const char* extension_of(const ExportOptions& options) {
    return format_extensions.at(static_cast<std::size_t>(options.format));
}

/// Gives the name the extension of the chosen type, and makes it one that no file has.
void take_extension(Ui& ui) {
    const std::string stem = std::filesystem::path{ui.exporting.name}.stem().string();
    ui.exporting.name = stem + "." + extension_of(ui.exporting.options);
}

void purpose_row(Ui& ui) {
    struct Choice {
        Purpose purpose;
        const char *id, *text, *what;
    };
    constexpr std::array<Choice, 4> choices{
        {{Purpose::screen, "export.screen", "Screen", "A picture as it is seen here"},
         {Purpose::print, "export.print", "Print", "On a page, also to scale; PNG in 300 dpi"},
         {Purpose::plotter, "export.plotter", "Plotter",
          "Paths in the order of the least travel, without the paper's colour"},
         {Purpose::laser, "export.laser", "Laser",
          "Paths as for a plotter, with circles and arcs"}}};
    ExportOptions& options = ui.exporting.options;
    label(ui, "For");
    for (const Choice& choice : choices) {
        if (choice.purpose != Purpose::screen) ImGui::SameLine(0, ui.points(4));
        if (toggle(ui, choice.id, choice.text, options.purpose == choice.purpose)) {
            options = suited_to(choice.purpose, options);
            take_extension(ui);
        }
        tip(ui, choice.what);
    }
}

void format_row(Ui& ui) {
    constexpr std::array<const char*, 5> what{"Pixels", "Paths for browsers and for Inkscape",
                                              "Paths for printing",
                                              "Paths for CAD and for machines, in millimetres",
                                              "Paths with what they show, for programs"};
    ExportOptions& options = ui.exporting.options;
    label(ui, "As");
    for (std::size_t i = 0; i < format_extensions.size(); ++i) {
        const auto format = static_cast<FileFormat>(i);
        const std::string extension = format_extensions.at(i);
        if (i > 0) ImGui::SameLine(0, ui.points(4));
        ImGui::BeginDisabled(options.sheet && format == FileFormat::json); // JSON has one view
        if (toggle(ui, ("export." + extension).c_str(), in_capitals(extension).c_str(),
                   options.format == format)) {
            options = as_format(format, options);
            take_extension(ui);
        }
        ImGui::EndDisabled();
        tip(ui, what.at(i));
    }
}

void view_rows(Ui& ui) {
    ExportOptions& options = ui.exporting.options;
    label(ui, "What");
    if (toggle(ui, "export.one", "This view", !options.sheet)) options.sheet = false;
    tip(ui, "The visible part; with a scale the whole model, from the current direction");
    ImGui::SameLine(0, ui.points(4));
    ImGui::BeginDisabled(options.format == FileFormat::json);
    if (toggle(ui, "export.sheet", "Sheet of views", options.sheet)) options.sheet = true;
    ImGui::EndDisabled();
    tip(ui, "Aligned views with a frame and a title block");
    if (!options.sheet) return;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i % 4 == 0)
            label(ui, i == 0 ? "Views" : "");
        else
            ImGui::SameLine(0, ui.points(4));
        const std::string side = sides.at(i);
        const auto at = std::ranges::find(options.views, side);
        const bool on = at != options.views.end();
        const bool pressed =
            toggle(ui, ("export.side." + side).c_str(), name_of_page(side).c_str(), on);
        tip(ui, "Whether the sheet has this side");
        if (!pressed) continue;
        if (!on)
            options.views.push_back(side);
        else if (options.views.size() > 1)
            options.views.erase(at);
    }
    label(ui, "");
    checkbox(ui, "export.measures", "Sizes, axes, scale bar", options.measures);
    tip(ui, "Overall sizes as dimensions, the model's axes beside each view, and a scale bar");
}

/// A scale that is typed, or chosen from the list behind the arrow.
void scale_row(Ui& ui) {
    constexpr const char *fits = "as large as fits", *help = "Lengths on paper to lengths of the "
                                                             "model: 1:2, 1:2.5, 2:1, or 0.4";
    std::string &scale = ui.exporting.options.scale, &typed = ui.exporting.scale;
    label(ui, "Scale");
    const float gap = ui.points(4);
    ImGui::SetNextItemWidth(-ImGui::GetFrameHeight() - gap);
    if (ImGui::InputTextWithHint("##export.scale.text", fits, &typed,
                                 ImGuiInputTextFlags_AutoSelectAll)) // a click, and it is replaced
        scale = scale_of_text(typed);
    if (!ImGui::IsItemActive()) typed = scale;
    ui.spots.note("export.scale.text");
    tip(ui, help);
    ImGui::SameLine(0, gap);
    list_of_choices(
        ui, "export.scale", "", scales,
        [](const std::string& item) { return item.empty() ? fits : item; },
        [&](const char* item) { return item == scale; }, [&](const char* item) { scale = item; },
        "Usual scales", ImGuiComboFlags_NoPreview | ImGuiComboFlags_PopupAlignLeft);
}

void paper_rows(Ui& ui) {
    ExportOptions& options = ui.exporting.options;
    choice(
        ui, "export.page", "Paper", name_of_page(options.page), pages,
        [](const char* page) { return name_of_page(page); },
        [&](const char* page) { return page == options.page; },
        [&](const char* page) { options.page = page; }, "The page; it lies as the drawing does");
    scale_row(ui);
    if (options.sheet) return; // a sheet has a frame
    slider(ui, "export.margin", "Margin", options.margin, 0.0F, 50.0F, "%.0f mm",
           "Space around the drawing");
}

void pixels_row(Ui& ui) {
    static constexpr std::array<int, 4> factors{1, 2, 3, 4};
    ExportOptions& options = ui.exporting.options;
    const auto name = [&](int factor) {
        const glm::ivec2 size = ui.session.size() * factor;
        return fmt::format("{} x {}", size.x, size.y);
    };
    choice(
        ui, "export.pixels", "Pixels", name(options.pixels), factors, name,
        [&](int factor) { return factor == options.pixels; },
        [&](int factor) { options.pixels = factor; }, "Size of the picture");
}

/// A field for text. Returns whether Enter was pressed in it.
bool field(Ui& ui, const char* id, const char* text, std::string& value, const char* help) {
    label(ui, text);
    const bool entered = ImGui::InputText((std::string{"##"} + id).c_str(), &value,
                                          ImGuiInputTextFlags_EnterReturnsTrue);
    shown(ui, value); // letters that were pasted
    ui.spots.note(id);
    tip(ui, help);
    return entered;
}

/// The path of the file. A typed name without the extension gets it.
std::filesystem::path path_of(const Ui& ui) {
    const std::string extension = std::string{"."} + extension_of(ui.exporting.options);
    const bool named = ui.exporting.name.ends_with(extension);
    return std::filesystem::path{ui.folder} / (ui.exporting.name + (named ? "" : extension));
}

void save(Ui& ui) {
    if (ui.exporting.name.empty()) return;
    ui.panel = Panel::none;
    ui.session.export_to(path_of(ui), ui.exporting.options);
}

bool settings(Ui& ui) {
    const ExportOptions& options = ui.exporting.options;
    purpose_row(ui);
    format_row(ui);
    if (options.purpose != Purpose::screen) view_rows(ui);
    if (is_on_paper(options))
        paper_rows(ui);
    else if (options.format == FileFormat::png)
        pixels_row(ui);
    const bool named = field(ui, "export.name", "Name", ui.exporting.name, "Of the file");
    return field(ui, "export.folder", "Folder", ui.folder, "Where files are saved") || named;
}

/// The place of the drawn page, and the size of a millimetre on it.
struct Frame {
    ImVec2 low;
    float scale;
    ImVec2 at(glm::dvec2 place) const {
        return {low.x + scale * static_cast<float>(place.x),
                low.y + scale * static_cast<float>(place.y)};
    }
};

void draw_sheet(const SheetLayout& sheet, const Frame& frame) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    constexpr ImU32 ink = IM_COL32(40, 40, 40, 255);
    for (const SheetLine& line : sheet.lines)
        for (std::size_t i = 1; i < line.points.size(); ++i)
            list.AddLine(frame.at(line.points[i - 1]), frame.at(line.points[i]), ink, 1);
    for (const SheetCircle& circle : sheet.circles)
        list.AddCircle(frame.at(circle.center), frame.scale * static_cast<float>(circle.radius),
                       ink);
}

void draw_page(const Session::Preview& preview, const Frame& frame) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high = frame.at(preview.page.size);
    list.AddRectFilled(frame.low, high, IM_COL32_WHITE);
    for (std::size_t i = 0; i < preview.pictures.size(); ++i) {
        const PageView& view = preview.page.views[i];
        const auto texture = static_cast<std::uintptr_t>(preview.pictures[i]->texture());
        list.AddImage(reinterpret_cast<ImTextureID>(texture), frame.at(view.low),
                      frame.at(view.high), {0, 1}, {1, 0});
    }
    if (preview.page.sheet) draw_sheet(*preview.page.sheet, frame);
    list.AddRect(frame.low, high, theme::colors().quiet);
}

std::string size_text(const ExportOptions& options, const ExportPage& page) {
    std::string text = fmt::format("{:.0f} x {:.0f} {}", page.size.x, page.size.y,
                                   is_on_paper(options) ? "mm" : "pixels");
    if (!page.scale.empty()) text += ", " + page.scale;
    return text;
}

void preview(Ui& ui) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float text_height = 2 * ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 space{room.x, std::max(room.y - text_height, ui.points(40))};
    // The page is shown pixel for pixel, as it was drawn last. Thin lines would be lost if it were
    // scaled.
    const ExportOptions& options = ui.exporting.options;
    const glm::dvec2 last = glm::max(ui.session.preview(options, 1).page.size, 1.0);
    const double fits =
        std::min(static_cast<double>(space.x) / last.x, static_cast<double>(space.y) / last.y);
    const auto density = static_cast<double>(ImGui::GetIO().DisplayFramebufferScale.x);
    const Session::Preview& drawn = ui.session.preview(
        options, static_cast<int>(std::lround(density * fits * std::max(last.x, last.y))));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy(space);
    ui.spots.note("export.preview");
    if (!drawn.problem.empty()) {
        ImGui::SetCursorScreenPos(corner);
        ImGui::PushStyleColor(ImGuiCol_Text, theme::colors().alarm);
        ImGui::TextWrapped("%s", shown(ui, drawn.problem));
        ImGui::PopStyleColor();
        return;
    }
    if (drawn.pictures.empty()) {
        ImGui::SetCursorScreenPos(corner);
        ImGui::TextDisabled("The page is being drawn ...");
        return;
    }
    const glm::dvec2 size = drawn.page.size;
    const float scale =
        std::min(space.x / static_cast<float>(size.x), space.y / static_cast<float>(size.y));
    const ImVec2 free{space.x - scale * static_cast<float>(size.x),
                      space.y - scale * static_cast<float>(size.y)};
    draw_page(drawn, {{corner.x + free.x / 2, corner.y + free.y / 2}, scale});
    ImGui::TextDisabled("%s", size_text(options, drawn.page).c_str());
}

} // namespace

void begin_export(Ui& ui) {
    if (ui.session.model() == nullptr) return;
    const ExportOptions& options = ui.exporting.options;
    const std::filesystem::path path = ui.session.free_path(ui.folder, extension_of(options));
    ui.exporting.name = path.filename().string();
}

void draw_export_panel(Ui& ui) {
    if (ui.panel != Panel::exporting) return;
    if (ui.session.model() == nullptr) {
        ui.panel = Panel::none;
        return;
    }
    // The panel may cover the sidebar, which takes most of a small window.
    const glm::vec2 window{ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y};
    const glm::vec2 size = glm::min(window - ui.points(40), ui.points(1) * glm::vec2{820, 540});
    begin_floating(ui, "export", 0.5F * (window - size), size);
    heading(ui, "Export");
    const float footer = ImGui::GetFrameHeightWithSpacing();
    const float left = std::min(ui.points(380), 0.55F * ImGui::GetContentRegionAvail().x);
    ImGui::BeginChild("export.settings", {left, -footer});
    bool wanted = settings(ui);
    ImGui::EndChild();
    ImGui::SameLine(0, ui.points(16));
    ImGui::BeginChild("export.page", {0, -footer});
    preview(ui);
    ImGui::EndChild();
    const bool replaces = ui.session.is_taken(path_of(ui));
    // Without a preview of these options yet, saving itself tells a problem.
    const bool possible = !ui.exporting.name.empty() &&
                          (!ui.session.has_preview() || ui.session.preview_problem().empty());
    ImGui::BeginDisabled(!possible);
    wanted |= toggle(ui, "export.save", replaces ? "Replace the file" : "Save", true);
    ImGui::EndDisabled();
    tip(ui, replaces ? "A file of that name exists or is being saved" : path_of(ui).c_str());
    ImGui::SameLine(0, ui.points(8));
    if (button(ui, "export.close", "Cancel")) ui.panel = Panel::none;
    tip(ui, "Esc");
    ImGui::End();
    if (wanted && possible) save(ui);
}

} // namespace lineatlas::viewer
