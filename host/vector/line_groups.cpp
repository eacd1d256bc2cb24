#include "line_groups.hpp"

#include <algorithm>

namespace lineatlas {

std::string LineGroup::name() const {
    const std::string own{line_kind_names[static_cast<std::size_t>(kind)]};
    return visible ? own : own + "-hidden";
}

std::vector<LineGroup> line_groups(const VectorDrawing& drawing) {
    std::vector<LineGroup> groups;
    for (auto first = drawing.paths.begin(); first != drawing.paths.end();) {
        const auto last = std::find_if_not(first, drawing.paths.end(), [&](const VectorPath& path) {
            return path.kind == first->kind && path.visible == first->visible;
        });
        groups.push_back({first->kind, first->visible, {first, last}});
        first = last;
    }
    return groups;
}

} // namespace lineatlas
