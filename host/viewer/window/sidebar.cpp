#include <fmt/format.h>
#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include "core/limits.hpp"
#include "lineatlas/scenes.hpp"
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

void model_section(Ui& ui) {
    Session& session = ui.session;
    const Model* model = session.model();
    heading(ui, model == nullptr ? "Open a model" : model->source.name().c_str());
    if (model != nullptr) {
        ImGui::TextDisabled("%s triangles, %s edges",
                            with_thousands(model->lines.triangles.size()).c_str(),
                            with_thousands(model->lines.segments.size()).c_str());
    }
    if (model != nullptr && !model->source.files.empty()) {
        checkbox(ui, "adds", "Add to what is open", session.adds);
        tip("Files that are opened stand beside those that are there, each in its own coordinates");
    }
    const std::string shown = model != nullptr ? model->source.scene : "";
    choice(
        ui, "scene", "Scene", shown.empty() ? "Built-in scenes" : shown, scene_names(),
        [](std::string_view name) { return std::string{name}; },
        [&](std::string_view name) { return name == shown; },
        [&](std::string_view name) { session.open_scene(std::string{name}); });
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
        if (toggle(ui, (id + "." + name).c_str(), name, on, half) && !on) {
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
        [&](const MethodLabel& item) { side.method = item.method; });
    ImGui::BeginDisabled(side.method == Method::opengl); // it has no probes
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
        });
    changed |=
        slider(ui, "depth-scale", "Depth scale", side.depth_scale, 1, finest_depth_scale, "%dx");
    changed |= slider(ui, "step", "Step", side.step, 0.5F, 8.0F, "%.1f px");
    return changed;
}

void method_section(Ui& ui) {
    Settings& settings = ui.session.settings;
    if (!section(ui, "visibility", "Visibility")) return;
    bool changed = method(ui, settings.sides[0], "method", "Method");
    if (ImGui::TreeNodeEx("Finer settings", ImGuiTreeNodeFlags_SpanAvailWidth |
                                                ImGuiTreeNodeFlags_NoTreePushOnOpen)) {
        changed |= fine_quality(ui, settings.sides[0]);
    }
    ui.spots.note("more");
    ImGui::BeginDisabled(settings.split || settings.sides[0].method != Method::atlas);
    changed |= checkbox(ui, "exact-at-rest", "Exact when nothing moves", settings.exact_at_rest);
    ImGui::EndDisabled();
    changed |= checkbox(ui, "split", "Split screen with another method", settings.split);
    if (settings.split) changed |= method(ui, settings.sides[1], "second", "Right side");
    if (changed) ui.session.changed();
}

void save_section(Ui& ui) {
    heading(ui, "Save");
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    ImGui::BeginDisabled(ui.session.model() == nullptr);
    for (const auto& [id, text, kind, help] :
         {std::tuple{"save.session", "Session", SavedKind::session,
                     "All that is seen here, to be opened again or drawn by the tool (Ctrl + S)"},
          std::tuple{"save.png", "PNG", SavedKind::png, "The picture as it is (Ctrl + E)"},
          std::tuple{"save.svg", "SVG", SavedKind::svg,
                     "Its visible lines as paths (Ctrl + Shift + E)"},
          std::tuple{"save.style", "Style", SavedKind::style, "For --style, as TOML"},
          std::tuple{"save.camera", "Camera", SavedKind::camera, "For --camera-path, as JSON"}}) {
        if (kind != SavedKind::session && kind != SavedKind::style) ImGui::SameLine(0, gap);
        const bool upper = kind != SavedKind::style && kind != SavedKind::camera;
        if (button(ui, id, text, upper ? third : 1.5F * third + 0.5F * gap)) save_as(ui, kind);
        tip(help);
    }
    ImGui::EndDisabled();
    static constexpr std::array<int, 4> scales{1, 2, 3, 4};
    const auto name = [&](int scale) {
        const glm::ivec2 size = ui.session.size() * scale;
        return fmt::format("{} x {}", size.x, size.y);
    };
    choice(
        ui, "save.scale", "Pixels", name(ui.save_scale), scales, name,
        [&](int scale) { return scale == ui.save_scale; },
        [&](int scale) { ui.save_scale = scale; });
    label(ui, "Folder");
    ImGui::InputText("##folder", &ui.folder);
    ui.spots.note("folder");
}

} // namespace

float sidebar_width(const Ui& ui) {
    return ui.sidebar ? ui.points(312) : 0;
}

void save_as(Ui& ui, SavedKind kind) {
    Session& session = ui.session;
    if (session.model() == nullptr) return;
    const std::string stem = session.model()->source.stem();
    const auto path = [&](const char* extension) { return free_path(ui.folder, stem, extension); };
    switch (kind) {
    case SavedKind::session:
        session.save_session(session.session_path().empty() ? path("session.toml")
                                                            : session.session_path());
        return;
    case SavedKind::png:
        return ui.do_later("Saving", [&session, path = path("png"), scale = ui.save_scale] {
            session.save_picture(path, scale);
        });
    case SavedKind::svg:
        return ui.do_later("Saving",
                           [&session, path = path("svg")] { session.save_picture(path); });
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

void draw_sidebar(Ui& ui, Area area) {
    ImGui::SetNextWindowPos({area.low.x, area.low.y});
    ImGui::SetNextWindowSize({area.size.x, area.size.y});
    ImGui::Begin("sidebar", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    // What is saved stays in sight, whatever is scrolled.
    const float footer = 5 * ImGui::GetFrameHeightWithSpacing() + ui.points(4);
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
    method_section(ui);
    draw_style_section(ui);
    draw_lines_section(ui);
    draw_views_section(ui);
    draw_device_section(ui);
    ImGui::EndChild();
    save_section(ui);
    const float border = area.low.x + 0.5F;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    list.AddLine({border, area.low.y}, {border, area.low.y + area.size.y}, theme::colors().line);
    list.PopClipRect();
    ImGui::End();
}

} // namespace lineatlas::viewer
