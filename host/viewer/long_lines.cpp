#include "long_lines.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace lineatlas::viewer {
namespace {

bool may_be_silhouette(const Segment& segment) {
    return (segment.tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE;
}

} // namespace

LineSet long_lines(const LineSet& lines, const Camera& camera, float pixels) {
    const glm::mat4 clip_from_world = camera.clip_from_world();
    // Pixels per unit of length seen from the side, times w.
    const float scale = 0.5F * camera.projection[1][1] * static_cast<float>(camera.size.y);
    const auto nearness = [&](std::uint32_t vertex) {
        return (clip_from_world * glm::vec4{lines.vertices[vertex], 1}).w;
    };
    LineSet result = lines;
    result.segments.clear();
    result.sources.clear();
    const std::vector<Segment>& all = lines.segments;
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
        const Segment& start = all[first];
        const bool stays = may_be_silhouette(start);
        float length = 0, nearest = nearness(start.p);
        for (end = first; end < all.size(); ++end) {
            const Segment& segment = all[end];
            const bool same = stays ? may_be_silhouette(segment) : segment.path == start.path;
            if (!same) break;
            if (stays) continue;
            length += glm::distance(lines.vertices[segment.p], lines.vertices[segment.q]);
            nearest = std::min(nearest, nearness(segment.q));
        }
        if (!stays && nearest > 0 && length * scale < pixels * nearest) {
            for (std::size_t i = first; i < end; ++i)
                --result.kind_counts.at(all[i].tag & LA_TAG_KIND_MASK);
            continue;
        }
        const auto from = static_cast<std::ptrdiff_t>(first), to = static_cast<std::ptrdiff_t>(end);
        result.segments.insert(result.segments.end(), all.begin() + from, all.begin() + to);
        result.sources.insert(result.sources.end(), lines.sources.begin() + from,
                              lines.sources.begin() + to);
    }
    return result;
}

} // namespace lineatlas::viewer
