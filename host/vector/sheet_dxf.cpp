#include <array>
#include <string>
#include <utility>
#include <vector>

#include "dxf_entities.hpp"
#include "dxf_tables.hpp"
#include "sheet_writing.hpp"

namespace lineatlas {
namespace {

Outline outline_of(const SheetLine& line) {
    Outline outline;
    for (const glm::dvec2 point : line.points) outline.points.push_back({point});
    outline.closed = line.points.size() > 2 && line.points.front() == line.points.back();
    if (outline.closed) outline.points.pop_back();
    return outline;
}

/// Two halves.
Outline outline_of(const SheetCircle& circle) {
    const glm::dvec2 right{circle.radius, 0};
    return {.points = {{.at = circle.center + right, .bulge = 1},
                       {.at = circle.center - right, .bulge = 1}},
            .closed = true};
}

/// What the sheet has of its own.
void write_own(DxfEntities& writer, const SheetLayout& layout) {
    const auto write = [&](const auto& mark) {
        writer.write(outline_of(mark),
                     {.layer = mark.layer, .line_weight = nearest_weight(mark.width)});
    };
    for (const SheetLine& line : layout.lines) write(line);
    for (const SheetCircle& circle : layout.circles) write(circle);
    for (const SheetText& text : layout.texts) writer.write(text);
}

} // namespace

std::string to_dxf(const VectorSheet& sheet, const SheetWriting& writing) {
    check_sheet(sheet);
    const glm::dvec2 size = sheet.layout.size;
    DxfLayers layers;
    std::vector<std::vector<LineGroup>> groups; // of each view
    for (std::size_t i = 0; i < sheet.drawings.size(); ++i) {
        const SheetView& view = sheet.layout.views[i];
        groups.push_back(line_groups(sheet.drawings[i]));
        add_layers(layers, groups.back(), place_of(view, size), name_in_file(view) + "-");
    }
    for (std::size_t i = 0; i < sheet.drawings.size(); ++i)
        add_fill_layer(layers, sheet.drawings[i], name_in_file(sheet.layout.views[i]) + "-");
    for (const std::string& own : own_layers(sheet.layout))
        layers.layers.push_back(own_layer(own, style_of(sheet).pen));

    DxfText body;
    DxfEntities writer{body, write_tables(body, layers, size), size.y};
    body.begin_section("ENTITIES");
    for (std::size_t i = 0; i < sheet.drawings.size(); ++i) {
        const SheetView& view = sheet.layout.views[i];
        const std::string own = name_in_file(view) + "-" + fill_layer;
        for (const VectorFill& fill : sheet.drawings[i].fills)
            writer.write(fill, place_of(view, size), {.layer = own, .tags = true});
    }
    write_own(writer, sheet.layout);    // over the areas
    auto layer = layers.layers.begin(); // one per group, in their order
    for (std::size_t i = 0; i < groups.size(); ++i)
        for (const LineGroup& group : groups[i])
            writer.write(group, place_of(sheet.layout.views[i], size),
                         {writing.curves, writing.fit_arcs},
                         {.layer = (layer++)->name, .tags = !sheet.drawings[i].travel});
    body.end_section();
    return dxf_file(std::move(body), size, std::array{writing.description});
}

} // namespace lineatlas
