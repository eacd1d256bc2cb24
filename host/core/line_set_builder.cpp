#include "line_set_builder.hpp"

#include <utility>

namespace lineatlas {

void LineSetBuilder::add(const std::vector<glm::vec3>& vertices, const std::vector<Line>& fixed,
                         const std::vector<Line>& candidates, float chain_angle) {
    std::vector<ChainEdge> to_chain;
    to_chain.reserve(fixed.size());
    for (const Line& line : fixed)
        to_chain.push_back({line.p, line.q, static_cast<std::uint32_t>(line.kind)});
    count_vertices(fixed);
    count_vertices(candidates);
    result.segments.reserve(fixed.size() + candidates.size());
    result.sources.reserve(fixed.size() + candidates.size());
    append_paths(fixed, chain_edges(vertices, to_chain, chain_angle));
    append_candidates(candidates);
}

void LineSetBuilder::count_vertices(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
        ++edges_at_vertex_[line.p];
        ++edges_at_vertex_[line.q];
    }
}

void LineSetBuilder::append(const Line& line, bool reversed, std::uint32_t from_start,
                            std::uint32_t to_end, bool closed) {
    std::uint32_t tag = static_cast<std::uint32_t>(line.kind);
    if (closed) tag |= LA_TAG_CLOSED;
    const bool alone = from_start == 0 && to_end == 0 && edges_at_vertex_[line.p] == 1 &&
                       edges_at_vertex_[line.q] == 1;
    if (alone) tag |= LA_TAG_LONE;
    result.segments.push_back({.p = reversed ? line.q : line.p,
                               .q = reversed ? line.p : line.q,
                               .face_a = line.face_a,
                               .face_b = line.face_b,
                               .from_start = from_start,
                               .to_end = to_end,
                               .path = result.path_count,
                               .tag = tag});
    LineSource source = line.source;
    if (reversed) std::swap(source.from, source.to);
    result.sources.push_back(source);
    ++result.kind_counts[static_cast<std::size_t>(line.kind)];
}

void LineSetBuilder::append_paths(const std::vector<Line>& lines,
                                  const std::vector<Chain>& chains) {
    for (const Chain& chain : chains) {
        const auto count = static_cast<std::uint32_t>(chain.steps.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const ChainStep step = chain.steps[i];
            append(lines[step.edge], step.reversed, i, count - 1 - i, chain.closed);
        }
        ++result.path_count;
    }
}

/// Which of them are silhouettes changes from frame to frame, so each is a path of its own (§4.1).
void LineSetBuilder::append_candidates(const std::vector<Line>& candidates) {
    for (const Line& line : candidates) {
        append(line, false, 0, 0, false);
        ++result.path_count;
    }
}

} // namespace lineatlas
