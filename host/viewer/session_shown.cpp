// Which parts of the model a Session shows.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "session.hpp"
#include "style/frame_settings.hpp"

namespace lineatlas::viewer {

void Session::show_parts(ShownParts shown) {
    if (model_ == nullptr || shown == settings.shown.parts) return;
    if (model_->parts.shown(*model_->whole, shown).empty())
        return messages.notice("Nothing would be left to show, so all parts stay");
    settings.shown.parts = std::move(shown);
    changed();
}

void Session::hide_selected() {
    ShownParts shown = settings.shown.parts;
    shown.hidden.insert(selected.begin(), selected.end());
    show_parts(std::move(shown));
}

void Session::isolate_selected() {
    if (!selected.empty()) show_parts(model_->parts.alone(selected, settings.shown.parts));
}

void Session::select(std::optional<std::uint32_t> part, bool adds) {
    if (!adds) selected.clear();
    if (part && selected.erase(*part) == 0) selected.insert(*part);
}

void Session::set_cuts(std::vector<Cut> cuts) {
    if (cuts == settings.shown.cuts) return;
    settings.shown.cuts = std::move(cuts);
    changed();
}

void Session::add_cut() {
    if (model_ == nullptr) return;
    std::vector<Cut> cuts = settings.shown.cuts;
    if (cuts.size() == most_sections) return messages.notice("There are six sections already");
    // The cut is across the axis nearest to the line of sight, among axes without a cut.
    const View& view = navigation.goal();
    const glm::dvec3 toward = glm::normalize(glm::dvec3{view.eye} - glm::dvec3{view.target});
    const auto taken = [&](int axis) {
        return std::ranges::count_if(cuts, [&](const Cut& cut) { return axis_of(cut) == axis; });
    };
    int best = 0;
    for (int axis = 1; axis < 3; ++axis) {
        const bool fewer = taken(axis) < taken(best);
        const bool ahead = std::abs(toward[axis]) > std::abs(toward[best]);
        if (fewer || (taken(axis) == taken(best) && ahead)) best = axis;
    }
    Cut cut{.normal = glm::dvec3{0}};
    cut.normal[best] = toward[best] < 0 ? -1 : 1;
    const Reach reach = reach_along(cut.normal, whole_bounds_, origin());
    cut.at = 0.5 * (reach.low + reach.high);
    cuts.push_back(cut);
    set_cuts(std::move(cuts));
}

std::optional<std::size_t> Session::cut_at(glm::dvec2 point, double reach) const {
    std::optional<std::size_t> nearest;
    if (model_ == nullptr) return nearest;
    const std::vector<Cut>& cuts = settings.shown.cuts;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (!cuts[i].on) continue;
        const auto seen =
            seen_at(navigation.view(), middle_of(cuts[i], whole_bounds_, origin()), size_);
        if (!seen || glm::distance(*seen, point) > reach) continue;
        reach = glm::distance(*seen, point);
        nearest = i;
    }
    return nearest;
}

void Session::drag_cut(std::size_t cut, glm::dvec2 from, glm::dvec2 to) {
    std::vector<Cut> cuts = settings.shown.cuts;
    Cut& dragged = cuts.at(cut);
    const View& view = navigation.view();
    dragged.at += way_along(dragged.normal, middle_of(dragged, whole_bounds_, origin()),
                            ray_at(view, from, size_), ray_at(view, to, size_));
    const Reach reach = reach_along(dragged.normal, whole_bounds_, origin());
    dragged.at = std::clamp(dragged.at, reach.low, reach.high);
    set_cuts(std::move(cuts));
}

void Session::set_crease(std::optional<float> degrees) {
    if (degrees == settings.shown.crease) return;
    settings.shown.crease = degrees;
    changed();
}

void Session::set_silhouettes(Silhouettes silhouettes) {
    if (model_ == nullptr) return;
    if (silhouettes == settings.shown.silhouettes.value_or(LineOptions{}.silhouettes)) return;
    const bool usual = silhouettes == LineOptions{}.silhouettes;
    settings.shown.silhouettes = usual ? std::nullopt : std::optional{silhouettes};
    changed();
}

ShownInWords Session::in_words() const {
    ShownInWords words{.crease = settings.shown.crease, .silhouettes = settings.shown.silhouettes};
    for (const std::uint32_t part : settings.shown.parts.hidden)
        words.hidden.push_back(model_->parts.pattern_of(part));
    for (const std::uint32_t part : settings.shown.parts.only)
        words.only.push_back(model_->parts.pattern_of(part));
    for (const Cut& cut : settings.shown.cuts) words.cuts.push_back({text_of(cut), cut.on});
    return words;
}

/// Takes choices in words, as far as the model has the parts that they name.
void Session::take_words(const ShownInWords& words) {
    Shown& shown = settings.shown;
    shown.crease = words.crease;
    shown.silhouettes = words.silhouettes;
    std::vector<std::string> unknown;
    ShownParts parts{.hidden = model_->parts.matching(words.hidden, unknown),
                     .only = model_->parts.matching(words.only, unknown)};
    if (!model_->parts.shown(*model_->whole, parts).empty()) shown.parts = std::move(parts);
    if (!unknown.empty()) messages.notice("No part is called \"" + unknown.front() + "\" any more");
    for (const ShownInWords::Plane& plane : words.cuts) {
        attempt([&] {
            shown.cuts.push_back(cut_from(plane.text, whole_bounds_, origin()));
            shown.cuts.back().on = plane.on;
        });
    }
}

void Session::cancel_loading() {
    loader.cancel();
    forget_awaited();
    if (model_ != nullptr) settings.shown = model_->shown;
}

std::optional<std::uint32_t> Session::part_at(glm::dvec2 point) const {
    if (model_ == nullptr) return {};
    return model_->parts.pick(*model_->whole, ray_at(navigation.view(), point, size_),
                              model_->shown.parts, model_->planes);
}

void Session::frame_selected() {
    Bounds bounds;
    for (const std::uint32_t part : selected) {
        const Bounds& own = model_->parts.all().at(part).bounds;
        bounds = {glm::min(bounds.min, own.min), glm::max(bounds.max, own.max)};
    }
    if (!(bounds.min.x <= bounds.max.x)) return; // lines alone, or nothing
    std::array<glm::vec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners.at(i) = {(i & 1U) != 0 ? bounds.max.x : bounds.min.x,
                         (i & 2U) != 0 ? bounds.max.y : bounds.min.y,
                         (i & 4U) != 0 ? bounds.max.z : bounds.min.z};
    }
    const View& view = navigation.goal();
    navigation.glide_to(frame_points_from({glm::normalize(view.eye - view.target), view.up},
                                          corners, glm::max(size_, 1), view.fov_y,
                                          view.projection));
}

/// Stops finding lines for an old choice once the choice has rested for a moment. While it keeps
/// changing, as in a drag, old lines are found to their end, so that there is something to see.
void Session::restart_stale_job(double seconds) {
    constexpr double rest = 0.15;
    wanted_rest_ = wanted_ == settings.shown ? wanted_rest_ + seconds : 0;
    wanted_ = settings.shown;
    const Shown* found = loader.shown();
    if (found != nullptr && !(*found == settings.shown) && wanted_rest_ > rest) loader.cancel();
}

/// Starts finding lines if the wanted parts and cuts differ from those shown.
void Session::show_wanted() {
    if (model_ == nullptr || loader.busy() || settings.shown == model_->shown) return;
    awaited_ = {.keeps_view = true};
    loader.start(model_, settings.shown);
}

} // namespace lineatlas::viewer
