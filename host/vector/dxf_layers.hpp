#pragma once

#include <span>
#include <string>
#include <vector>

#include "line_groups.hpp"
#include "pen_stroke.hpp"

namespace lineatlas {

/// The pattern of a dashed line, in millimetres.
struct DxfLinetype {
    std::string name;
    std::vector<double> dashes; ///< PenStroke::dashes
};

/// A layer and how all that lies on it is drawn.
struct DxfLayer {
    std::string name;
    std::string linetype; ///< "CONTINUOUS" or that of a DxfLinetype
    int color_index;      ///< the nearest of AutoCAD's, for programs that know no others
    int color;            ///< 0xRRGGBB
    int line_weight;      ///< hundredths of a millimetre: the nearest of ISO 128's
    bool shown = true;
};

struct DxfLayers {
    std::vector<DxfLinetype> linetypes;
    std::vector<DxfLayer> layers;
};

/// Adds one per group, in their order.
void add_layers(DxfLayers& to, std::span<const LineGroup> groups, const Sheet& sheet,
                const std::string& prefix = {});

/// Adds that of fills, if the drawing has any; hatches have colours of their own.
void add_fill_layer(DxfLayers& to, const VectorDrawing& drawing, const std::string& prefix = {});

/// The nearest of AutoCAD's colours, for programs that know no others, and the colour, 0xRRGGBB.
int nearest_index(glm::vec3 color);
int whole_color(glm::vec3 color);

/// A layer of a sheet's own, in the colour of a pen.
DxfLayer own_layer(const std::string& name, const Pen& pen);

/// The nearest of ISO 128-20, hundredths of a millimetre.
int nearest_weight(double millimetres);

} // namespace lineatlas
