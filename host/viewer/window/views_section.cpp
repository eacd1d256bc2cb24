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
        if (ImGui::Selectable(kept[i].name.c_str(), false, 0, {room, 0})) session.go_to_bookmark(i);
        ui.spots.note("view:" + kept[i].name);
        ImGui::SameLine();
        const bool removed = button(ui, fmt::format("view.{}.remove", i).c_str(), "Remove", -1);
        ImGui::PopID();
        if (!removed) continue;
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
        return session.changed();
    }
    if (button(ui, "views.add", "Keep this view", -1)) session.add_bookmark();
    tip("Kept in the session; a click goes there (B)");
}

} // namespace lineatlas::viewer
