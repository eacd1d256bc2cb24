#include "tags.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/core.h>

namespace lineatlas {
namespace {

void add_once(std::vector<std::string>& names, const std::string& name) {
    if (name.empty() || std::ranges::find(names, name) != names.end()) return;
    names.push_back(name);
}

std::string list(const char* what, const std::vector<std::string>& names) {
    if (names.empty()) return {};
    std::string text = what;
    for (const std::string& name : names) {
        text += &name == names.data() ? " " : ", ";
        text += name;
    }
    return text + "; ";
}

} // namespace

std::vector<std::string> entities_of(const VectorPath& path) {
    std::vector<std::string> entities;
    for (const VectorPiece& piece : path.pieces)
        if (piece.entity != 0) add_once(entities, fmt::format("#{}", piece.entity));
    return entities;
}

std::string tags_text(const VectorDrawing& drawing, const VectorPath& path) {
    std::vector<std::string> objects;
    std::vector<std::string> materials;
    std::string edges, triangles; // of smooth silhouettes, of intersections, ridges and valleys
    const VectorPiece* last = nullptr;
    for (const VectorPiece& piece : path.pieces) {
        if (last != nullptr && last->segment == piece.segment) continue;
        last = &piece;
        if (piece.group != VectorPiece::none) {
            add_once(objects, drawing.groups[piece.group].object);
            add_once(materials, drawing.groups[piece.group].material);
        }
        const LineSource& source = piece.source;
        if (source.crossing != LineSource::none)
            triangles += fmt::format(" {}x{}", source.triangle, source.crossing);
        else if (source.from != LineSource::none)
            edges += fmt::format(" {}-{}", source.from, source.to);
        else if (source.triangle != LineSource::none)
            triangles += fmt::format(" {}", source.triangle);
    }
    std::string text =
        list("object", objects) + list("material", materials) + list("entity", entities_of(path));
    if (!triangles.empty()) text += "triangles" + triangles;
    if (!edges.empty()) text += (triangles.empty() ? "edges" : "; edges") + edges;
    return text;
}

} // namespace lineatlas
