#pragma once

#include <cstddef>
#include <string>

#include "truth/certificate.hpp"

// Errors of drawings as paths and as pictures of pixels.
namespace lineatlas::bench {

/// The figures of one view; lengths in pixels.
struct PathFigures {
    double visible = 0, undecided = 0;
    double missed = 0, false_drawn = 0; ///< within 0.5 px
    double off = 0;                     ///< largest distance of drawn places that are not false
    double missed_wide = 0, false_drawn_wide = 0; ///< within 1.5 px
    double decided = 0, hidden = 0;               ///< checked against each piece's own segment
    double surely_wrong = 0;
    double ink = 0; ///< dark pixels
    double missed_ink = 0, false_ink = 0;
    double ink_visible = 0; ///< the ink of all visible lines; `missed_ink` is a part of it
    std::size_t paths = 0;  ///< number of visible paths
    std::size_t gaps = 0;   ///< number of gaps between ends that nearly meet

    double missed_share() const { return share(missed, visible); }
    double false_share() const { return share(false_drawn, visible); }
    double hidden_share() const { return share(hidden, decided); }
    double missed_ink_share() const { return share(missed_ink, ink_visible); }
    double false_ink_share() const { return share(false_ink, ink); }

  private:
    static double share(double part, double whole) { return whole > 0 ? part / whole : 0; }
};

/// The figures of one view, by its paths and its picture.
PathFigures figures_of(const Certificate& paths, const DrawingErrors& ink);

struct PathReport {
    std::string name; ///< of the subject and the view
    std::string method;
    PathFigures figures;
};

void print_paths_header();
void print_paths(const PathReport& report);

} // namespace lineatlas::bench
