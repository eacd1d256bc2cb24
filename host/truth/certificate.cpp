#include "certificate.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace lineatlas {
namespace {

constexpr double wide_reach = 1.5;
constexpr double narrow_reach = 0.5;
constexpr float place_size = 12; ///< pixels; wrong points nearer together are one place

/// Wrong points that lie together.
struct Place {
    glm::vec2 at; ///< of the first point
    double pixels = 0;
};

std::vector<Place> worst_places(const std::vector<WrongPoint>& points, std::size_t count) {
    std::map<std::pair<int, int>, Place> cells;
    for (const WrongPoint& point : points) {
        const glm::ivec2 cell{glm::floor(point.at / place_size)};
        const auto [entry, fresh] = cells.try_emplace({cell.x, cell.y}, Place{point.at});
        entry->second.pixels += double{point.pixels};
    }
    std::vector<Place> places;
    for (const auto& [cell, place] : cells) places.push_back(place);
    std::ranges::stable_sort(places, std::ranges::greater{}, &Place::pixels);
    places.resize(std::min(count, places.size()));
    return places;
}

std::string row(const char* what, double share, double pixels) {
    return fmt::format("{:<28}{:>9.4f} %{:>11.2f} px\n", what, 100 * share, pixels);
}

std::string place_rows(const char* what, const std::vector<WrongPoint>& points, std::size_t count) {
    std::string text;
    for (const Place& place : worst_places(points, count)) {
        text += fmt::format("  {:<13}{:>8.2f} px at {:.1f},{:.1f}\n", what, place.pixels,
                            place.at.x, place.at.y);
    }
    return text;
}

} // namespace

Certificate compare_lines(const EdgeTruth& truth, const DrawnLines& drawn) {
    return {.wide = compare_paths(truth, drawn.legs, wide_reach),
            .narrow = compare_paths(truth, drawn.legs, narrow_reach),
            .paths = drawn.path_ends.size(),
            .gaps = gaps_of(drawn, truth.size())};
}

std::string certificate_line(const Certificate& certificate) {
    const DrawingErrors& wide = certificate.wide;
    const DrawingErrors& narrow = certificate.narrow;
    std::string text = fmt::format(
        "checked by rays: {:.1f} pixels of line are visible; missed {:.4f} % within {:g} pixels, "
        "{:.4f} % within {:g}; false {:.4f} % and {:.4f} %; of the rest the worst place is {:.2f} "
        "pixels off",
        wide.visible, 100 * wide.missed_share(), wide.reach, 100 * narrow.missed_share(),
        narrow.reach, 100 * wide.false_share(), 100 * narrow.false_share(), narrow.off);
    if (certificate.strict) {
        text += fmt::format("; by their own edges {:.4f} % hidden, {:.2f} pixels surely wrong",
                            100 * certificate.strict->hidden_share(),
                            certificate.strict->surely_wrong_pixels());
    }
    return text;
}

std::string certificate_table(const Certificate& certificate, std::size_t places) {
    const DrawingErrors& wide = certificate.wide;
    const DrawingErrors& narrow = certificate.narrow;
    std::string text = fmt::format("{:<28}{:>22.2f} px\n{:<28}{:>22.2f} px\n", "truly visible",
                                   wide.visible, "undecided", wide.undecided);
    text += row("missed within 1.5 px", wide.missed_share(), wide.missed_pixels());
    text += row("false within 1.5 px", wide.false_share(), wide.false_pixels());
    text += row("missed within 0.5 px", narrow.missed_share(), narrow.missed_pixels());
    text += row("false within 0.5 px", narrow.false_share(), narrow.false_pixels());
    text += fmt::format("{:<28}{:>22.2f} px at {:.1f},{:.1f}\n", "farthest off of the rest",
                        narrow.off, narrow.off_at.x, narrow.off_at.y);
    if (const auto& strict = certificate.strict) {
        text += row("hidden by their own edges", strict->hidden_share(), strict->hidden);
        text += fmt::format("{:<28}{:>22.2f} px\n", "surely wrong", strict->surely_wrong_pixels());
    }
    text += fmt::format("{:<28}{:>9}\n{:<28}{:>9}\n", "visible paths", certificate.paths,
                        "gaps between ends", certificate.gaps.size());
    std::string worst = place_rows("missed", narrow.missed, places) +
                        place_rows("false", narrow.false_drawn, places);
    if (certificate.strict)
        worst += place_rows("surely wrong", certificate.strict->surely_wrong, places);
    for (std::size_t i = 0; i < std::min(places, certificate.gaps.size()); ++i) {
        const Gap& gap = certificate.gaps[i];
        worst += fmt::format("  {:<13}{:>8.2f} px at {:.1f},{:.1f}\n", "gap", gap.width, gap.at.x,
                             gap.at.y);
    }
    if (!worst.empty()) text += "Worst places, from the upper left corner:\n" + worst;
    return text;
}

} // namespace lineatlas
