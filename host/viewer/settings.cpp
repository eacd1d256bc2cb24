#include "settings.hpp"

#include "lineatlas/style_files.hpp"

namespace lineatlas::viewer {

bool same(const Settings& a, const Settings& b) {
    return a.sides == b.sides && a.split == b.split && a.split_at == b.split_at &&
           a.lines == b.lines && a.style_name == b.style_name && a.shown == b.shown &&
           a.steady == b.steady && a.exact_at_rest == b.exact_at_rest &&
           a.bookmarks == b.bookmarks && a.distances == b.distances &&
           write_style(a.style) == write_style(b.style);
}

} // namespace lineatlas::viewer
