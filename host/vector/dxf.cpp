#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "check_drawing.hpp"
#include "dxf_tables.hpp"
#include "lineatlas/vector.hpp"
#include "outline.hpp"

namespace lineatlas {
namespace {

using Handle = DxfText::Handle;

double degrees_from_0_to_360(double radians) {
    const double degrees = std::fmod(radians * 180 / std::numbers::pi, 360);
    return degrees < 0 ? degrees + 360 : degrees;
}

/// Outlines as entities of one block. y goes up in DXF: what turned one way turns the other.
class EntityWriter {
  public:
    EntityWriter(DxfText& text, Handle block, double height)
        : text_(text), block_(block), height_(height) {}

    void write(const Outline& outline, std::string_view layer) {
        const std::vector<OutlinePoint>& points = outline.points;
        if (outline.is_circle()) return write_circle(outline, layer);
        if (points.size() == 2 && !outline.closed && points[0].bulge != 0)
            return write_arc(outline, layer);
        if (points.size() == 2 && !outline.closed) return write_line(outline, layer);
        write_polyline(outline, layer);
    }

  private:
    glm::dvec2 place(glm::dvec2 at) const { return {at.x, height_ - at.y}; }

    void begin(std::string_view type, std::string_view subclass, std::string_view layer) {
        text_.begin(type, block_);
        text_.add(100, "AcDbEntity");
        text_.add(8, layer);
        text_.add(100, subclass);
    }

    /// A point in space.
    void add_point(int code, glm::dvec2 at) {
        text_.add(code, place(at));
        text_.add(code + 20, 0.0);
    }

    void write_line(const Outline& outline, std::string_view layer) {
        begin("LINE", "AcDbLine", layer);
        add_point(10, outline.points[0].at);
        add_point(11, outline.points[1].at);
    }

    void write_circle(const Outline& outline, std::string_view layer) {
        begin("CIRCLE", "AcDbCircle", layer);
        const Arc arc = arc_between(outline.points[0], outline.points[1].at);
        add_point(10, arc.center);
        text_.add(40, arc.radius);
    }

    void write_arc(const Outline& outline, std::string_view layer) {
        begin("ARC", "AcDbCircle", layer);
        const Arc arc = arc_between(outline.points[0], outline.points[1].at);
        add_point(10, arc.center);
        text_.add(40, arc.radius);
        text_.add(100, "AcDbArc");
        // Counter-clockwise, which is what a negative sweep becomes.
        double from = -arc.from, to = -(arc.from + arc.sweep);
        if (arc.sweep > 0) std::swap(from, to);
        text_.add(50, degrees_from_0_to_360(from));
        text_.add(51, degrees_from_0_to_360(to));
    }

    void write_polyline(const Outline& outline, std::string_view layer) {
        begin("LWPOLYLINE", "AcDbPolyline", layer);
        text_.add(90, static_cast<int>(outline.points.size()));
        text_.add(70, outline.closed ? 1 : 0);
        for (const OutlinePoint& point : outline.points) {
            text_.add(10, place(point.at));
            if (point.bulge != 0) text_.add(42, -point.bulge, 9); // it stands for an angle
        }
    }

    DxfText& text_;
    Handle block_;
    double height_;
};

/// A line of it has at most so many characters (AutoCAD's limit is 2049).
void add_comment(DxfText& text, std::string_view comment) {
    constexpr std::size_t longest = 250;
    const std::string line = dxf_line(comment);
    for (std::size_t at = 0; at < line.size(); at += longest)
        text.add(999, std::string_view{line}.substr(at, longest));
}

} // namespace

std::string to_dxf(const VectorDrawing& drawing, const DxfOptions& options) {
    check_drawing(drawing);
    const Sheet sheet = lay_out(drawing.size, options.page, options.margin, Unit::mm);
    const std::vector<LineGroup> groups = line_groups(drawing);
    const DxfLayers layers = dxf_layers(groups, sheet);

    DxfText body;
    EntityWriter writer{body, write_tables(body, layers, sheet.size), sheet.size.y};
    body.begin_section("ENTITIES");
    for (std::size_t i = 0; i < groups.size(); ++i) {
        for (const VectorPath& path : groups[i].paths)
            writer.write(outline_of(path, sheet, options.fit_arcs), layers.layers[i].name);
    }
    body.end_section();
    write_objects(body);
    body.add(0, "EOF");

    DxfText text;
    add_comment(text, options.description);
    add_comment(text, options.certificate);
    text.append(dxf_header(sheet.size, body.last_handle()));
    text.append(body);
    return text.take();
}

} // namespace lineatlas
