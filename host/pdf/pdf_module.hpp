#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lineatlas::pdf {

/// The next part of a way: a straight line or a cubic from the current point, or an arc of an
/// ellipse. A point of the arc is center + cos(t) major + sin(t) minor; the minor half axis is
/// turned by a quarter from the major one, from x towards y.
struct Step {
    bool arc = false, cubic = false;
    /// End of a straight line or of a cubic Bézier curve.
    glm::dvec2 to{0};
    glm::dvec2 first_control{0}, last_control{0}; ///< control points of the curve
    glm::dvec2 center{0};
    glm::dvec2 major{1, 0};
    double ratio = 1; ///< ratio of the minor half axis to the major one
    double from = 0;  ///< t, radians
    double sweep = 0; ///< negative: towards smaller t
};

struct Way {
    glm::dvec2 start{0};
    std::vector<Step> steps;
    bool closed = false;
    double dash_scale = 1; ///< of Strokes::dashes; 0: the way is solid
};

enum class Join { mitre, round, bevel };

/// Ways drawn alike, one after the other.
struct Strokes {
    glm::vec3 color{0};
    double opacity = 1;
    double width = 1;
    Join join = Join::mitre;
    double mitre_limit = 4;
    bool round_caps = false;    ///< false: cut square
    std::vector<double> dashes; ///< on, off; empty: solid
    std::vector<Way> ways;
};

/// An area of one colour.
struct Area {
    glm::vec3 color{0};
    std::vector<Way> borders; ///< closed; even and odd
};

/// A line of text.
struct Text {
    glm::vec3 color{0};
    glm::dvec2 at{0};    ///< a point on the line that letters stand on
    double height = 7;   ///< of capital letters
    std::string text;    ///< UTF-8
    double before = 0;   ///< share of the text's width before the point, 0 to 1
    bool upward = false; ///< true: reads from below to above; false: from left to right
};

/// A document of one page. Lengths are points, 72 to an inch, from its upper left corner, y down.
struct Page {
    glm::dvec2 size{1};
    std::optional<glm::vec3> background;
    std::string title, subject; ///< UTF-8
    std::vector<Area> areas;    ///< below all else, none over another
    std::vector<Strokes> strokes;
    std::vector<Text> texts;
};

/// Pixels row by row from the upper left one: red, green, blue and alpha, 8 bits each. Colours are
/// not multiplied by alpha.
struct Pixels {
    int width = 0, height = 0;
    std::vector<unsigned char> values;
};

/// The functions of the module lineatlas-pdf, the only one that links cairo. It refuses a page by a
/// std::runtime_error that says the cause in one line.
struct Module {
    std::string (*write)(const Page& page);
    /// Paints the page as a picture with `scale` pixels per point.
    Pixels (*paint)(const Page& page, double scale);
};

/// The module's one symbol. Its number changes with `Module`.
inline constexpr const char* module_symbol = "lineatlas_pdf_4";

} // namespace lineatlas::pdf

extern "C" const lineatlas::pdf::Module lineatlas_pdf_4;
