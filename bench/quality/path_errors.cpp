#include "path_errors.hpp"

#include <fmt/core.h>

namespace lineatlas::bench {

PathFigures figures_of(const Certificate& paths, const DrawingErrors& ink) {
    PathFigures figures;
    figures.visible = paths.narrow.visible;
    figures.undecided = paths.narrow.undecided;
    figures.missed = paths.narrow.missed_pixels();
    figures.false_drawn = paths.narrow.false_pixels();
    figures.off = paths.narrow.off;
    figures.missed_wide = paths.wide.missed_pixels();
    figures.false_drawn_wide = paths.wide.false_pixels();
    if (paths.strict) {
        figures.decided = paths.strict->decided;
        figures.hidden = paths.strict->hidden;
        figures.surely_wrong = paths.strict->surely_wrong_pixels();
    }
    figures.ink = ink.drawn;
    figures.missed_ink = ink.missed_pixels();
    figures.false_ink = ink.false_pixels();
    figures.ink_visible = ink.visible;
    figures.paths = paths.paths;
    figures.gaps = paths.gaps.size();
    return figures;
}

void print_paths_header() {
    fmt::print(
        "{:<28}{:>6}{:>11}{:>9}{:>10}{:>10}{:>10}{:>10}{:>10}{:>8}{:>8}{:>11}{:>11}{:>7}{:>6}\n",
        "paths", "method", "visible px", "undec. %", "missed %", "false %", "mis1.5 %", "fal1.5 %",
        "hidden %", "sure px", "off px", "mis. ink %", "false ink %", "paths", "gaps");
}

void print_paths(const PathReport& report) {
    const PathFigures& f = report.figures;
    const auto percent = [&](double pixels) {
        return f.visible > 0 ? 100 * pixels / f.visible : 0;
    };
    fmt::print(
        "{:<28}{:>6}{:>11.0f}{:>9.1f}{:>10.4f}{:>10.4f}{:>10.4f}{:>10.4f}{:>10.3f}{:>8.2f}{:>8.3f}"
        "{:>11.4f}{:>11.4f}{:>7}{:>6}\n",
        report.name, report.method, f.visible, percent(f.undecided), percent(f.missed),
        percent(f.false_drawn), percent(f.missed_wide), percent(f.false_drawn_wide),
        100 * f.hidden_share(), f.surely_wrong, f.off, 100 * f.missed_ink_share(),
        100 * f.false_ink_share(), f.paths, f.gaps);
}

} // namespace lineatlas::bench
