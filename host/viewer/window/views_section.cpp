#include <fmt/format.h>

#include "widgets.hpp"

namespace lineatlas::viewer {

void draw_views_section(Ui& ui) {
    Session& session = ui.session;
    if (session.model() == nullptr || !section(ui, "views", "Views")) return;
    std::vector<SessionFile::NamedView>& kept = session.settings.bookmarks;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const float room = ImGui::GetContentRegionAvail().x - ui.points(80);
        if (ImGui::Selectable(shown(ui, kept[i].name), false, 0, {room, 0}))
            session.go_to_bookmark(i);
        ui.spots.note("view:" + kept[i].name);
        tip(ui, "A click goes there");
        ImGui::SameLine();
        const bool removed = button(ui, fmt::format("view.{}.remove", i).c_str(), "Remove", -1);
        tip(ui, "Remove this view from the kept ones");
        ImGui::PopID();
        if (!removed) continue;
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
        return session.changed();
    }
    if (button(ui, "views.add", "Keep this view", -1)) session.add_bookmark();
    tip(ui, "Kept in the session; a click goes there (B)");
    if (button(ui, "save.camera", "Save the camera", -1)) save_as(ui, SavedKind::camera);
    tip(ui, "As JSON, for --camera-path");
    slider(ui, "record.frames", "Pictures", ui.record_frames, 2, 500, "%d", "Of a recording");
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    using Move = Session::Move;
    if (button(ui, "record.turntable", "Record a turn", half))
        session.start_recording(Move::turntable, ui.folder, ui.record_frames);
    tip(ui, "A turn about the model as pictures, and as video where ffmpeg is installed");
    ImGui::SameLine(0, gap);
    if (button(ui, "record.views", "Record the views", half))
        session.start_recording(Move::kept_views, ui.folder, ui.record_frames);
    tip(ui, "From each kept view to the next one");
}

} // namespace lineatlas::viewer
