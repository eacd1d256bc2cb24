#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "dxf_text.hpp"
#include "line_groups.hpp"
#include "lineatlas/sheet.hpp"
#include "outline.hpp"
#include "pen_stroke.hpp"

namespace lineatlas {

/// The layer and the look of entities.
struct DxfLook {
    std::string_view layer{};
    bool tags = false;   ///< what the file calls edges and faces, as extended data
    int line_weight = 0; ///< hundredths of a millimetre; 0: that of the layer
};

/// Outlines as entities of one block. y goes up in DXF, so arcs turn the other way.
class DxfEntities {
  public:
    using Handle = DxfText::Handle;

    /// `height`: of the page.
    DxfEntities(DxfText& text, Handle block, double height)
        : text_(text), block_(block), height_(height) {}

    /// All paths of a group.
    void write(const LineGroup& group, const Sheet& sheet, const ArcChoice& arcs,
               const DxfLook& look);
    void write(const Outline& outline, const DxfLook& look);
    void write(const SheetText& text);
    /// An area as a hatch without lines.
    void write(const VectorFill& fill, const Sheet& sheet, const DxfLook& look);

  private:
    void write(const Outline& outline);
    glm::dvec2 place(glm::dvec2 at) const { return {at.x, height_ - at.y}; }
    void begin(std::string_view type, std::string_view subclass,
               std::optional<glm::vec3> color = {});
    /// A border of a hatch.
    void write_ring(const Outline& ring);
    /// What the file calls the edge or the face that is shown.
    void end();
    /// A point or a vector in space.
    void add_in_space(int code, glm::dvec2 at, int digits);
    void add_point(int code, glm::dvec2 at, int digits = DxfText::usual_digits);
    void write_part(const Outline& outline);
    void add_circle(const VectorArc& arc);
    void write_line(const Outline& outline);
    void write_circle(const Outline& outline);
    void write_arc(const Outline& outline);
    void write_ellipse(const OutlinePoint& point, double sweep);
    /// Cubic Bézier curves in a row, as one B-spline.
    void write_spline(const std::vector<OutlinePoint>& points);
    void write_polyline(const Outline& outline);

    DxfText& text_;
    Handle block_;
    double height_;
    /// Scales dashes for an entity of this length.
    void fit_dashes(double length, bool closed = false);

    DxfLook look_{};        ///< of what is written
    std::string entities_;  ///< that it shows
    PenStroke stroke_{};    ///< of the paths that are written; no dashes: as its layer is
    double dash_scale_ = 1; ///< of the layer's linetype; 0: continuous
};

} // namespace lineatlas
