#include "dxf_entities.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dxf_layers.hpp"
#include "dxf_tables.hpp"
#include "tags.hpp"

namespace lineatlas {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr int fine = 9; ///< digits of what is a curve's own

double from_0_to_turn(double radians) {
    const double angle = std::fmod(radians, turn);
    return angle < 0 ? angle + turn : angle;
}

double degrees(double radians) {
    return radians * 360 / turn;
}

/// The angles of an arc, the lesser first, as they are where y goes up.
std::pair<double, double> counter_clockwise(double from, double sweep) {
    return sweep > 0 ? std::pair{-(from + sweep), -from} : std::pair{-from, -(from + sweep)};
}

/// "entity #12, #15": as many as a line of extended data holds.
std::string entities_text(const VectorPath& path) {
    constexpr std::size_t longest = 250;
    std::string text;
    for (const std::string& entity : entities_of(path)) {
        if (text.size() + entity.size() + 2 > longest) break;
        text += (text.empty() ? "entity " : ", ") + entity;
    }
    return text;
}

} // namespace

void DxfEntities::write(const LineGroup& group, const Sheet& sheet, const ArcChoice& arcs,
                        const DxfLook& look) {
    look_ = look;
    stroke_ = pen_stroke(group.pen, sheet);
    for (const VectorPath& path : group.paths) {
        entities_ = look.tags ? entities_text(path) : std::string{};
        write(outline_of(path, sheet, arcs));
    }
    stroke_ = {};
    dash_scale_ = 1;
}

void DxfEntities::fit_dashes(double length, bool closed) {
    if (!stroke_.dashes.empty()) dash_scale_ = dash_scale(stroke_, length, closed);
}

void DxfEntities::write(const Outline& outline, const DxfLook& look) {
    look_ = look;
    entities_.clear();
    write(outline);
}

void DxfEntities::write(const SheetText& text) {
    look_ = {.layer = text.layer};
    begin("TEXT", "AcDbText");
    add_point(10, text.at);
    text_.add(40, text.height);
    text_.add(1, dxf_line(text.text));
    if (text.upward) text_.add(50, 90.0);
    const bool aligned = text.anchor != TextAnchor::start;
    if (aligned) text_.add(72, static_cast<int>(text.anchor));
    if (aligned) add_point(11, text.at);
    text_.add(100, "AcDbText");
}

/// An ellipse is an entity of its own. So are cubics in a row, and the part between two such
/// entities.
void DxfEntities::write(const Outline& outline) {
    const std::vector<OutlinePoint>& points = outline.points;
    if (std::ranges::none_of(points, &OutlinePoint::is_apart)) return write_part(outline);
    if (outline.is_round()) return write_ellipse(points[0], turn);
    const std::size_t count = points.size(), steps = count - (outline.closed ? 0 : 1);
    std::size_t first = 0;
    if (outline.closed) // a loop begins behind one of them
        while (!points[(first + count - 1) % count].is_apart()) ++first;
    Outline part;
    const auto end_part = [&](glm::dvec2 at) {
        if (part.points.empty()) return;
        const bool cubics = part.points.front().cubic.has_value();
        part.points.push_back({at});
        if (cubics)
            write_spline(part.points);
        else
            write_part(part);
        part.points.clear();
    };
    for (std::size_t i = 0; i < steps; ++i) {
        const OutlinePoint& point = points[(first + i) % count];
        const bool goes_on = !part.points.empty() &&
                             part.points.front().cubic.has_value() == point.cubic.has_value();
        if (point.is_elliptic() || !goes_on) end_part(point.at);
        if (point.is_elliptic())
            write_ellipse(point, point.arc->sweep);
        else
            part.points.push_back(point);
    }
    end_part(points[(first + steps) % count].at);
}

void DxfEntities::write(const VectorFill& fill, const Sheet& sheet, const DxfLook& look) {
    look_ = look;
    entities_ = look.tags && !fill.object.empty() ? "object " + dxf_line(fill.object) : "";
    const std::vector<Outline> rings = outlines_of(fill, sheet);
    begin("HATCH", "AcDbHatch", fill.color);
    add_in_space(10, {0, 0}, 1);
    text_.add(210, 0.0);
    text_.add(220, 0.0);
    text_.add(230, 1.0);
    text_.add(2, "SOLID");
    text_.add(70, 1); // filled
    text_.add(71, 0); // follows no other entities
    text_.add(91, static_cast<int>(rings.size()));
    for (const Outline& ring : rings) write_ring(ring);
    text_.add(75, 0); // inside of an odd number of borders
    text_.add(76, 1);
    text_.add(98, 0);
    end();
}

void DxfEntities::write_ring(const Outline& ring) {
    text_.add(92, 2); // a polyline
    text_.add(72, 0); // without bulges
    text_.add(73, 1); // closed
    text_.add(93, static_cast<int>(ring.points.size()));
    for (const OutlinePoint& point : ring.points) text_.add(10, place(point.at));
    text_.add(97, 0);
}

void DxfEntities::begin(std::string_view type, std::string_view subclass,
                        std::optional<glm::vec3> color) {
    text_.begin(type, block_);
    text_.add(100, "AcDbEntity");
    text_.add(8, look_.layer);
    if (dash_scale_ == 0) text_.add(6, "CONTINUOUS");
    if (color) text_.add(62, nearest_index(*color));
    if (color) text_.add(420, whole_color(*color));
    if (look_.line_weight != 0) text_.add(370, look_.line_weight);
    if (dash_scale_ != 0 && dash_scale_ != 1) text_.add(48, dash_scale_);
    text_.add(100, subclass);
}

void DxfEntities::end() {
    if (entities_.empty()) return;
    text_.add(1001, dxf_application);
    text_.add(1000, entities_);
}

void DxfEntities::add_in_space(int code, glm::dvec2 at, int digits) {
    text_.add(code, at.x, digits);
    text_.add(code + 10, at.y, digits);
    text_.add(code + 20, 0.0);
}

void DxfEntities::add_point(int code, glm::dvec2 at, int digits) {
    add_in_space(code, place(at), digits);
}

void DxfEntities::write_line(const Outline& outline) {
    begin("LINE", "AcDbLine");
    add_point(10, outline.points[0].at);
    add_point(11, outline.points[1].at);
    end();
}

void DxfEntities::write_part(const Outline& outline) {
    const std::vector<OutlinePoint>& points = outline.points;
    fit_dashes(length_of(outline), outline.closed);
    if (outline.is_round()) return write_circle(outline);
    if (points.size() == 2 && !outline.closed && points[0].bulge != 0) return write_arc(outline);
    if (points.size() == 2 && !outline.closed) return write_line(outline);
    write_polyline(outline);
}

void DxfEntities::add_circle(const VectorArc& arc) {
    add_point(10, arc.center, fine);
    text_.add(40, arc.major.x, fine);
}

void DxfEntities::write_circle(const Outline& outline) {
    begin("CIRCLE", "AcDbCircle");
    add_circle(arc_between(outline.points[0], outline.points[1].at));
    end();
}

void DxfEntities::write_arc(const Outline& outline) {
    begin("ARC", "AcDbCircle");
    const VectorArc arc = arc_between(outline.points[0], outline.points[1].at);
    add_circle(arc);
    text_.add(100, "AcDbArc");
    const auto [from, to] = counter_clockwise(arc.from, arc.sweep);
    text_.add(50, degrees(from_0_to_turn(from)), fine);
    text_.add(51, degrees(from_0_to_turn(to)), fine);
    end();
}

void DxfEntities::write_ellipse(const OutlinePoint& point, double sweep) {
    VectorArc arc = *point.arc;
    arc.sweep = sweep;
    const bool whole = std::abs(sweep) >= turn;
    fit_dashes(length_of(arc), whole);
    begin("ELLIPSE", "AcDbEllipse");
    add_point(10, arc.center, fine);
    add_in_space(11, {arc.major.x, -arc.major.y}, fine);
    text_.add(40, arc.ratio, fine);
    const auto [from, to] = counter_clockwise(arc.from, sweep);
    const double start = whole ? 0 : from_0_to_turn(from);
    text_.add(41, start, fine);
    text_.add(42, start + (whole ? turn : to - from), fine);
    end();
}

void DxfEntities::write_spline(const std::vector<OutlinePoint>& points) {
    fit_dashes(length_of(Outline{.points = points, .closed = false}));
    begin("SPLINE", "AcDbSpline");
    const int count = static_cast<int>(points.size()) - 1;
    constexpr int planar = 8, degree = 3;
    text_.add(70, planar);
    text_.add(71, degree);
    text_.add(72, degree * count + 1 + degree + 1);
    text_.add(73, degree * count + 1);
    text_.add(74, 0);
    for (int knot = 0; knot <= count; ++knot)
        for (int k = knot == 0 || knot == count ? -1 : 0; k < degree; ++k)
            text_.add(40, static_cast<double>(knot));
    add_point(10, points.front().at);
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        add_point(10, points[at].cubic->first_control);
        add_point(10, points[at].cubic->last_control);
        add_point(10, points[at + 1].at);
    }
    end();
}

void DxfEntities::write_polyline(const Outline& outline) {
    begin("LWPOLYLINE", "AcDbPolyline");
    text_.add(90, static_cast<int>(outline.points.size()));
    const int closed = outline.closed ? 1 : 0;
    const int through = stroke_.dashes.empty() ? 0 : 128; // dashes go on around vertices
    text_.add(70, closed + through);
    for (const OutlinePoint& point : outline.points) {
        text_.add(10, place(point.at));
        if (point.bulge != 0) text_.add(42, -point.bulge, 9); // it stands for an angle
    }
    end();
}

} // namespace lineatlas
