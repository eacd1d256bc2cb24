#include "effects.hpp"

#include <algorithm>

namespace lineatlas::bench {
namespace {

struct Effect {
    std::string_view name;
    void (*apply)(Style&);
};

void overshoot(Style& style) {
    style.filter.overshoot = 8;
}
void holes(Style& style) {
    style.filter.fill_holes = 4;
    style.filter.drop_runs = 4;
}
void halo(Style& style) {
    style.filter.halo = 4;
}
void density(Style& style) {
    style.density.limit = 0.3F;
}
void focus(Style& style) {
    style.focus.on = true;
}
void round_joins(Style& style) {
    style.pen.join = Join::round;
}
void taper(Style& style) {
    style.pen.cap = style.pen.path_cap = Cap::taper;
}
void profile(Style& style) {
    style.pen.width_profile = {0.5F, 1, 0.5F};
}
void grain(Style& style) {
    style.paper.grain = 0.3F;
}
void hidden(Style& style) {
    style.hidden = true;
}
void fill(Style& style) {
    style.fill.mode = FillMode::lambert;
}
void all(Style& style) {
    for (const auto apply : {overshoot, holes, halo, density, focus}) apply(style);
}

constexpr Effect effects[] = {
    {"overshoot", overshoot}, {"holes", holes}, {"halo", halo},       {"density", density},
    {"focus", focus},         {"taper", taper}, {"profile", profile}, {"round joins", round_joins},
    {"paper's grain", grain}, {"all", all},     {"hidden", hidden},   {"fill", fill},
};

} // namespace

std::vector<Drawn> effect_drawings() {
    const FrameOptions plain = method_options(method_spec("SAhi"));
    std::vector<Drawn> drawings{{"none", plain}};
    for (const Effect& effect : effects) {
        Drawn& drawn = drawings.emplace_back(std::string{effect.name}, plain);
        effect.apply(drawn.options.style);
    }
    return drawings;
}

std::optional<double> effect_cost(const Report& report, std::string_view name) {
    const SceneResult* row = report.scene(effects_row);
    if (row == nullptr) return std::nullopt;
    const Measured* plain = row->method("none");
    const Measured* with = row->method(name);
    if (plain == nullptr || with == nullptr) return std::nullopt;
    return paired_ratio(*with, *plain);
}

std::vector<std::string_view> stroke_effects() {
    std::vector<std::string_view> names;
    for (const Effect& effect : effects) {
        if (effect.apply != hidden && effect.apply != fill) names.push_back(effect.name);
    }
    return names;
}

} // namespace lineatlas::bench
