#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

constexpr std::array<const char*, 3> axis_names{"X", "Y", "Z"};

/// A cut across another axis, through the middle, with the same side gone.
Cut across(const Session& session, int axis, const Cut& cut) {
    const std::optional<int> before = axis_of(cut);
    Cut result{.normal = glm::dvec3{0}, .on = cut.on};
    result.normal[axis] = before && cut.normal[*before] < 0 ? -1 : 1;
    const Reach reach = reach_along(result.normal, session.whole_bounds(), session.origin());
    result.at = 0.5 * (reach.low + reach.high);
    return result;
}

bool axis_row(Ui& ui, const std::string& id, Cut& cut) {
    const std::optional<int> now = axis_of(cut);
    bool changed = false;
    for (int axis = 0; axis < 3; ++axis) {
        ImGui::SameLine(0, ui.points(4));
        const char* name = axis_names.at(static_cast<std::size_t>(axis));
        const bool pressed =
            toggle(ui, fmt::format("{}.{}", id, name).c_str(), name, now == axis, ui.points(28));
        tip(ui, "Across this axis");
        if (pressed && now != axis) {
            cut = across(ui.session, axis, cut);
            changed = true;
        }
    }
    return changed;
}

/// A row with the position in the file's coordinates, whichever side is gone.
bool position_row(Ui& ui, const std::string& id, Cut& cut) {
    const std::optional<int> axis = axis_of(cut);
    const double sign = axis && cut.normal[*axis] < 0 ? -1 : 1;
    const Reach reach =
        reach_along(sign * cut.normal, ui.session.whole_bounds(), ui.session.origin());
    double at = sign * cut.at;
    const bool changed = slider_with_number(ui, id, at, reach.low, reach.high, "%.4g", 0, 84);
    tip(ui, "Where it cuts, in the file's coordinates ([ and ])");
    if (changed) cut.at = sign * at;
    return changed;
}

/// What a row has done to a cut.
enum class Row { same, changed, removed };

Row row(Ui& ui, std::size_t number, Cut& cut) {
    const std::string id = fmt::format("section.{}", number);
    bool changed = ImGui::Checkbox(("##" + id).c_str(), &cut.on);
    ui.spots.note(id + ".on");
    tip(ui, "Switch this section on or off");
    changed |= axis_row(ui, id, cut);
    ImGui::SameLine(0, ui.points(12));
    if (button(ui, (id + ".flip").c_str(), "Flip")) {
        cut = flipped(cut);
        changed = true;
    }
    tip(ui, "Cut the other side away");
    ImGui::SameLine(0, ui.points(4));
    const bool removed = button(ui, (id + ".remove").c_str(), "Remove");
    tip(ui, "The section goes");
    changed |= position_row(ui, id + ".at", cut);
    if (removed) return Row::removed;
    return changed ? Row::changed : Row::same;
}

} // namespace

void draw_sections_section(Ui& ui) {
    Session& session = ui.session;
    if (session.model() == nullptr || !section(ui, "sections", "Sections")) return;
    std::vector<Cut> cuts = session.settings.shown.cuts;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const Row result = row(ui, i, cuts[i]);
        if (result == Row::removed) cuts.erase(cuts.begin() + static_cast<std::ptrdiff_t>(i));
        if (result != Row::same) return session.set_cuts(std::move(cuts));
    }
    ImGui::BeginDisabled(cuts.size() == most_sections);
    if (button(ui, "sections.add", "Add a section", -1)) session.add_cut();
    tip(ui,
        "Cuts the model, closes the cut and hatches it (C); the handle in the picture moves it");
    ImGui::EndDisabled();
}

void draw_cuts(Ui& ui, Area canvas) {
    const Session& session = ui.session;
    const auto place = [&](glm::dvec3 point) { return place_of(session, canvas, point); };
    ImDrawList& list = list_over(canvas);
    const std::vector<Cut>& cuts = session.settings.shown.cuts;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (!cuts[i].on) continue;
        const auto outline = outline_of(cuts[i], session.whole_bounds(), session.origin());
        for (std::size_t corner = 0; corner < outline.size(); ++corner) {
            const auto from = place(outline.at(corner));
            const auto to = place(outline.at((corner + 1) % outline.size()));
            if (from && to) list.AddLine(*from, *to, theme::colors().section, ui.points(1));
        }
        const glm::dvec3 middle = middle_of(cuts[i], session.whole_bounds(), session.origin());
        const std::optional<ImVec2> handle = place(middle);
        if (!handle) continue;
        // A needle shows the direction of the normal. It is equally long in every picture.
        const auto ahead =
            place(middle + 1e-3 * cuts[i].normal *
                               glm::distance(glm::dvec3{session.whole_bounds().min},
                                             glm::dvec3{session.whole_bounds().max}));
        const float radius = ui.points(8);
        if (ahead) {
            const glm::vec2 way{ahead->x - handle->x, ahead->y - handle->y};
            const float length = std::hypot(way.x, way.y);
            const float needle = ui.points(26);
            if (length > 0) {
                const glm::vec2 end = glm::vec2{handle->x, handle->y} + way * (needle / length);
                list.AddLine(*handle, {end.x, end.y}, theme::colors().section, ui.points(2.5F));
            }
        }
        list.AddCircleFilled(*handle, radius, theme::colors().section);
        list.AddCircle(*handle, radius, theme::colors().on_accent, 0, ui.points(1.5F));
        ui.spots.note(fmt::format("section.{}.handle", i),
                      {{handle->x - radius, handle->y - radius}, {2 * radius, 2 * radius}});
    }
    list.PopClipRect();
}

} // namespace lineatlas::viewer
