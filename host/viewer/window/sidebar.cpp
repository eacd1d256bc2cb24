#include <fmt/format.h>
#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include "core/limits.hpp"
#include "viewer/examples.hpp"
#include "viewer/saving.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

std::string with_thousands(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) {
        digits.insert(static_cast<std::size_t>(at), 1, ',');
    }
    return digits;
}

/// The title of a model. Built-in scenes are marked as examples.
std::string title_of(const ModelSource& source) {
    return source.files.empty() ? source.name() + " (example)" : source.name();
}

void model_section(Ui& ui) {
    Session& session = ui.session;
    const Model* model = session.model();
    heading(ui, model == nullptr ? "No model" : shown(ui, title_of(model->source)));
    if (model != nullptr) {
        ImGui::TextDisabled("%s triangles, %s edges",
                            with_thousands(model->lines.triangles.size()).c_str(),
                            with_thousands(model->lines.segments.size()).c_str());
    }
    if (model != nullptr && !model->source.files.empty()) {
        checkbox(ui, "adds", "Add to what is open", session.adds);
        tip(ui,
            "Files that are opened stand beside those that are there, each in its own coordinates");
    }
    const std::string scene = model != nullptr ? model->source.scene : "";
    choice(
        ui, "scene", "Examples", scene.empty() ? "none is open" : scene, all_examples(),
        [](const Example& example) { return std::string{example.label}; },
        [&](const Example& example) { return example.scene == scene; },
        [&](const Example& example) { session.open_scene(std::string{example.scene}); },
        "Scenes that need no file");
}

bool quality(Ui& ui, Side& side, const std::string& id) {
    bool changed = false;
    label(ui, "Quality");
    const float half =
        0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemInnerSpacing.x);
    for (const auto& [name, quality] :
         {std::pair{"Low", Quality::low}, std::pair{"High", Quality::high}}) {
        const Sampling sampling = sampling_of(quality);
        const bool on = sampling == Sampling{side.probes, side.depth_scale};
        if (quality != Quality::low) ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        const bool pressed = toggle(ui, (id + "." + name).c_str(), name, on, half);
        tip(ui, quality == Quality::low ? "One probe for a sample: twice as fast"
                                        : "Nine probes for a sample, and finer depth");
        if (pressed && !on) {
            side.probes = sampling.probes;
            side.depth_scale = sampling.depth_scale;
            changed = true;
        }
    }
    return changed;
}

bool method(Ui& ui, Side& side, const std::string& id, const char* text) {
    const Side before = side;
    choice(
        ui, id.c_str(), text, label_of(side.method), method_labels,
        [](const MethodLabel& item) { return std::string{item.label}; },
        [&](const MethodLabel& item) { return item.method == side.method; },
        [&](const MethodLabel& item) { side.method = item.method; },
        "Quick: the segment atlas, samples along lines, for movements. Exact: lines are cut at the "
        "faces that hide them. The others are for comparing: samples one line at a time, a "
        "picture of numbers, and the depth test of OpenGL.");
    ImGui::BeginDisabled(side.method == Method::opengl); // this method has no probes
    const bool changed = quality(ui, side, id);
    ImGui::EndDisabled();
    return changed || !(side == before);
}

bool fine_quality(Ui& ui, Side& side) {
    bool changed = false;
    choice(
        ui, "probes", "Probes", std::to_string(side.probes), probe_counts,
        [](std::uint32_t n) { return std::to_string(n); },
        [&](std::uint32_t n) { return n == side.probes; },
        [&](std::uint32_t n) {
            side.probes = n;
            changed = true;
        },
        "Depth probes for each sample of a line");
    changed |= slider(ui, "depth-scale", "Depth scale", side.depth_scale, 1, finest_depth_scale,
                      "%dx", "Depth texels per pixel and axis");
    changed |= slider(ui, "step", "Step", side.step, 0.5F, 8.0F, "%.1f px",
                      "Distance of samples along a line");
    return changed;
}

void method_rows(Ui& ui) {
    Settings& settings = ui.session.settings;
    bool changed = method(ui, settings.sides[0], "method", "Method");
    if (ImGui::TreeNodeEx("Finer settings", ImGuiTreeNodeFlags_SpanAvailWidth |
                                                ImGuiTreeNodeFlags_NoTreePushOnOpen)) {
        changed |= fine_quality(ui, settings.sides[0]);
    }
    ui.spots.note("more");
    tip(ui, "Samples along lines");
    ImGui::BeginDisabled(settings.split || settings.sides[0].method != Method::atlas);
    changed |= checkbox(ui, "exact-at-rest", "Exact when nothing moves", settings.exact_at_rest);
    tip(ui, "A quarter of a second after a movement the picture is drawn as the tool draws it");
    ImGui::EndDisabled();
    changed |= checkbox(ui, "split", "Split screen with another method", settings.split);
    tip(ui, "The same camera, with another method right of a line that is dragged (X)");
    if (settings.split) changed |= method(ui, settings.sides[1], "second", "Right side");
    if (changed) ui.session.changed();
}

void save_section(Ui& ui) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    ImGui::BeginDisabled(ui.session.model() == nullptr);
    if (toggle(ui, "export", "Export ...", true, half)) switch_panel(ui, Panel::exporting);
    tip(ui, "A picture or paths for a screen, a printer, a plotter or a laser (Ctrl + E)");
    ImGui::SameLine(0, gap);
    if (button(ui, "save.session", "Save the session", half)) save_as(ui, SavedKind::session);
    tip(ui, "All that is seen here, to be opened again or drawn by the tool (Ctrl + S)");
    ImGui::EndDisabled();
}

} // namespace

float sidebar_width(const Ui& ui) {
    return ui.sidebar ? ui.points(measures::sidebar) : 0;
}

Area canvas_area(const Ui& ui, glm::vec2 window) {
    const glm::vec2 low{0, ui.points(measures::tool_bar)};
    const glm::vec2 high{window.x - sidebar_width(ui), window.y};
    return {low, glm::max(high - low, 0.0F)};
}

void save_as(Ui& ui, SavedKind kind) {
    Session& session = ui.session;
    if (session.model() == nullptr) return;
    const auto path = [&](const char* extension) {
        return session.free_path(ui.folder, extension);
    };
    switch (kind) {
    case SavedKind::session:
        session.save_session(session.session_path().empty() ? path("session.toml")
                                                            : session.session_path());
        return;
    case SavedKind::png:
        session.save_picture(ui.folder, "png");
        return;
    case SavedKind::svg:
        session.save_picture(ui.folder, "svg");
        return;
    case SavedKind::style:
        session.save_style(path("toml"));
        return;
    case SavedKind::camera:
        session.save_camera(path("json"));
        return;
    case SavedKind::trace:
        session.save_trace(path("trace.json"));
        return;
    }
}

void draw_advanced_section(Ui& ui) {
    if (!section(ui, "advanced", "Advanced")) return;
    method_rows(ui);
    draw_device_rows(ui);
}

void draw_sidebar(Ui& ui, Area area) {
    ImGui::SetNextWindowPos({area.low.x, area.low.y});
    ImGui::SetNextWindowSize({area.size.x, area.size.y});
    ImGui::Begin("sidebar", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    // The buttons for saving stay in sight while the rest scrolls.
    const float footer = ImGui::GetFrameHeightWithSpacing() + ui.points(6);
    // The scroll bar lies in the margin, so that it leaves a gap.
    const float gap = ui.points(8);
    const float width = ImGui::GetContentRegionAvail().x + 2 * gap;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() - gap);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {gap, 0});
    if (std::exchange(ui.keyboard_to_sidebar, false)) ImGui::SetNextWindowFocus();
    ImGui::BeginChild("settings", {width, -footer}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NavFlattened);
    ImGui::PopStyleVar();
    model_section(ui);
    draw_parts_section(ui);
    draw_sections_section(ui);
    draw_style_section(ui);
    draw_lines_section(ui);
    draw_views_section(ui);
    draw_advanced_section(ui);
    ImGui::EndChild();
    ImGui::Dummy({0, ui.points(1)});
    save_section(ui);
    const float border = area.low.x + 0.5F;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    list.AddLine({border, area.low.y}, {border, area.low.y + area.size.y}, theme::colors().line);
    list.PopClipRect();
    ImGui::End();
}

} // namespace lineatlas::viewer
