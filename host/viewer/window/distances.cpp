#include <array>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "widgets.hpp"

namespace lineatlas::viewer {

void draw_distances(const Ui& ui, Area canvas) {
    const Session& session = ui.session;
    const auto place = [&](glm::dvec3 point) { return place_of(session, canvas, point); };
    ImDrawList& list = list_over(canvas);
    const ImU32 color = theme::colors().accent;
    const auto end = [&](const ImVec2& at) { list.AddCircleFilled(at, ui.points(4), color); };
    if (const auto& from = session.measured_from()) {
        if (const auto at = place(*from)) end(*at);
    }
    for (const std::array<glm::dvec3, 2>& distance : session.settings.distances) {
        const auto from = place(distance[0]), to = place(distance[1]);
        if (!from || !to) continue;
        list.AddLine(*from, *to, color, ui.points(1.5F));
        end(*from);
        end(*to);
        const std::string text = session.length_text(glm::distance(distance[0], distance[1]));
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        const ImVec2 low{0.5F * (from->x + to->x - size.x), 0.5F * (from->y + to->y - size.y)};
        const float pad = ui.points(5);
        list.AddRectFilled({low.x - pad, low.y - pad / 2},
                           {low.x + size.x + pad, low.y + size.y + pad / 2}, theme::colors().panel,
                           ui.points(4));
        list.AddText(low, theme::colors().ink, text.c_str());
    }
    list.PopClipRect();
}

} // namespace lineatlas::viewer
