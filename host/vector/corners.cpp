#include "corners.hpp"

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "core/plane_vectors.hpp"
#include "shared/constants.h"

namespace lineatlas {
namespace {

constexpr double longest = 1;        ///< pixels
constexpr double least_slope = 1e-3; ///< of a line that goes behind a face and not along it

class Corners {
  public:
    Corners(const LineSet& lines, const Camera& camera, const Pieces& pieces)
        : lines_(lines), pieces_(pieces), eye_(camera.eye()),
          clip_from_world_(glm::dmat4{camera.projection} * glm::dmat4{camera.view}),
          size_(camera.size) {}

    /// Whether piece i is short, begins (or ends) at a corner, and goes on hidden at its other end.
    bool may_be_hidden(std::size_t i, bool from_start) const {
        const Piece& piece = pieces_.list[i];
        const PieceEnd &corner = from_start ? piece.start : piece.end,
                       &other = from_start ? piece.end : piece.start;
        if (!piece.visible || !at_vertex(corner.kind) || other.kind != LA_END_HIDDEN) return false;
        if (is_contour(lines_, piece.segment) || pieces_.length(piece) > longest) return false;
        const std::size_t next = from_start ? i + 1 : i - 1;
        return next < pieces_.list.size() && pieces_.list[next].screen == piece.screen &&
               !pieces_.list[next].visible;
    }

    void add(std::size_t i, bool from_start) { candidates_[corner_of(i, from_start)] = {}; }

    /// Once all are added.
    void find_faces() {
        if (candidates_.empty()) return;
        std::vector<bool> is_curved(lines_.triangles.size(), false);
        for (std::size_t i = lines_.segments.size() - lines_.contours.faces.size();
             i < lines_.segments.size(); ++i)
            is_curved[lines_.segments[i].face_a] = true;
        for (std::uint32_t t = 0; t < lines_.triangles.size(); ++t) {
            if (is_curved[t]) continue;
            for (int k = 0; k < 3; ++k)
                if (const auto found = candidates_.find(lines_.triangles[t][k]);
                    found != candidates_.end())
                    found->second.push_back(t);
        }
    }

    bool is_hidden(std::size_t i, bool from_start) const {
        const Piece& piece = pieces_.list[i];
        const Segment& segment = lines_.segments[piece.segment];
        const std::uint32_t corner = corner_of(i, from_start);
        const glm::dvec3 from = place(corner),
                         way = place(corner == segment.p ? segment.q : segment.p) - from;
        const glm::dvec2 middle = pieces_.point(piece, 0.5 * (piece.start.t + piece.end.t)).at;
        for (const std::uint32_t t : candidates_.at(corner)) {
            if (t == segment.face_a || t == (segment.face_b & LA_FACE_INDEX)) continue;
            if (goes_behind(t, from, way) && covers(t, corner, middle)) return true;
        }
        return false;
    }

  private:
    std::uint32_t corner_of(std::size_t i, bool from_start) const {
        const Segment& segment = lines_.segments[pieces_.list[i].segment];
        return from_start ? segment.p : segment.q;
    }

    glm::dvec3 place(std::uint32_t vertex) const { return lines_.vertices[vertex]; }

    bool goes_behind(std::uint32_t triangle, glm::dvec3 from, glm::dvec3 way) const {
        const glm::uvec3 t = lines_.triangles[triangle];
        glm::dvec3 normal = glm::cross(place(t.y) - place(t.x), place(t.z) - place(t.x));
        if (glm::dot(normal, glm::dvec3{eye_} - from * double{eye_.w}) < 0) normal = -normal;
        return glm::dot(normal, way) < -least_slope * glm::length(normal) * glm::length(way);
    }

    /// Whether the angle of a triangle at its corner holds a place on the screen.
    bool covers(std::uint32_t triangle, std::uint32_t corner, glm::dvec2 at) const {
        glm::uvec3 t = lines_.triangles[triangle];
        while (t.x != corner) t = {t.y, t.z, t.x};
        const glm::dvec2 a = on_screen(t.x), b = on_screen(t.y) - a, c = on_screen(t.z) - a;
        const double area = cross(b, c), to_b = cross(b, at - a) / area,
                     to_c = cross(at - a, c) / area;
        return to_b > 0 && to_c > 0 && to_b + to_c < 1;
    }

    glm::dvec2 on_screen(std::uint32_t vertex) const {
        const glm::dvec4 clip = clip_from_world_ * glm::dvec4{place(vertex), 1};
        return {0.5 * size_.x * (1 + clip.x / clip.w), 0.5 * size_.y * (1 - clip.y / clip.w)};
    }

    const LineSet& lines_;
    const Pieces& pieces_;
    glm::dvec4 eye_;
    glm::dmat4 clip_from_world_;
    glm::dvec2 size_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> candidates_; ///< flat faces
};

} // namespace

void hide_beyond_corners(const LineSet& lines, const Camera& camera, Pieces& pieces) {
    if (!pieces.exact || !(lines.precision > 0)) return;
    Corners corners{lines, camera, pieces};
    std::vector<std::pair<std::size_t, bool>> found;
    for (std::size_t i = 0; i < pieces.list.size(); ++i)
        for (const bool from_start : {true, false})
            if (corners.may_be_hidden(i, from_start)) {
                corners.add(i, from_start);
                found.emplace_back(i, from_start);
            }
    corners.find_faces();
    std::vector<bool> gone(pieces.list.size(), false);
    for (const auto& [i, from_start] : found) {
        if (gone[i] || !corners.is_hidden(i, from_start)) continue;
        const Piece& piece = pieces.list[i];
        if (from_start)
            pieces.list[i + 1].start = piece.start;
        else
            pieces.list[i - 1].end = piece.end;
        gone[i] = true;
    }
    std::size_t next = 0;
    std::erase_if(pieces.list, [&](const Piece&) { return gone[next++]; });
}

} // namespace lineatlas
