#include "line_groups.hpp"

#include <algorithm>

#include "core/line_pens.hpp"

namespace lineatlas {

std::string_view LineGroup::kind_name() const {
    return outline ? outline_name : line_kind_names[static_cast<std::size_t>(kind)];
}

std::string LineGroup::name() const {
    std::string own{kind_name()};
    if (!visible) own += "-hidden";
    if (thinned) own += "-thinned";
    return number > 1 ? own + "-" + std::to_string(number) : own;
}

namespace {

const Pen& pen_of(const VectorDrawing& drawing, const VectorPath& path) {
    if (!path.visible)
        return path.pen == 0 ? drawing.style.hidden_pen : drawing.hidden_pens.at(path.pen);
    return path.pen == 0 ? drawing.style.pen : drawing.pens.at(path.pen);
}

} // namespace

std::vector<LineGroup> line_groups(const VectorDrawing& drawing) {
    std::vector<LineGroup> groups;
    for (auto first = drawing.paths.begin(); first != drawing.paths.end();) {
        const auto is_alike = [&](const VectorPath& path) {
            return path.visible == first->visible && path.outline == first->outline &&
                   path.thinned == first->thinned && path.pen == first->pen &&
                   (path.outline || path.kind == first->kind);
        };
        const auto last = std::find_if_not(first, drawing.paths.end(), is_alike);
        LineGroup group{.kind = first->kind,
                        .visible = first->visible,
                        .outline = first->outline,
                        .thinned = first->thinned,
                        .number = 1,
                        .pen = pen_of(drawing, *first),
                        .paths = {first, last}};
        group.number += static_cast<unsigned>(std::ranges::count_if(groups, [&](const auto& own) {
            return own.visible == group.visible && own.thinned == group.thinned &&
                   own.kind_name() == group.kind_name();
        }));
        groups.push_back(group);
        first = last;
    }
    return groups;
}

} // namespace lineatlas
