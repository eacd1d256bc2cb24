#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// A piece of a table that belongs to one part.
struct PartRoom {
    std::uint32_t first = 0;
    std::uint32_t size = 0;
    bool operator==(const PartRoom&) const = default;
};

/// The pieces of all tables that belong to one part.
struct PartRooms {
    PartRoom vertices;   ///< one more than it has, so that its last one's lists have an end
    PartRoom triangles;  ///< as many as it has
    PartRoom fixed;      ///< of LineSet::segments
    PartRoom candidates; ///< the same, silhouettes; counted from the first of all
    PartRoom replaced;   ///< the same, those that contours stand for
    PartRoom faces;      ///< the same, contours; of Contours::faces
    PartRoom corners;    ///< of Contours::corners
    PartRoom edges;      ///< of Contours::edges; one more than it has, as of vertices
    PartRoom clusters;   ///< of SceneBuffers
    bool operator==(const PartRooms&) const = default;
};

/// What an Assembly consists of.
struct AssemblyState {
    struct Part {
        PartRooms rooms{}; ///< kept when it is gone, for one that fits
        bool is_there = false;
        PartRooms has{}; ///< sizes only, what of them it uses
        Bounds box{};
    };
    /// A part that has come, gone or both.
    struct Change {
        std::uint32_t object;
        PartRooms rooms; ///< that it had then
    };

    LineSet lines;
    std::vector<Part> parts; ///< as LineSet::objects
    PartRooms used{};        ///< sizes only: what is given away of each table
    /// Of LineSet::segments: fixed lines come first, contours last.
    std::uint32_t first_candidate = 0, first_replaced = 0, first_face = 0;
    std::uint32_t cluster_count = 0, object_room = 0;
    /// Of this layout of the tables, which no other assembly has; after another one nothing is
    /// where it was.
    std::uint64_t layout = 0;
    std::vector<Change> changes{}; ///< since then

    std::map<std::array<float, 3>, std::uint16_t> colors{};
    using GroupKey = std::tuple<std::string, std::string, std::optional<std::array<float, 3>>>;
    std::map<GroupKey, std::uint32_t> groups{};
};

/// Rooms as they lie in LineSet::segments: of fixed lines, candidates, those that are replaced, and
/// contours.
inline std::array<PartRoom, 4> segment_rooms(const AssemblyState& state, const PartRooms& rooms) {
    const auto from = [](std::uint32_t first, PartRoom room) {
        return PartRoom{.first = first + room.first, .size = room.size};
    };
    return {rooms.fixed, from(state.first_candidate, rooms.candidates),
            from(state.first_replaced, rooms.replaced), from(state.first_face, rooms.faces)};
}

/// A part by itself: its indices count from 0, its segments are its fixed ones, then candidates.
/// Of groups and colours it has numbers of the whole.
LineSet part_lines(const AssemblyState& state, std::uint32_t object);

} // namespace lineatlas
