#include <array>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "widgets.hpp"

namespace lineatlas::viewer {

void draw_distances(Ui& ui, Area canvas) {
    const Session& session = ui.session;
    const auto place = [&](glm::dvec3 point) { return place_of(session, canvas, point); };
    ImDrawList& list = list_over(canvas);
    const ImU32 color = theme::colors().measure;
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
        plate(ui, text, 0.5F * glm::vec2{from->x + to->x, from->y + to->y}, {0.5F, 0.5F});
    }
    list.PopClipRect();
}

} // namespace lineatlas::viewer
