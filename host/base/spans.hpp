#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lineatlas {

/// A part of a line, from one place along it to another.
struct Span {
    double from, to;
};

/// Sorts spans and joins those with less than `gap` between them.
inline void join_spans(std::vector<Span>& spans, double gap) {
    std::ranges::sort(spans, {}, &Span::from);
    std::size_t count = 0;
    for (const Span span : spans) {
        if (count > 0 && span.from - spans[count - 1].to < gap)
            spans[count - 1].to = std::max(spans[count - 1].to, span.to);
        else
            spans[count++] = span;
    }
    spans.resize(count);
}

} // namespace lineatlas
