#include "lineatlas/assembly.hpp"

#include <algorithm>
#include <atomic>
#include <span>
#include <utility>

#include <glm/common.hpp>

#include "assembly_state.hpp"
#include "check_lines.hpp"
#include "lineatlas/error.hpp"
#include "objects_apart.hpp"
#include "shared/meshlet_table.h"

namespace lineatlas {
namespace {

constexpr std::size_t most_changes = 1U << 16U; // after more, readers take all tables anew

bool is_silhouette(const Segment& segment) {
    return (segment.tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE;
}

std::uint32_t count_of(std::size_t size) {
    return static_cast<std::uint32_t>(size);
}

template <class T>
std::span<T> in(std::vector<T>& table, PartRoom room) {
    return std::span{table}.subspan(room.first, room.size);
}
template <class T>
std::span<const T> in(const std::vector<T>& table, std::uint32_t first, std::uint32_t count) {
    return std::span{table}.subspan(first, count);
}

std::uint32_t shifted(std::uint32_t face, std::uint32_t by) {
    return face == LA_NO_FACE ? face : ((face & LA_FACE_INDEX) + by) | (face & LA_FACE_FLIPPED);
}

/// A segment for room without a part. It is a point at the first vertex; triangles in such room are
/// points there, too.
Segment empty_segment(bool candidate, std::uint32_t number) {
    const std::uint32_t face = candidate ? 0 : LA_NO_FACE;
    return {.p = 0,
            .q = 0,
            .face_a = face,
            .face_b = face, // the same on both sides: never a silhouette
            .from_start = 0,
            .to_end = 0,
            .path = number,
            .tag = static_cast<std::uint32_t>(candidate ? LA_KIND_SILHOUETTE : LA_KIND_CREASE)};
}

/// All members of PartRooms.
constexpr std::array tables{&PartRooms::vertices,   &PartRooms::triangles, &PartRooms::fixed,
                            &PartRooms::candidates, &PartRooms::replaced,  &PartRooms::faces,
                            &PartRooms::corners,    &PartRooms::edges,     &PartRooms::clusters};

/// The sizes that a part uses.
PartRooms sizes_of(const LineSet& part) {
    const auto silhouettes =
        count_of(static_cast<std::size_t>(std::ranges::count_if(part.segments, is_silhouette)));
    const Contours& contours = part.contours;
    const auto faces = count_of(contours.faces.size());
    const auto triangles = count_of(part.triangles.size());
    PartRooms sizes;
    sizes.vertices.size = count_of(part.vertices.size());
    sizes.triangles.size = triangles;
    sizes.fixed.size = count_of(part.segments.size()) - silhouettes;
    sizes.candidates.size = silhouettes - contours.replaced - faces;
    sizes.replaced.size = contours.replaced;
    sizes.faces.size = faces;
    sizes.corners.size = count_of(contours.corners.size());
    sizes.edges.size = count_of(contours.edges.size());
    sizes.clusters.size = (triangles + LA_MESHLET_TRIANGLES - 1) / LA_MESHLET_TRIANGLES;
    return sizes;
}

/// The sizes of the rooms that a part needs.
PartRooms sizes_for(const LineSet& part) {
    PartRooms sizes = sizes_of(part);
    ++sizes.vertices.size;
    if (sizes.edges.size > 0) ++sizes.edges.size;
    return sizes;
}

bool fits(const PartRooms& sizes, const PartRooms& rooms) {
    return std::ranges::all_of(
        tables, [&](auto table) { return (sizes.*table).size <= (rooms.*table).size; });
}

void add_sizes(PartRooms& sum, const PartRooms& sizes) {
    for (const auto table : tables) (sum.*table).size += (sizes.*table).size;
}

/// Fills a part's rooms, and changes what all parts have together.
class Layout {
  public:
    explicit Layout(AssemblyState& state) : state_(state) {}

    std::uint32_t add(const LineSet& part) {
        const PartRooms sizes = sizes_for(part);
        const auto gone = [](const AssemblyState::Part& one) { return !one.is_there; };
        auto place = std::ranges::find_if(
            state_.parts, [&](const auto& one) { return gone(one) && fits(sizes, one.rooms); });
        const bool has_place = place != state_.parts.end();
        if (!has_place) {
            // The rooms of a place that is too small stay unused until the next layout.
            place = std::ranges::find_if(state_.parts, gone);
            const bool is_next = place == state_.parts.end();
            if (!has_room(sizes, is_next ? 1 : 0)) lay_out(sizes);
            if (is_next) {
                state_.lines.objects.emplace_back();
                place = state_.parts.insert(state_.parts.end(), AssemblyState::Part{});
            } else {
                place = std::ranges::find_if(state_.parts, gone);
            }
            place->rooms = take(sizes);
        }
        const auto object = count_of(static_cast<std::size_t>(place - state_.parts.begin()));
        fill(object, part, numbers_of(part));
        note(object);
        return object;
    }

    /// Makes room for this many parts, whose sizes together are `sizes`, with one new layout at
    /// most.
    void make_room(const PartRooms& sizes, std::uint32_t parts) {
        if (!has_room(sizes, parts)) lay_out(sizes, parts);
    }

    void remove(std::uint32_t object) {
        AssemblyState::Part& part = state_.parts[object];
        for (const Segment& segment :
             in(state_.lines.segments, part.rooms.fixed.first, part.has.fixed.size))
            --state_.lines.kind_counts[segment.tag & LA_TAG_KIND_MASK];
        state_.lines.kind_counts[LA_KIND_SILHOUETTE] -=
            part.has.candidates.size + part.has.replaced.size + part.has.faces.size;
        part = {.rooms = part.rooms};
        empty(part.rooms);
        state_.lines.objects[object] = {};
        find_bounds();
        note(object);
    }

    /// Makes new tables for the present parts and for `parts` more, whose sizes together are
    /// `next`.
    void lay_out(const PartRooms& next, std::uint32_t parts = 1) {
        static std::atomic<std::uint64_t> last_layout{0};
        std::vector<std::pair<std::uint32_t, LineSet>> kept;
        PartRooms sum = next;
        for (std::uint32_t i = 0; i < state_.parts.size(); ++i) {
            if (!state_.parts[i].is_there) continue;
            kept.emplace_back(i, part_lines(state_, i));
            add_sizes(sum, sizes_for(kept.back().second));
        }
        LineSet& lines = state_.lines;
        // Empty rooms use the first vertex and the first triangle, and the first corner and the
        // first edge of contours if there are any.
        const std::uint32_t one = sum.faces.size > 0 ? 1 : 0;
        state_.used = {};
        state_.used.vertices.size = state_.used.triangles.size = state_.used.clusters.size = 1;
        state_.used.corners.size = state_.used.edges.size = one;
        add_sizes(sum, state_.used);
        const auto roomy = [](PartRoom room) {
            constexpr std::uint32_t least = 64;
            return room.size + room.size / 2 + least;
        };
        state_.first_candidate = roomy(sum.fixed);
        state_.cluster_count = roomy(sum.clusters);
        state_.object_room = roomy({.size = count_of(state_.parts.size()) + parts});
        lines.vertices.assign(roomy(sum.vertices), glm::vec3{0});
        lines.vertex_sources.assign(lines.vertices.size(), 0);
        lines.triangles.assign(roomy(sum.triangles), glm::uvec3{0});
        lines.triangle_sources.assign(lines.triangles.size(), 0);
        if (!lines.groups.empty()) lines.triangle_group.assign(lines.triangles.size(), 0);
        if (!lines.colors.empty())
            lines.triangle_color.assign(lines.triangles.size(), LineSet::no_color);
        state_.first_replaced = state_.first_candidate + roomy(sum.candidates);
        lines.contours = {};
        if (one > 0) {
            lines.contours.replaced = roomy(sum.replaced);
            lines.contours.faces.resize(roomy(sum.faces));
            lines.contours.corners.resize(roomy(sum.corners));
            lines.contours.edges.resize(roomy(sum.edges));
        }
        state_.first_face = state_.first_replaced + lines.contours.replaced;
        lines.segments.resize(state_.first_face + lines.contours.faces.size());
        lines.sources.assign(lines.segments.size(), LineSource{});
        lines.path_count = count_of(lines.segments.size());
        lines.kind_counts = {};
        for (std::uint32_t i = 0; i < lines.segments.size(); ++i)
            lines.segments[i] = empty_segment(i >= state_.first_candidate, i);
        for (AssemblyState::Part& part : state_.parts) part = {};
        state_.layout = ++last_layout;
        state_.changes.clear();
        for (const auto& [object, part] : kept) {
            state_.parts[object].rooms = take(sizes_for(part));
            fill(object, part, {part.triangle_group, part.triangle_color});
        }
    }

  private:
    /// The groups and colours of a part's triangles as numbers in the tables of all parts.
    struct Numbers {
        std::vector<std::uint32_t> groups;
        std::vector<std::uint16_t> colors;
    };

    bool has_room(const PartRooms& sizes, std::uint32_t parts) const {
        const LineSet& lines = state_.lines;
        if (state_.parts.size() + parts > state_.object_room) return false;
        PartRooms sum = state_.used;
        add_sizes(sum, sizes);
        return sum.vertices.size <= lines.vertices.size() &&
               sum.triangles.size <= lines.triangles.size() &&
               sum.fixed.size <= state_.first_candidate &&
               sum.candidates.size <= state_.first_replaced - state_.first_candidate &&
               sum.replaced.size <= lines.contours.replaced &&
               sum.faces.size <= lines.contours.faces.size() &&
               sum.corners.size <= lines.contours.corners.size() &&
               sum.edges.size <= lines.contours.edges.size() &&
               sum.clusters.size <= state_.cluster_count;
    }

    PartRooms take(PartRooms sizes) {
        for (const auto table : tables) (sizes.*table).first = (state_.used.*table).size;
        add_sizes(state_.used, sizes);
        return sizes;
    }

    Numbers numbers_of(const LineSet& part) {
        Numbers result{part.triangle_group, part.triangle_color};
        LineSet& lines = state_.lines;
        std::vector<std::uint32_t> groups;
        for (const MeshGroup& group : part.groups) groups.push_back(number_of(group));
        for (std::uint32_t& group : result.groups) group = groups[group];
        if (result.groups.empty() && !lines.groups.empty())
            result.groups.assign(part.triangles.size(), number_of(MeshGroup{}));
        std::vector<std::uint16_t> colors;
        for (const glm::vec3& color : part.colors) colors.push_back(number_of(color));
        for (std::uint16_t& color : result.colors)
            if (color != LineSet::no_color) color = colors[color];
        if (!lines.groups.empty() && lines.triangle_group.empty())
            lines.triangle_group.assign(lines.triangles.size(), number_of(MeshGroup{}));
        if (!lines.colors.empty() && lines.triangle_color.empty())
            lines.triangle_color.assign(lines.triangles.size(), LineSet::no_color);
        return result;
    }

    std::uint32_t number_of(const MeshGroup& group) {
        std::optional<std::array<float, 3>> color;
        if (group.color) color = {group.color->x, group.color->y, group.color->z};
        const auto next = count_of(state_.lines.groups.size());
        const auto [found, is_new] =
            state_.groups.emplace(std::tuple{group.object, group.material, color}, next);
        if (is_new) state_.lines.groups.push_back(group);
        return found->second;
    }

    std::uint16_t number_of(glm::vec3 color) {
        const std::array key{color.x, color.y, color.z};
        const auto found = state_.colors.find(key);
        if (found != state_.colors.end()) return found->second;
        const std::size_t next = state_.lines.colors.size();
        if (next >= LineSet::no_color) return LineSet::no_color;
        state_.lines.colors.push_back(color);
        return state_.colors[key] = static_cast<std::uint16_t>(next);
    }

    void fill(std::uint32_t object, const LineSet& part, const Numbers& numbers) {
        AssemblyState::Part& own = state_.parts[object];
        const PartRooms rooms = own.rooms;
        empty(rooms);
        LineSet& lines = state_.lines;
        const std::uint32_t vertex = rooms.vertices.first, triangle = rooms.triangles.first;
        std::ranges::copy(part.vertices, lines.vertices.begin() + vertex);
        std::ranges::copy(part.vertex_sources, lines.vertex_sources.begin() + vertex);
        std::ranges::transform(part.triangles, lines.triangles.begin() + triangle,
                               [&](glm::uvec3 t) { return t + vertex; });
        std::ranges::copy(part.triangle_sources, lines.triangle_sources.begin() + triangle);
        if (!numbers.groups.empty())
            std::ranges::copy(numbers.groups, lines.triangle_group.begin() + triangle);
        if (!numbers.colors.empty())
            std::ranges::copy(numbers.colors, lines.triangle_color.begin() + triangle);
        const std::size_t first_face = part.segments.size() - part.contours.faces.size();
        const std::size_t first_replaced = first_face - part.contours.replaced;
        std::array<PartRoom, 4> free = segment_rooms(state_, rooms);
        for (std::size_t i = 0; i < part.segments.size(); ++i) {
            Segment segment = part.segments[i];
            const std::size_t table = i >= first_face          ? 3
                                      : i >= first_replaced    ? 2
                                      : is_silhouette(segment) ? 1
                                                               : 0;
            const std::uint32_t at = free[table].first++;
            segment.p += vertex;
            segment.q += vertex;
            segment.face_a = shifted(segment.face_a, triangle);
            segment.face_b = shifted(segment.face_b, triangle);
            segment.path = at - segment.from_start; // a number of no other path
            lines.segments[at] = segment;
            lines.sources[at] = part.sources[i];
            ++lines.kind_counts[segment.tag & LA_TAG_KIND_MASK];
        }
        fill_contours(rooms, part.contours);
        own = {.rooms = rooms, .is_there = true, .has = sizes_of(part)};
        for (const glm::vec3& v : part.vertices) {
            own.box.min = glm::min(own.box.min, v);
            own.box.max = glm::max(own.box.max, v);
        }
        lines.objects[object] = {part.objects.empty() ? "" : part.objects.front().name, vertex,
                                 own.has.vertices.size};
        find_bounds();
    }

    void fill_contours(const PartRooms& rooms, const Contours& part) {
        Contours& all = state_.lines.contours;
        std::ranges::transform(part.corners, all.corners.begin() + rooms.corners.first,
                               [&](ContourCorner corner) {
                                   corner.vertex += rooms.vertices.first;
                                   return corner;
                               });
        std::ranges::transform(part.edges, all.edges.begin() + rooms.edges.first,
                               [&](glm::uvec2 edge) { return edge + rooms.corners.first; });
        std::ranges::transform(part.faces, all.faces.begin() + rooms.faces.first,
                               [&](glm::uvec3 face) { return face + rooms.edges.first; });
    }

    void empty(const PartRooms& rooms) {
        LineSet& lines = state_.lines;
        std::ranges::fill(in(lines.triangles, rooms.triangles), glm::uvec3{0});
        for (const PartRoom& room : segment_rooms(state_, rooms)) {
            std::uint32_t number = room.first;
            for (Segment& segment : in(lines.segments, room)) {
                segment = empty_segment(number >= state_.first_candidate, number);
                ++number;
            }
            std::ranges::fill(in(lines.sources, room), LineSource{});
        }
        std::ranges::fill(in(lines.contours.corners, rooms.corners), ContourCorner{});
        std::ranges::fill(in(lines.contours.edges, rooms.edges), glm::uvec2{0});
        std::ranges::fill(in(lines.contours.faces, rooms.faces), glm::uvec3{0});
    }

    void find_bounds() {
        Bounds& bounds = state_.lines.bounds;
        bounds = {};
        for (const AssemblyState::Part& part : state_.parts) {
            bounds.min = glm::min(bounds.min, part.box.min);
            bounds.max = glm::max(bounds.max, part.box.max);
        }
    }

    void note(std::uint32_t object) {
        if (state_.changes.size() == most_changes) lay_out({});
        state_.changes.push_back({object, state_.parts[object].rooms});
    }

    AssemblyState& state_;
};

} // namespace

LineSet part_lines(const AssemblyState& state, std::uint32_t object) {
    const AssemblyState::Part& own = state.parts[object];
    const LineSet& lines = state.lines;
    const std::uint32_t vertex = own.rooms.vertices.first, triangle = own.rooms.triangles.first;
    const auto copy = [](const auto& table, std::uint32_t first, std::uint32_t count, auto& to) {
        if (table.empty()) return;
        const std::span part = in(table, first, count);
        to.insert(to.end(), part.begin(), part.end());
    };
    LineSet part;
    const std::uint32_t vertices = own.has.vertices.size, triangles = own.has.triangles.size;
    copy(lines.vertices, vertex, vertices, part.vertices);
    copy(lines.vertex_sources, vertex, vertices, part.vertex_sources);
    copy(lines.triangles, triangle, triangles, part.triangles);
    copy(lines.triangle_sources, triangle, triangles, part.triangle_sources);
    copy(lines.triangle_group, triangle, triangles, part.triangle_group);
    copy(lines.triangle_color, triangle, triangles, part.triangle_color);
    const std::array<PartRoom, 4> rooms = segment_rooms(state, own.rooms);
    const std::array counts{own.has.fixed.size, own.has.candidates.size, own.has.replaced.size,
                            own.has.faces.size};
    for (std::size_t i = 0; i < rooms.size(); ++i) {
        copy(lines.segments, rooms[i].first, counts[i], part.segments);
        copy(lines.sources, rooms[i].first, counts[i], part.sources);
    }
    Contours& contours = part.contours;
    copy(lines.contours.corners, own.rooms.corners.first, own.has.corners.size, contours.corners);
    copy(lines.contours.edges, own.rooms.edges.first, own.has.edges.size, contours.edges);
    copy(lines.contours.faces, own.rooms.faces.first, own.has.faces.size, contours.faces);
    contours.replaced = own.has.replaced.size;
    for (ContourCorner& corner : contours.corners) corner.vertex -= vertex;
    for (glm::uvec2& edge : contours.edges) edge -= own.rooms.corners.first;
    for (glm::uvec3& face : contours.faces) face -= own.rooms.edges.first;
    for (glm::uvec3& t : part.triangles) t -= vertex;
    for (Segment& segment : part.segments) {
        segment.p -= vertex;
        segment.q -= vertex;
        segment.face_a = shifted(segment.face_a, 0U - triangle);
        segment.face_b = shifted(segment.face_b, 0U - triangle);
    }
    part.objects = {{lines.objects[object].name, 0, vertices}};
    part.bounds = own.box;
    return part;
}

Assembly::Assembly() : state_(std::make_unique<AssemblyState>()) {
    Layout{*state_}.lay_out({});
}
Assembly::~Assembly() = default;
Assembly::Assembly(Assembly&&) noexcept = default;
Assembly& Assembly::operator=(Assembly&&) noexcept = default;

std::vector<std::uint32_t> Assembly::add(const LineSet& lines) {
    check_lines(lines);
    Layout layout{*state_};
    if (lines.objects.empty()) return {layout.add(lines)};
    std::vector<std::uint32_t> numbers;
    const std::vector<LineSet> parts = objects_apart(lines);
    PartRooms sum;
    for (const LineSet& part : parts) add_sizes(sum, sizes_for(part));
    layout.make_room(sum, count_of(parts.size()));
    for (const LineSet& part : parts) numbers.push_back(layout.add(part));
    return numbers;
}

void Assembly::remove(std::uint32_t object) {
    if (object >= state_->parts.size() || !state_->parts[object].is_there) {
        throw UsageError("assembly: there is no part " + std::to_string(object) + " to remove");
    }
    Layout{*state_}.remove(object);
}

const LineSet& Assembly::lines() const {
    return state_->lines;
}

} // namespace lineatlas
