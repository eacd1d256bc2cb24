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

std::string tags_text(const VectorDrawing& drawing, const VectorPath& path) {
    std::vector<std::string> objects;
    std::vector<std::string> materials;
    std::string edges = path.kind == LineKind::intersection ? "triangles" : "edges";
    const VectorPiece* last = nullptr;
    for (const VectorPiece& piece : path.pieces) {
        if (last != nullptr && last->segment == piece.segment) continue;
        last = &piece;
        if (piece.group != VectorPiece::none) {
            add_once(objects, drawing.groups[piece.group].object);
            add_once(materials, drawing.groups[piece.group].material);
        }
        const LineSource& source = piece.source;
        edges += path.kind == LineKind::intersection
                     ? fmt::format(" {}x{}", source.triangle, source.crossing)
                     : fmt::format(" {}-{}", source.from, source.to);
    }
    return list("object", objects) + list("material", materials) + edges;
}

} // namespace lineatlas
