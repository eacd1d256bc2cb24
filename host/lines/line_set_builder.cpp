#include "line_set_builder.hpp"

#include <utility>

#include "base/parallel.hpp"

namespace lineatlas {

void LineSetBuilder::add(const std::vector<glm::vec3>& vertices, const std::vector<Line>& fixed,
                         const std::vector<Line>& candidates, float chain_angle) {
    std::vector<ChainEdge> to_chain;
    to_chain.reserve(fixed.size());
    for (const Line& line : fixed)
        to_chain.push_back({line.p, line.q, static_cast<std::uint32_t>(line.kind)});
    count_vertices(fixed);
    count_vertices(candidates);
    result.segments.resize(fixed.size() + candidates.size());
    result.sources.resize(fixed.size() + candidates.size());
    const Chains chains = chain_edges(vertices, to_chain, chain_angle);
    to_chain = std::vector<ChainEdge>{};
    put_paths(fixed, chains);
    result.path_count = static_cast<std::uint32_t>(chains.size());
    put_candidates(candidates, fixed.size());
}

void LineSetBuilder::count_vertices(const std::vector<Line>& lines) {
    for_each_index(lines.size(), [&](std::size_t i) {
        for (const std::uint32_t vertex : {lines[i].p, lines[i].q})
            edges_at_vertex_[vertex].fetch_add(1, std::memory_order_relaxed);
    });
    for (const Line& line : lines) ++result.kind_counts[static_cast<std::size_t>(line.kind)];
}

bool LineSetBuilder::is_alone(const Line& line) const {
    return edges_at_vertex_[line.p].load(std::memory_order_relaxed) == 1 &&
           edges_at_vertex_[line.q].load(std::memory_order_relaxed) == 1;
}

void LineSetBuilder::put(std::size_t i, const Line& line, bool reversed, const PathPlace& place) {
    std::uint32_t tag = static_cast<std::uint32_t>(line.kind);
    if (place.closed) tag |= LA_TAG_CLOSED;
    if (place.before == 0 && place.behind == 0 && is_alone(line)) tag |= LA_TAG_LONE;
    result.segments[i] = {.p = reversed ? line.q : line.p,
                          .q = reversed ? line.p : line.q,
                          .face_a = line.face_a,
                          .face_b = line.face_b,
                          .from_start = place.before,
                          .to_end = place.behind,
                          .path = place.path,
                          .tag = tag};
    LineSource source = line.source;
    if (reversed) std::swap(source.from, source.to);
    result.sources[i] = source;
}

void LineSetBuilder::put_paths(const std::vector<Line>& lines, const Chains& chains) {
    const ChainStep* const first = chains.size() > 0 ? chains[0].steps.data() : nullptr;
    for_each_index(chains.size(), [&](std::size_t path) {
        const auto [steps, closed] = chains[path];
        const auto count = static_cast<std::uint32_t>(steps.size());
        PathPlace place{.path = static_cast<std::uint32_t>(path), .closed = closed};
        for (; place.before < count; ++place.before) {
            const ChainStep& step = steps[place.before];
            place.behind = count - 1 - place.before;
            put(static_cast<std::size_t>(&step - first), lines[step.edge], step.reversed, place);
        }
    });
}

/// Puts candidates into the table. The silhouettes among them change from frame to frame, so each
/// candidate is a path of its own (§4.1).
void LineSetBuilder::put_candidates(const std::vector<Line>& candidates, std::size_t first) {
    for_each_index(candidates.size(), [&](std::size_t i) {
        const std::uint32_t path = result.path_count + static_cast<std::uint32_t>(i);
        put(first + i, candidates[i], false, {.path = path});
    });
    result.path_count += static_cast<std::uint32_t>(candidates.size());
}

} // namespace lineatlas
