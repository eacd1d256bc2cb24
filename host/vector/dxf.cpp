#include <array>
#include <utility>

#include "check_drawing.hpp"
#include "dxf_entities.hpp"
#include "dxf_tables.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

std::string to_dxf(const VectorDrawing& drawing, const DxfOptions& options) {
    check_drawing(drawing);
    const Sheet sheet = lay_out(drawing.size, options.page, options.margin, Unit::mm);
    const std::vector<LineGroup> groups = line_groups(drawing);
    DxfLayers layers;
    add_layers(layers, groups, sheet);
    add_fill_layer(layers, drawing);

    DxfText body;
    DxfEntities writer{body, write_tables(body, layers, sheet.size), sheet.size.y};
    body.begin_section("ENTITIES");
    for (const VectorFill& fill : drawing.fills)
        writer.write(fill, sheet, {.layer = fill_layer, .tags = true});
    for (std::size_t i = 0; i < groups.size(); ++i)
        writer.write(groups[i], sheet, {options.curves, options.fit_arcs},
                     {.layer = layers.layers[i].name, .tags = !drawing.travel}); // as of SVG
    body.end_section();
    const std::array comments{options.description, options.certificate};
    return dxf_file(std::move(body), sheet.size, comments);
}

} // namespace lineatlas
