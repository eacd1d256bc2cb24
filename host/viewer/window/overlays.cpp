#include <fmt/format.h>

#include "commands.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

/// Begins the bar above the picture. In a narrow window it is longer than the picture is wide.
void begin_toolbar(const Ui& ui, Area canvas) {
    const float height = canvas.low.y;
    const float above = 0.5F * (height - ImGui::GetFrameHeight());
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSizeConstraints({canvas.size.x, height}, {FLT_MAX, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.points(measures::inset), above});
    ImGui::Begin("toolbar", nullptr, overlay_flags);
    ImGui::PopStyleVar();
    const ImVec2 size = ImGui::GetWindowSize();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    list.AddLine({0, size.y - 0.5F}, {size.x, size.y - 0.5F}, theme::colors().line);
    list.PopClipRect();
}

void toolbar(Ui& ui, Area canvas) {
    begin_toolbar(ui, canvas);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.points(4), 0});
    if (toggle(ui, "open.panel", "Open", ui.panel == Panel::open)) switch_panel(ui, Panel::open);
    tip(ui, "Files of a folder, and recent ones (Ctrl + O)");
    ImGui::SameLine(0, ui.points(14));
    if (button(ui, "fit", "Fit")) ui.session.fit();
    tip(ui, "Show the whole model (F)");
    for (const auto& [id, text, view, help] :
         {std::tuple{"corner", "Corner", StandardView::corner, "From the front, right, above (0)"},
          std::tuple{"front", "Front", StandardView::front, "From the front (1)"},
          std::tuple{"right", "Right", StandardView::right, "From the right (2)"},
          std::tuple{"top", "Top", StandardView::top, "From above (3)"}}) {
        ImGui::SameLine();
        if (button(ui, id, text)) ui.session.glide_to(view);
        tip(ui, help);
    }
    ImGui::SameLine(0, ui.points(14));
    const bool parallel = ui.session.navigation.goal().projection == Projection::orthographic;
    if (toggle(ui, "parallel", "Parallel", parallel)) ui.session.toggle_projection();
    tip(ui, "Parallel lines of sight: equal lengths look equal (P)");
    ImGui::SameLine();
    if (toggle(ui, "timings", "Timings", ui.timings)) ui.timings = !ui.timings;
    tip(ui, "Where a frame's time goes (T)");
    ImGui::SameLine();
    if (toggle(ui, "help", "?", ui.panel == Panel::keys, ui.points(26)))
        switch_panel(ui, Panel::keys);
    tip(ui, "Keys (F1)");
    ImGui::PopStyleVar();
    ImGui::End();
}

/// Draws the name of a side beside the upper end of the slider.
void side_name(Ui& ui, const Area& canvas, const Side& side, float x, float direction) {
    std::string text = label_of(side.method);
    if (side.method != Method::opengl) {
        text += fmt::format(", {} probe{}", side.probes, side.probes == 1 ? "" : "s");
    }
    const float inset = ui.points(measures::inset);
    plate(ui, text, {x + direction * inset, canvas.low.y + inset}, {direction < 0 ? 1 : 0, 0});
}

void split_handle(Ui& ui, Area canvas) {
    const Settings& settings = ui.session.settings;
    const float x = canvas.low.x + settings.split_at * canvas.size.x;
    const float middle = canvas.low.y + 0.5F * canvas.size.y;
    const float bottom = canvas.low.y + canvas.size.y;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddLine({x, canvas.low.y}, {x, bottom}, theme::colors().accent, ui.points(1.5F));
    list.AddCircleFilled({x, middle}, ui.points(13), theme::colors().accent);
    for (const float side : {-1.0F, 1.0F}) {
        const float peak = x + side * ui.points(8), base = x + side * ui.points(3.5F);
        const float half = ui.points(4);
        list.AddTriangleFilled({peak, middle}, {base, middle - half}, {base, middle + half},
                               theme::colors().on_accent);
    }
    side_name(ui, canvas, settings.sides[0], x, -1);
    side_name(ui, canvas, settings.sides[1], x, 1);
}

void loading(Ui& ui, Area canvas) {
    Loader& loader = ui.session.loader;
    begin_overlay(ui, "loading", canvas.low + 0.5F * canvas.size, {0.5F, 0.5F});
    ImGui::PushFont(ui.bold);
    ImGui::TextUnformatted(shown(ui, loader.name()));
    ImGui::PopFont();
    ImGui::TextDisabled("%s ...", loader.stage().c_str());
    progress_bar(ui, -1);
    if (button(ui, "cancel", "Cancel")) ui.session.cancel_loading();
    tip(ui, "Everything stays as it was (Esc)");
    ImGui::End();
}

void recording(Ui& ui, Area canvas) {
    const Recording& now = *ui.session.recording();
    begin_overlay(ui, "recording", canvas.low + 0.5F * canvas.size, {0.5F, 0.5F});
    ImGui::Text("Picture %d of %d", static_cast<int>(now.drawn()), static_cast<int>(now.count()));
    progress_bar(ui, static_cast<float>(now.drawn()) / static_cast<float>(now.count()));
    if (button(ui, "record.cancel", "Stop")) ui.session.cancel_recording();
    tip(ui, "Pictures that are drawn stay (Esc)");
    ImGui::End();
}

void box_around(const Session& session, Area canvas, const Bounds& bounds, ImDrawList& list) {
    const auto corner = [&](unsigned i) {
        const glm::dvec3 at{(i & 1U) != 0 ? bounds.max.x : bounds.min.x,
                            (i & 2U) != 0 ? bounds.max.y : bounds.min.y,
                            (i & 4U) != 0 ? bounds.max.z : bounds.min.z};
        return place_of(session, canvas, at);
    };
    for (unsigned i = 0; i < 8; ++i) {
        for (const unsigned axis : {1U, 2U, 4U}) {
            const std::optional<ImVec2> from = corner(i), to = corner(i | axis);
            if ((i & axis) == 0 && from && to)
                list.AddLine(*from, *to, theme::colors().selection, 1);
        }
    }
}

/// Draws boxes around selected parts, and the part's name or their number.
void selection(Ui& ui, Area canvas) {
    const Session& session = ui.session;
    if (session.selected.empty()) return;
    const Parts& parts = session.model()->parts;
    ImDrawList& list = list_over(canvas);
    for (const std::uint32_t part : session.selected)
        box_around(session, canvas, parts.all().at(part).bounds, list);
    list.PopClipRect();
    const std::string name = session.selected.size() == 1
                                 ? parts.path_of(*session.selected.begin())
                                 : fmt::format("{} parts", session.selected.size());
    plate(ui, name, {canvas.low.x + ui.points(100), canvas.low.y + canvas.size.y - ui.points(14)},
          {0, 1});
}

/// Draws a line on how the picture is drawn.
void status(Ui& ui, Area canvas) {
    const Session& session = ui.session;
    std::string text =
        label_of(session.refined() ? Method::exact : session.settings.sides[0].method);
    if (session.loader.busy() && !session.loader.shows_progress())
        text = session.loader.stage() + " ...";
    else if (session.refining())
        text += ", becoming exact ...";
    else if (session.economy() != Economy::none)
        text += ", less while it moves";
    ui.spots.note("status:" + text,
                  plate(ui, text, canvas.low + canvas.size - ui.points(14), {1, 1}));
}

/// Draws what people wait for. What the drawing thread does goes on beside the window.
void at_work(Ui& ui, Area canvas) {
    const std::string work = ui.session.work();
    begin_overlay(ui, "work", canvas.low + 0.5F * canvas.size, {0.5F, 0.5F});
    ImGui::Text("%s ...", ui.later ? ui.later->first.c_str() : work.c_str());
    if (!ui.later) progress_bar(ui, ui.session.work_done());
    if (ui.session.can_cancel_work()) {
        if (button(ui, "work.cancel", "Cancel")) ui.session.cancel_work();
        tip(ui, work == saving_work ? "Nothing is written (Esc)" : "The pictures stay (Esc)");
    }
    ImGui::End();
}

} // namespace

Waiting waiting(const Ui& ui) {
    if (ui.session.recording()) return Waiting::recording;
    if (ui.session.loader.shows_progress()) return Waiting::loading;
    return ui.later || !ui.session.work().empty() ? Waiting::work : Waiting::nothing;
}

void draw_canvas_overlays(Ui& ui, Area canvas) {
    if (ui.session.settings.split && ui.session.picture(1) != nullptr) split_handle(ui, canvas);
    if (ui.session.model() != nullptr) {
        draw_cuts(ui, canvas);
        draw_distances(ui, canvas);
        selection(ui, canvas);
        if (!ui.session.settings.split) status(ui, canvas);
    }
    draw_gizmo(ui, canvas);
    toolbar(ui, canvas);
    const Waiting now = waiting(ui);
    if (now == Waiting::recording)
        recording(ui, canvas);
    else if (now == Waiting::loading)
        loading(ui, canvas);
    else if (now == Waiting::work)
        at_work(ui, canvas);
    else if (ui.session.model() == nullptr && ui.panel == Panel::none)
        draw_start_panel(ui, canvas);
}

void draw_messages(Ui& ui, Area canvas) {
    const std::vector<Messages::Message> all = ui.session.messages.all();
    float y = canvas.low.y + ui.points(ui.session.settings.split ? 46 : measures::inset);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Messages::Message& message = all[i];
        const std::string name = fmt::format("message{}", i);
        begin_overlay(ui, name.c_str(), {canvas.low.x + ui.points(12), y}, {0, 0});
        const float width = std::min(canvas.size.x - ui.points(80), ui.points(560));
        if (message.error) {
            ImGui::PushStyleColor(ImGuiCol_Text, theme::colors().alarm);
            ImGui::TextUnformatted(
                message.count > 1
                    ? fmt::format("That did not work ({} times)", message.count).c_str()
                    : "That did not work");
            ImGui::PopStyleColor();
        }
        ImGui::PushTextWrapPos(width);
        ImGui::TextUnformatted(shown(ui, message.text));
        ImGui::PopTextWrapPos();
        const std::string id = fmt::format("dismiss.{}", i);
        if (message.error && button(ui, id.c_str(), "Dismiss")) ui.session.messages.dismiss(i);
        if (message.error) tip(ui, "Esc");
        y += ImGui::GetWindowHeight() + ui.points(8);
        ImGui::End();
    }
}

void draw_help(Ui& ui) {
    if (ui.panel != Panel::keys) return;
    struct Row {
        std::string key;
        std::string what;
    };
    std::vector<Row> rows{{"Left drag", "Orbit the point under the mouse"},
                          {"Middle or Shift + left drag", "Pan"},
                          {"Wheel or Ctrl + left drag", "Go nearer, go away"},
                          {"Right drag", "Look around"},
                          {"Click, double click", "Select a part, frame it"},
                          {"W A S D, Q E", "Fly; with Shift faster"},
                          {"Esc", "Close a panel, cancel, dismiss"}};
    for (const Command& command : commands())
        if (command.key != 0) rows.push_back({key_text(command), command.name});
    const std::size_t half = (rows.size() + 1) / 2;
    // The list may cover the sidebar, which takes most of a small window.
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    begin_overlay(ui, "keys", {0.5F * window.x, 0.5F * window.y}, {0.5F, 0.5F});
    ImGui::PushFont(ui.bold);
    ImGui::TextUnformatted("Keys");
    ImGui::PopFont();
    // Two columns, because one would be higher than a small window.
    for (std::size_t i = 0; i < half; ++i) {
        for (const std::size_t at : {i, i + half}) {
            if (at == rows.size()) continue;
            const float left = at < half ? 0 : ui.points(420);
            if (at >= half) ImGui::SameLine(left);
            ImGui::TextUnformatted(rows[at].key.c_str());
            ImGui::SameLine(left + ui.points(at < half ? 190 : 130));
            ImGui::TextDisabled("%s", rows[at].what.c_str());
        }
    }
    if (button(ui, "help.close", "Close")) ui.panel = Panel::none;
    tip(ui, "Esc");
    ImGui::End();
}

} // namespace lineatlas::viewer
